"""Writes the Rust crate agaa-sys from the description of the C ABI, for tools/generate_bindings.py."""

CRATE = "bindings/rust/agaa-sys"
SCALARS = {"void": "c_void", "char": "c_char", "int": "c_int", "float": "f32", "double": "f64", "uint32_t": "u32",
           "int32_t": "i32", "uint64_t": "u64", "int64_t": "i64", "size_t": "usize", "AgaaResult": "AgaaResult"}
KEYWORDS = set("as async await box break const continue do dyn else enum extern final fn for if impl in let loop macro "
               "match mod move mut override priv pub ref return static struct trait try type typeof unsafe unsized use "
               "virtual where while yield abstract become".split())
COLUMNS = 100  # as rustfmt


def identifier(name):
    return f"r#{name}" if name in KEYWORDS else name


def is_constant(target):
    """Says whether a pointer to the C type `target` may only read."""
    return target.endswith(" const") if "*" in target else target.startswith("const ")


def type_name(name):
    """Returns the Rust type of a C type."""
    name = name.removesuffix(" const")
    target = name[:-2] if name.endswith("[]") else name[:-1] if name.endswith("*") else None
    if target is not None:
        return f"*{'const' if is_constant(target) else 'mut'} {type_name(target)}"
    name = name.removeprefix("const ")
    return SCALARS.get(name, name)


def member_type(member):
    kind = type_name(member["type"])
    for length in reversed(member.get("lengths", [])):
        kind = f"[{kind}; {length}]"
    return kind


def call(start, signature, end, indent=""):
    """Returns a function or the type of one, on one line if it fits."""
    parameters = [f"{identifier(each['name'])}: {type_name(each['type'])}" for each in signature["parameters"]]
    returned = "" if signature["returns"] == "void" else f" -> {type_name(signature['returns'])}"
    line = f"{indent}{start}({', '.join(parameters)}){returned}{end}"
    if len(line) <= COLUMNS:
        return line
    lines = "".join(f"{indent}    {parameter},\n" for parameter in parameters)
    return f"{indent}{start}(\n{lines}{indent}){returned}{end}"


def constants(description):
    yield from (f"pub const {name}: {SCALARS[description['constantTypes'][name]]} = {value};"
                for name, value in description["constants"].items())
    yield "/// The version that the library's agaaGetVersion returns if it is that of this crate."
    yield "pub const AGAA_HEADER_VERSION: u32 ="
    yield "    AGAA_VERSION_MAJOR << 22 | AGAA_VERSION_MINOR << 12 | AGAA_VERSION_PATCH;"


def enums(description):
    yield "/// AgaaResultCode, or a value of a later library."
    yield "pub type AgaaResult = i32;"
    for enum, values in description["enums"].items():
        yield ""
        yield f"pub type {enum} = {'i32' if min(values.values()) < 0 else 'u32'};"
        # Values MAX_ENUM only give enumerations of C their size.
        yield from (f"pub const {name}: {enum} = {value};" for name, value in values.items() if not name.endswith("_MAX_ENUM"))


def handles(description):
    for name in description["handles"]:
        yield from ("#[repr(C)]", f"pub struct {name}_T {{", "    _private: [u8; 0],",
                    "    _marker: PhantomData<(*mut u8, PhantomPinned)>,", "}", f"pub type {name} = *mut {name}_T;")


def callbacks(description):
    for name, callback in description["callbacks"].items():
        # The line breaks of rustfmt: none, before Option, or around each parameter.
        function = 'unsafe extern "C" fn'
        line = call(f"pub type {name} = Option<{function}", callback, ">;")
        below = call(f"Option<{function}", callback, ">;", "    ")
        if "\n" not in line:
            yield line
        elif "\n" not in below:
            yield f"pub type {name} =\n{below}"
        else:
            yield f"pub type {name} = Option<\n{call(function, callback, ',', '    ')}\n>;"


def structs(description):
    for name, struct in description["structs"].items():
        yield from ("", "#[repr(C)]", "#[derive(Clone, Copy, Debug)]", f"pub struct {name} {{")
        yield from (f"    pub {identifier(member['name'])}: {member_type(member)}," for member in struct["members"])
        yield "}"


def defaults(description):
    functions = {function["name"]: function for function in description["functions"]}
    for name in description["structs"]:
        init = functions.get("agaaInit" + name.removeprefix("Agaa"))
        if init is None:
            yield f"zeros!({name});"
        else:
            yield f"{'defaults' if len(init['parameters']) > 1 else 'defaults_without_size'}!({name}, {init['name']});"


def source(description, generated):
    yield from (f"//! {generated}", "use core::ffi::c_void;", "use core::marker::{PhantomData, PhantomPinned};",
                "use std::os::raw::c_char;", "")
    yield from constants(description)
    yield ""
    yield from enums(description)
    yield ""
    yield from handles(description)
    yield ""
    yield from callbacks(description)
    yield from structs(description)
    yield ""
    yield from defaults(description)
    yield from ("", 'extern "C" {')
    yield from (call(f"pub fn {function['name']}", function, ";", "    ") for function in description["functions"])
    yield "}"


def manifest(description, generated):
    return [f"# {generated}", "[package]", 'name = "agaa-sys"', f'version = "{description["version"]}"', 'edition = "2021"',
            'rust-version = "1.63"', 'license = "MIT"', 'links = "agaa"',
            'description = "Raw bindings of the AGAA SDK: aggregate G-buffer anti-aliasing for Vulkan and OpenGL"', "", "[lib]",
            "doctest = false"]


LAYOUT = """
use agaa_sys::*;
use std::mem::{align_of, size_of, MaybeUninit};

fn check(name: &str, found: &[usize], expected: &[usize]) {
    assert_eq!(found, expected, "{name}: size, alignment, offsets");
}

macro_rules! layout {
    ($name:ident, $size:expr, $alignment:expr, $($member:ident: $offset:expr),*) => {
        let value = MaybeUninit::<$name>::uninit();
        let start = value.as_ptr();
        let offsets = unsafe { [$(std::ptr::addr_of!((*start).$member) as usize - start as usize),*] };
        check(
            stringify!($name),
            &[&[size_of::<$name>(), align_of::<$name>()], &offsets[..]].concat(),
            &[$size, $alignment, $($offset),*],
        );
    };
}

#[test]
fn layouts_are_those_of_the_description() {
"""


def layout(description, generated):
    """Structs have no padding, so that the offsets and the size also check the sizes of the members."""
    yield f"//! {generated} Checks sizes and offsets of structs, on 64-bit hosts."
    yield '#![cfg(target_pointer_width = "64")]'
    yield LAYOUT.strip()
    for name, struct in description["structs"].items():
        members = [f"{identifier(member['name'])}: {member['offset']}" for member in struct["members"]]
        yield "    layout!("
        yield ",\n".join(f"        {value}" for value in (name, struct["size"], struct["alignment"], *members))
        yield "    );"
    yield "}"


def files(description, generated):
    """Returns the lines of each file by its path from the root."""
    return {f"{CRATE}/src/generated.rs": source(description, generated), f"{CRATE}/Cargo.toml": manifest(description, generated),
            f"{CRATE}/tests/layout.rs": layout(description, generated)}
