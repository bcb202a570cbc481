//! Finds libagaa: in the folder AGAA_LIB_DIR, or by pkg-config.
use std::env;
use std::process::{exit, Command};

fn pkg_config(arguments: &[&str]) -> Option<String> {
    let output = Command::new("pkg-config").args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_string())
}

/// Returns the folder of a library with the soname of this crate's version.
fn installed_folder() -> Option<String> {
    let part = |name: &str| env::var(format!("CARGO_PKG_VERSION_{name}")).unwrap();
    let (major, minor, patch) = (part("MAJOR"), part("MINOR"), part("PATCH"));
    let next: u32 = minor.parse::<u32>().unwrap() + 1;
    let oldest = format!("agaa >= {major}.{minor}.{patch}");
    pkg_config(&["--exists", &oldest, &format!("agaa < {major}.{next}")])?;
    // It escapes spaces.
    Some(pkg_config(&["--variable=libdir", "agaa"])?.replace('\\', ""))
}

fn main() {
    for name in ["AGAA_LIB_DIR", "PKG_CONFIG_PATH", "PKG_CONFIG_LIBDIR"] {
        println!("cargo:rerun-if-env-changed={name}");
    }
    let folder = env::var("AGAA_LIB_DIR").ok().or_else(installed_folder).unwrap_or_else(|| {
        let version = env::var("CARGO_PKG_VERSION").unwrap();
        eprintln!(
            "pkg-config does not find agaa {version}. Install libagaa-dev, or set AGAA_LIB_DIR to the folder of \
             libagaa.so."
        );
        exit(1)
    });
    println!("cargo:rustc-link-search=native={folder}");
    println!("cargo:rustc-link-lib=dylib=agaa");
    // Build scripts of dependents read it as DEP_AGAA_LIB_DIR.
    println!("cargo:lib_dir={folder}");
}
