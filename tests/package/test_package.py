"""Installs the SDK, moves the prefix, and uses it as others do.

The test of the class Install comes first; the others need the prefix that it leaves.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

CMAKE = os.environ["AGAA_CMAKE"]
SOURCE = pathlib.Path(os.environ["AGAA_SOURCE"])
BUILD = pathlib.Path(os.environ["AGAA_BUILD"])
VERSION = os.environ["AGAA_VERSION"]
LIBDIR = os.environ["AGAA_LIBDIR"]
TESTS = SOURCE / "tests" / "package"
SCRATCH = BUILD / "package-test"
PREFIX = SCRATCH / "moved to"
LIBRARY = PREFIX / LIBDIR / f"libagaa.so.{VERSION}"


def run(*command, **options):
    result = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, **options)
    if result.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\n{result.stdout}")
    return result.stdout


def configure(source, name, *options):
    """A fresh build folder of the project."""
    build = SCRATCH / name
    shutil.rmtree(build, ignore_errors=True)
    text = run(CMAKE, "-G", "Ninja", "-S", source, "-B", build, f"-DCMAKE_PREFIX_PATH={PREFIX}", *options)
    return build, text


class Install(unittest.TestCase):
    def test_install_and_move(self):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        first = SCRATCH / "first"
        run(CMAKE, "--install", BUILD, "--prefix", first)
        first.rename(PREFIX)


class Contents(unittest.TestCase):
    def test_headers_are_the_public_ones(self):
        self.assertEqual(sorted(path.name for path in (PREFIX / "include").iterdir()),
                         ["agaa", "agaa.hpp", "agaa_conformance.h", "agaa_gl.h", "agaa_gl.hpp", "agaa_sdk.h", "agaa_vk.h",
                          "agaa_vk.hpp"])
        source, installed = (sorted(path.relative_to(root).as_posix() for path in (root / "agaa").rglob("*.h*"))
                             for root in (SOURCE / "include", PREFIX / "include"))
        self.assertEqual(installed, source)

    def test_documents_are_there(self):
        documents = PREFIX / "share" / "doc" / "agaa"
        guides = [path.relative_to(SOURCE) for path in (SOURCE / "docs").rglob("*.md")
                  if "results" not in path.relative_to(SOURCE).parts]
        self.assertGreater(len(guides), 20)
        for name in ("LICENSE", "NOTICES.md", "README.md", "docs/images/comparison.png",
                     "examples/minimal/CMakeLists.txt", *guides):
            self.assertTrue((documents / name).is_file(), name)
        self.assertFalse((documents / "docs" / "results").exists())

    def test_links_of_documents_resolve(self):
        documents = PREFIX / "share" / "doc" / "agaa"
        for document in documents.rglob("*.md"):
            for target in re.findall(r"\]\(([^)#:]+)\)", document.read_text()):
                self.assertTrue((document.parent / target).exists(), f"{document}: {target}")

    def test_nothing_names_the_place_of_building(self):
        package = [*(PREFIX / LIBDIR / "cmake" / "agaa").iterdir(),
                   PREFIX / LIBDIR / "pkgconfig" / "agaa.pc"]
        self.assertGreaterEqual(len(package), 5)
        for path in package:
            for place in (SOURCE, BUILD, SCRATCH):
                self.assertNotIn(str(place), path.read_text(), path)
            self.assertNotIn("agaa_objects", path.read_text(), path)

    def test_the_library_is_small(self):
        if "CMAKE_BUILD_TYPE:STRING=Release" not in (BUILD / "CMakeCache.txt").read_text():
            self.skipTest("the build is no release")
        stripped = SCRATCH / "stripped.so"
        run("strip", "-o", stripped, LIBRARY)
        self.assertLess(stripped.stat().st_size, 6000000)

    def test_soname_and_dependencies(self):
        text = run("readelf", "-d", LIBRARY)
        # Minor versions are not compatible while the major one is 0.
        major, minor = VERSION.split(".")[:2]
        self.assertEqual(re.findall(r"\(SONAME\).*\[(.*)\]", text), [f"libagaa.so.{major}.{minor}"])
        # Graphics APIs are reached through the host's loader.
        needed = set(re.findall(r"\(NEEDED\).*\[(.*?)\.so", text))
        self.assertLessEqual(needed, {"libstdc++", "libm", "libgcc_s", "libc", "ld-linux-x86-64"})
        self.assertNotRegex(text, r"\((RPATH|RUNPATH)\)")
        self.assertEqual(os.readlink(LIBRARY.parent / "libagaa.so"), f"libagaa.so.{major}.{minor}")
        self.assertEqual(os.readlink(LIBRARY.parent / f"libagaa.so.{major}.{minor}"), LIBRARY.name)

    def test_exported_symbols(self):
        abi = SOURCE / "tests" / "abi"
        run(CMAKE, f"-DLIBRARY={LIBRARY}", "-DNM=nm", f"-DEXPECTED={abi / 'exported_symbols.txt'}",
            "-P", abi / "check_symbols.cmake")


class Consumers(unittest.TestCase):
    def run_with_installed_library(self, program):
        self.assertIn(str(LIBRARY.parent), run("ldd", program))
        run(program)

    def test_find_package_from_c(self):
        build, _ = configure(TESTS / "find_package_c", "find-package-c")
        run(CMAKE, "--build", build)
        self.run_with_installed_library(build / "consumer")

    def test_find_package_from_cpp(self):
        build, _ = configure(TESTS / "find_package_cpp", "find-package-cpp")
        run(CMAKE, "--build", build)
        self.run_with_installed_library(build / "consumer")

    def test_pkg_config(self):
        environment = dict(os.environ, PKG_CONFIG_PATH=str(LIBRARY.parent / "pkgconfig"),
                           CC=os.environ["AGAA_CC"])
        self.assertEqual(run("pkg-config", "--modversion", "agaa", env=environment).strip(), VERSION)
        program = SCRATCH / "pkg-config-consumer"
        # The shell's reading of the flags counts: the prefix has a space.
        run("sh", "-c", 'eval "$CC" -std=c99 \\"$1\\" $(pkg-config --cflags --libs agaa) '
            '-o \\"$2\\" \\"-Wl,-rpath,$3\\"', "sh", SOURCE / "tests" / "abi" / "consumer.c", program,
            LIBRARY.parent, env=environment)
        self.run_with_installed_library(program)

    def test_wrong_versions_are_refused(self):
        major, minor, patch = map(int, VERSION.split("."))
        for wanted, is_found in ((f"{major}.{minor}", 1), (VERSION, 1),
                                 (f"{major}.{minor}.{patch + 1}", 0), (f"{major}.{minor + 1}", 0),
                                 (f"{major + 1}.0", 0), (f"{major}.{minor - 1}", 0)):
            _, text = configure(TESTS / "version", "version", f"-DWANTED={wanted}")
            self.assertIn(f"found {is_found}; considered {VERSION}", text, wanted)

    def test_subproject(self):
        build, _ = configure(TESTS / "subproject", "subproject", f"-DAGAA_SOURCE={SOURCE}")
        run(CMAKE, "--build", build, "--target", "headers")
        prefix = SCRATCH / "subproject-prefix"
        run(CMAKE, "--install", build, "--prefix", prefix)
        self.assertFalse(prefix.exists(), "A subproject installs the SDK.")

    def test_static_library_without_its_users(self):
        with self.assertRaisesRegex(AssertionError, "AGAA_STATIC needs AGAA_SAMPLES"):
            configure(SOURCE, "static-samples", "-DAGAA_STATIC=ON")


class Examples(unittest.TestCase):
    def test_minimal_hosts(self):
        build, _ = configure(PREFIX / "share" / "doc" / "agaa" / "examples" / "minimal", "minimal",
                             "-DCMAKE_C_FLAGS=-Werror")
        run(CMAKE, "--build", build)
        for host in ("minimal_vk", "minimal_gl", "gbuffer_gl", "gbuffer_vk", "ids_gl", "ids_vk", "triangles_gl",
                     "triangles_vk", "minimal_cpp"):
            self.assertIn(str(LIBRARY.parent), run("ldd", build / host))
        run(sys.executable, SOURCE / "tests" / "minimal" / "test_minimal.py",
            env=dict(os.environ, AGAA_MINIMAL=str(build)))


if __name__ == "__main__":
    unittest.main()
