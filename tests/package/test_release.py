"""The release archive of scripts/release, and the projects and recipes that build it without a network.

The test of the class Archive comes first; the others need the archive that it leaves.
"""
import importlib.util
import os
import re
import shutil
import sys
import tarfile
import types
import unittest

from test_package import BUILD, CMAKE, LIBDIR, SCRATCH, SOURCE, TESTS, VERSION, run

FOLDER = SCRATCH / "release"
ARCHIVE = FOLDER / f"agaa-{VERSION}.tar.xz"
ROOT = FOLDER / "with space" / f"agaa-{VERSION}"
# The library is compiled for these tests only, in fewer files and without optimisation.
QUICK = "-G", "Ninja", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_CXX_FLAGS=-O0"


def fresh(name):
    folder = FOLDER / name
    shutil.rmtree(folder, ignore_errors=True)
    return folder


def cache(build):
    return (build / "CMakeCache.txt").read_text()


class Archive(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        run(SOURCE / "scripts" / "release", "--build", BUILD, FOLDER)
        with tarfile.open(ARCHIVE) as archive:
            cls.members = archive.getmembers()
            archive.extractall(FOLDER / "with space")

    def test_contents(self):
        members = self.members
        names = {member.name.removeprefix(f"agaa-{VERSION}/") for member in members}
        for name in ("CMakeLists.txt", "LICENSE", "NOTICES.md", "include/agaa_sdk.h", "generated/glad/src/gl.c",
                     "generated/shader_texts.inc", "packaging/vcpkg/agaa/portfile.cmake", "docs/README.md"):
            self.assertIn(name, names)
        self.assertFalse([name for name in names if name.startswith(("tests/", "benchmark/", "docs/results/"))])
        modules = re.findall(r'"(.*)"', (BUILD / "src" / "spirv_includes.inc").read_text())
        self.assertGreater(len(modules), 100)
        self.assertEqual({f"generated/{each}" for each in modules},
                         {name for name in names if name.startswith("generated/spirv/") and name.endswith(".inc")})
        self.assertFalse([name for name in names if "/target/" in name or name.endswith("Cargo.lock")])
        self.assertEqual({(member.uid, member.gid) for member in members}, {(0, 0)})
        self.assertEqual(len({member.mtime for member in members}), 1)
        for path in (ROOT / "generated").rglob("*.*"):
            text = path.read_text()
            for place in (SOURCE, BUILD):
                self.assertNotIn(str(place), text, path)

    def test_configuration_needs_no_generators(self):
        build = fresh("configured")
        run(CMAKE, "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_DISABLE_FIND_PACKAGE_SPIRV-Tools-opt=ON")
        self.assertNotRegex(cache(build), r"(?m)^GLAD:|SPIRV-Tools-opt_DIR|glslangValidator")
        for option in ("SAMPLES", "TESTS", "CONFORMANCE"):
            self.assertIn(f"AGAA_{option}:BOOL=OFF", cache(build))
        self.assertIn("AGAA_INSTALL:BOOL=ON", cache(build))

    def test_recipes_have_the_version_of_the_headers(self):
        self.assertIn(f'"version": "{VERSION}"', (ROOT / "packaging" / "vcpkg" / "agaa" / "vcpkg.json").read_text())

    def test_options_without_sources_are_refused(self):
        for option in ("SAMPLES", "TESTS", "BENCHMARK"):
            with self.assertRaisesRegex(AssertionError, f"AGAA_{option} is on, but these sources"):
                run(CMAKE, "-S", ROOT, "-B", fresh("refused"), "-G", "Ninja", f"-DAGAA_{option}=ON")

    def test_a_folder_without_generated_files_is_refused(self):
        empty = FOLDER / "empty"
        empty.mkdir(exist_ok=True)
        with self.assertRaisesRegex(AssertionError, "AGAA_GENERATED is"):
            run(CMAKE, "-S", ROOT, "-B", fresh("refused"), "-G", "Ninja", f"-DAGAA_GENERATED={empty}")
        with self.assertRaisesRegex(AssertionError, "--build needs a build folder"):
            run(SOURCE / "scripts" / "release", "--build", empty)


class FetchContent(unittest.TestCase):
    def test_consumer(self):
        build = fresh("fetched")
        run(CMAKE, "-S", TESTS / "fetch_content", "-B", build, *QUICK, f"-DARCHIVE={ARCHIVE}",
            "-DCMAKE_DISABLE_FIND_PACKAGE_SPIRV-Tools-opt=ON")
        self.assertNotRegex(cache(build), r"(?m)^GLAD:|SPIRV-Tools-opt_DIR")
        run(CMAKE, "--build", build)
        run(build / "consumer")


class VcpkgPort(unittest.TestCase):
    """Debian has no vcpkg, so run_port.cmake has the functions that the port calls."""

    def test_static_library_and_its_consumers(self):
        prefix = fresh("vcpkg")
        run(CMAKE, f"-DPORT={ROOT / 'packaging' / 'vcpkg' / 'agaa'}", f"-DPREFIX={prefix}", "-DLINKAGE=static",
            f"-DOPTIONS={';'.join(QUICK)};-DCMAKE_INSTALL_LIBDIR=lib", "-P", TESTS / "recipes" / "run_port.cmake")
        self.assertTrue((prefix / "share" / "agaa" / "copyright").is_file())
        # The names of another loader in the host's program would be taken for the library's.
        symbols = run("nm", "--extern-only", "--defined-only", prefix / "lib" / "libagaa.a")
        self.assertIn(" T agaaGlCreateContext", symbols)
        self.assertNotRegex(symbols, r"(?m) [TDBR] glad")
        self.assertFalse(list(prefix.rglob("*.so*")))
        for language in ("c", "cpp"):
            consumer = fresh(f"vcpkg-consumer-{language}")
            run(CMAKE, "-S", TESTS / f"find_package_{language}", "-B", consumer, "-G", "Ninja",
                f"-Dagaa_DIR={prefix / 'share' / 'agaa'}")
            run(CMAKE, "--build", consumer)
            self.assertNotIn("libagaa", run("ldd", consumer / "consumer"))
            run(consumer / "consumer")
        environment = dict(os.environ, PKG_CONFIG_PATH=str(prefix / "lib" / "pkgconfig"))
        program = FOLDER / "pkg-config-consumer"
        run("sh", "-c", 'eval "$AGAA_CC" -std=c99 \\"$1\\" $(pkg-config --cflags --libs agaa) -o \\"$2\\"', "sh",
            SOURCE / "tests" / "abi" / "consumer.c", program, env=environment)
        self.assertNotIn("libagaa", run("ldd", program))
        run(program)

    def test_a_checkout_is_refused(self):
        with self.assertRaisesRegex(AssertionError, "is no release archive"):
            run(CMAKE, f"-DPORT={SOURCE / 'packaging' / 'vcpkg' / 'agaa'}", f"-DPREFIX={fresh('refused')}",
                "-DLINKAGE=dynamic", "-P", TESTS / "recipes" / "run_port.cmake")


class ConanRecipe(unittest.TestCase):
    """Debian has no Conan, so the folder recipes/ has the classes that the recipe uses."""

    def recipe(self, archive):
        sys.path.insert(0, str(TESTS / "recipes"))
        path = archive / "packaging" / "conan" / "conanfile.py"
        spec = importlib.util.spec_from_file_location("conanfile", path)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        recipe = module.AgaaConan()
        recipe.recipe_folder = str(path.parent)
        return recipe

    def test_shared_library_and_its_consumer(self):
        recipe = self.recipe(ROOT)
        folder = fresh("conan")
        recipe.export_sources_folder = recipe.source_folder = str(folder / "source")
        recipe.build_folder, recipe.package_folder = str(folder / "build"), str(folder / "package")
        recipe.options = types.SimpleNamespace(shared=True)
        recipe.cpp_info = types.SimpleNamespace()
        recipe.configure_options = [*QUICK, f"-DCMAKE_INSTALL_LIBDIR={LIBDIR}"]
        recipe.set_version()
        self.assertEqual(recipe.version, VERSION)
        recipe.export_sources()
        recipe.requirements()
        self.assertEqual({each.split("/")[0] for each in recipe.required}, {"glslang", "vulkan-headers", "zstd"})
        for step in (recipe.layout, recipe.generate, recipe.build, recipe.package, recipe.package_info):
            step()
        self.assertEqual(recipe.cpp_info.libs, ["agaa"])
        self.assertTrue((folder / "package" / "licenses" / "LICENSE").is_file())
        consumer = fresh("conan-consumer")
        run(CMAKE, "-S", TESTS / "find_package_c", "-B", consumer, "-G", "Ninja",
            f"-DCMAKE_PREFIX_PATH={recipe.package_folder}")
        run(CMAKE, "--build", consumer)
        self.assertIn(recipe.package_folder, run("ldd", consumer / "consumer"))
        run(consumer / "consumer")

    def test_a_checkout_is_refused(self):
        recipe = self.recipe(SOURCE)
        with self.assertRaisesRegex(Exception, "is no release archive"):
            recipe.export_sources()


if __name__ == "__main__":
    unittest.main()
