//! Raw bindings of the AGAA SDK: the functions, structs and constants of its C headers, with their names in C.
//! The headers and the guides in docs/integration describe them.
//!
//! `Default` of a struct calls its function `agaaInit…`, which sets `sType`, `structSize` and the defaults of
//! `AGAA_…_INIT`. Structs without such a function are zeros.
#![allow(non_camel_case_types, non_snake_case)]

/// Implements Default by the function of the library that initialises the struct.
macro_rules! defaults {
    ($name:ident, $init:ident) => {
        impl Default for $name {
            fn default() -> Self {
                // Zeros are valid values of all members.
                let mut value = unsafe { core::mem::zeroed() };
                unsafe { $init(&mut value, core::mem::size_of::<Self>()) };
                value
            }
        }
    };
}

/// Implements Default for a struct without structSize, whose function takes no size.
macro_rules! defaults_without_size {
    ($name:ident, $init:ident) => {
        impl Default for $name {
            fn default() -> Self {
                // Zeros are valid values of all members.
                let mut value = unsafe { core::mem::zeroed() };
                unsafe { $init(&mut value) };
                value
            }
        }
    };
}

/// Implements Default for a struct that no function initialises.
macro_rules! zeros {
    ($name:ident) => {
        impl Default for $name {
            fn default() -> Self {
                // Zeros are valid values of all members.
                unsafe { core::mem::zeroed() }
            }
        }
    };
}

mod generated;
pub use generated::*;
