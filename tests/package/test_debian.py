"""Makes the Debian packages, extracts them into a root, and uses them from there.

The test of the class Packages comes first; the others need the root that it leaves, and the prefix of test_package.py.
"""
import os
import pathlib
import re
import shutil
import sys
import unittest

from test_package import BUILD, CMAKE, LIBDIR, PREFIX, SOURCE, VERSION, run

SCRATCH = BUILD / "debian-test"
FOLDER = SCRATCH / "packages"
ROOT = SCRATCH / "root"
SERIES = ".".join(VERSION.split(".")[:2])
NAMES = [f"libagaa{SERIES}", "libagaa-dev", "agaa-tools"]
EXAMPLES = ROOT / "usr/share/doc/libagaa-dev/examples/minimal"


def package(name):
    return next(FOLDER.glob(f"{name}_*.deb"))


def contents(name):
    """(mode, owner, path) of each entry."""
    for line in run("dpkg-deb", "--contents", package(name)).splitlines():
        mode, owner, _, _, _, path = line.split(maxsplit=5)
        yield mode, owner, path.split(" -> ")[0].removeprefix("./")


def files(name):
    return [path for mode, _, path in contents(name) if not mode.startswith("d")]


def multiarch():
    return run("dpkg-architecture", "-qDEB_HOST_MULTIARCH").strip()


class Packages(unittest.TestCase):
    def test_make_and_extract(self):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        for program in ("dh", "lintian"):
            if not shutil.which(program):
                self.skipTest(f"{program} is not installed")
        # Modes must not depend on the umask. Little compression saves ten seconds.
        print(run(SOURCE / "scripts" / "package", "--build", BUILD, FOLDER, umask=0o077,
                  env={**os.environ, "DPKG_DEB_COMPRESSOR_LEVEL": "1"}))
        for name in NAMES:
            run("dpkg-deb", "--extract", package(name), ROOT)


class Extracted(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not ROOT.exists():
            raise unittest.SkipTest("lintian or dh is not installed")


class Contents(Extracted):
    def test_there_are_three_packages(self):
        architecture = run("dpkg-architecture", "-qDEB_HOST_ARCH").strip()
        self.assertEqual(sorted(path.name for path in FOLDER.iterdir()),
                         sorted(f"{name}_{VERSION}-1_{architecture}.deb" for name in NAMES))

    def test_each_installed_file_is_in_one_package(self):
        packaged = [path for name in NAMES for path in files(name)]
        self.assertEqual(len(packaged), len(set(packaged)))
        installed = set()
        for path in PREFIX.rglob("*"):
            if path.is_dir() and not path.is_symlink():
                continue
            place = path.relative_to(PREFIX).as_posix()
            place = re.sub(rf"^{LIBDIR}/", f"lib/{multiarch()}/", place)
            place = re.sub("^share/doc/agaa/", "share/doc/libagaa-dev/", place)
            place = re.sub(r"^(share/man/.*)$", r"\1.gz", place)
            installed.add(f"usr/{place}")
        self.assertEqual(installed - set(packaged), set())
        own = {f"usr/share/doc/{name}/{file}" for name in NAMES for file in ("copyright", "changelog.Debian.gz")}
        self.assertEqual(set(packaged) - installed, own | {"usr/share/lintian/overrides/libagaa-dev"})

    def test_packages_hold_their_parts(self):
        library = f"usr/lib/{multiarch()}/libagaa.so"
        self.assertEqual([path for path in files(NAMES[0]) if "/doc/" not in path],
                         [f"{library}.{VERSION}", f"{library}.{SERIES}"])
        development, tools = files("libagaa-dev"), files("agaa-tools")
        for path in (library, "usr/include/agaa_sdk.h", "usr/share/agaa/agaa.json", "usr/share/agaa/agaa.py",
                     "usr/share/agaa/Agaa.cs", "usr/share/agaa/agaa-sys/Cargo.toml", "usr/share/agaa/agaa-sys/build.rs",
                     "usr/share/agaa/agaa-sys/src/generated.rs", "usr/share/doc/libagaa-dev/LICENSE"):
            self.assertIn(path, development)
        programs = [path for path in tools if path.startswith("usr/bin/")]
        self.assertIn("usr/bin/agaa-harness", programs)
        for program in programs:
            self.assertIn(f"usr/share/man/man1/{pathlib.Path(program).name}.1.gz", tools)

    def test_modes_and_owners(self):
        for name in NAMES:
            for mode, owner, path in contents(name):
                self.assertEqual(owner, "root/root", path)
                is_program = path.startswith("usr/bin/") and not path.endswith("/")
                self.assertIn(mode, ["-rwxr-xr-x"] if is_program else ["drwxr-xr-x", "-rw-r--r--", "lrwxrwxrwx"], path)

    def test_control_files(self):
        def field(name, key):
            return run("dpkg-deb", "--field", package(name), key).strip()

        self.assertIn("libc6", field(NAMES[0], "Depends"))
        self.assertEqual(field("libagaa-dev", "Depends"), f"{NAMES[0]} (= {VERSION}-1)")
        self.assertIn(f"{NAMES[0]} (>= {SERIES})", field("agaa-tools", "Depends"))
        self.assertIn("activate-noawait ldconfig", run("dpkg-deb", "--info", package(NAMES[0]), "triggers"))
        self.assertIn(f"agaaGetVersion@AGAA_{SERIES} {SERIES}", run("dpkg-deb", "--info", package(NAMES[0]), "symbols"))

    def test_nothing_names_the_place_of_building(self):
        for path in ROOT.rglob("*"):
            if path.is_file():
                data = path.read_bytes()
                for place in (SOURCE, BUILD):
                    self.assertNotIn(f"{place}/".encode(), data, path)


class Hosts(Extracted):
    libraries = None

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.libraries = ROOT / "usr" / "lib" / multiarch()

    def test_examples_by_find_package(self):
        hosts = SCRATCH / "hosts"
        run(CMAKE, "-G", "Ninja", "-S", EXAMPLES, "-B", hosts, f"-DCMAKE_PREFIX_PATH={ROOT / 'usr'}",
            "-DCMAKE_C_FLAGS=-Werror")
        run(CMAKE, "--build", hosts)
        for host in ("minimal_vk", "minimal_gl", "gbuffer_gl", "gbuffer_vk", "ids_gl", "ids_vk", "triangles_gl",
                     "triangles_vk", "checked_gl", "minimal_cpp"):
            self.assertIn(str(self.libraries), run("ldd", hosts / host))
        run(sys.executable, SOURCE / "tests" / "minimal" / "test_minimal.py", "Both",
            env=dict(os.environ, AGAA_MINIMAL=str(hosts)))

    def test_example_by_pkg_config(self):
        flags = run("pkg-config", "--cflags", "--libs", "agaa",
                    env={**os.environ, "PKG_CONFIG_PATH": str(self.libraries / "pkgconfig")}).split()
        program = SCRATCH / "minimal_gl"
        run(os.environ["AGAA_CC"], "-std=c99", "-Werror", EXAMPLES / "minimal_gl.c", *flags, "-lOpenGL", "-lEGL", "-lm",
            "-o", program, f"-Wl,-rpath,{self.libraries}")
        self.assertIn(str(self.libraries), run("ldd", program))
        run(program, SCRATCH / "minimal_gl.ppm")

    def test_tools_run(self):
        programs = sorted((ROOT / "usr" / "bin").iterdir())
        self.assertTrue(programs)
        for program in programs:
            run(program, "--help", env={**os.environ, "LD_LIBRARY_PATH": str(self.libraries)})


if __name__ == "__main__":
    unittest.main(verbosity=2)
