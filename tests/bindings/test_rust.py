"""The crate agaa-sys: a program uses the library, structs have the layout of C, the build script finds the library."""
import json
import os
import shutil
import unittest

from programs import ROOT, TESTS, program, run, scratch

MANIFEST = """[package]
name = "consumer"
version = "0.0.0"
edition = "2021"

[dependencies]
agaa-sys = { path = "agaa-sys" }

[workspace]
members = ["agaa-sys"]
"""


class Crate(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cargo = program("cargo")
        rustc = program("rustc")
        cls.folder = scratch()
        # Cargo writes into folders of crates.
        shutil.copytree(ROOT / "bindings" / "rust" / "agaa-sys", cls.folder / "agaa-sys")
        (cls.folder / "Cargo.toml").write_text(MANIFEST)
        (cls.folder / "src").mkdir()
        shutil.copy(TESTS / "consumer.rs", cls.folder / "src" / "main.rs")
        cls.environment = dict(os.environ, RUSTC=rustc, CARGO_HOME=str(cls.folder / "home"), CARGO_PROFILE_DEV_DEBUG="0",
                               CARGO_TARGET_DIR=str(cls.folder / "target"), RUSTFLAGS="-D warnings",
                               LD_LIBRARY_PATH=os.environ["AGAA_LIB_DIR"])

    def run_cargo(self, *arguments, **variables):
        environment = {**self.environment, **variables}
        if "PKG_CONFIG_LIBDIR" in variables:
            del environment["AGAA_LIB_DIR"]
            environment.pop("PKG_CONFIG_PATH", None)
        return run(self.cargo, "--offline", *arguments, cwd=self.folder, env=environment)

    def write_package(self, version):
        """Writes agaa.pc of a library of this version, and returns its folder. The prefix has a space."""
        folder = self.folder / "other prefix" / "lib" / "pkgconfig"
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "agaa.pc").write_text("libdir=${pcfiledir}/..\nName: agaa\nDescription: AGAA SDK\n"
                                        f"Version: {version}\nLibs: -L${{libdir}} -lagaa\n")
        return folder

    def test_program(self):
        printed = self.run_cargo("run", "--quiet")
        self.assertIn("AGAA_OK: 81.0 bytes per pixel", printed)

    def test_layout(self):
        self.assertIn("1 passed", self.run_cargo("test", "--quiet", "--package", "agaa-sys", "--test", "layout"))

    def test_pkg_config(self):
        version = json.loads((ROOT / "abi" / "agaa.json").read_text())["version"]
        folder = self.write_package(version)
        printed = self.run_cargo("check", "--quiet", "--package", "agaa-sys", "--message-format", "json",
                                 PKG_CONFIG_LIBDIR=str(folder))
        script, = [message for message in map(json.loads, printed.splitlines())
                   if message["reason"] == "build-script-executed"]
        self.assertEqual(script["linked_libs"], ["dylib=agaa"])
        self.assertEqual(script["linked_paths"], [f"native={folder}/.."])

    def test_other_versions_are_refused(self):
        version = json.loads((ROOT / "abi" / "agaa.json").read_text())["version"]
        major, minor, patch = map(int, version.split("."))
        for other in (f"{major}.{minor + 1}.0", f"{major}.{minor - 1}.9"):
            with self.assertRaises(AssertionError) as caught:
                self.run_cargo("check", "--quiet", "--package", "agaa-sys", PKG_CONFIG_LIBDIR=str(self.write_package(other)))
            self.assertIn(f"pkg-config does not find agaa {version}. Install libagaa-dev", str(caught.exception))


if __name__ == "__main__":
    unittest.main(verbosity=2)
