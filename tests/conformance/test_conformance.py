"""Runs the conformance suite as a user does, and counts the promises that it tests.

AGAA_CONFORMANCE is the program, AGAA_LIBRARY the library."""
import importlib.util
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ["AGAA_CONFORMANCE"]
LIBRARY = os.environ["AGAA_LIBRARY"]


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def listed(*arguments):
    """The tests and their backends."""
    result = run("--list", *arguments)
    assert result.returncode == 0, result.stderr
    return dict(line.split("\t") for line in result.stdout.splitlines())


def share_of(names):
    """The names that AGAA_CONFORMANCE_SHARE, such as 2/4, assigns to this process; all without it."""
    number, count = map(int, os.environ.get("AGAA_CONFORMANCE_SHARE", "1/1").split("/"))
    return sorted(names)[number - 1::count]


def promises():
    spec = importlib.util.spec_from_file_location("promises", ROOT / "tools" / "promises.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.promises(ROOT / "include")


class Promises(unittest.TestCase):
    def test_each_has_a_test(self):
        tests = listed()
        found = promises()
        missing = [promise for promise in found if promise not in tests]
        print(f"{len(found)} promises, {len(found) - len(missing)} with a test; {len(tests)} tests", file=sys.stderr)
        self.assertGreater(len(found), 340, "the parser finds fewer promises than the headers had")
        self.assertEqual(missing, [])

    def test_names_are_of_the_headers(self):
        """A test that is not of a promise begins with a function, a struct or its member, or a constant all the same."""
        text = "\n".join(path.read_text() for path in (ROOT / "include").rglob("*.h"))
        known = set(re.findall(r"\w+", text)) | {"general", "conventions"}
        owners = {name: re.split(r"[./]", name)[:2 if "." in name.split("/")[0] else 1] for name in listed()}
        self.assertEqual([name for name, owner in owners.items() if not known.issuperset(owner)], [])


class Backend(unittest.TestCase):
    backend = None

    def check(self, backend, patterns="-*/long"):
        tests = share_of(listed("--backend", backend, "--filter", patterns))
        patterns = ":".join(tests)
        with tempfile.TemporaryDirectory() as folder:
            json_path, junit_path = pathlib.Path(folder) / "r.json", pathlib.Path(folder) / "r.xml"
            result = run(LIBRARY, "--backend", backend, "--filter", patterns, "--json", str(json_path), "--junit",
                         str(junit_path))
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            counts = [tuple(map(int, pair)) for pair in re.findall(r"survived (\d+) of (\d+) faults", result.stdout)]
            if counts:
                survived, injected = map(sum, zip(*counts))
                print(f"{backend}: survived {survived} of {injected} injected faults", file=sys.stderr)
                self.assertEqual(survived, injected)
            report = json.loads(json_path.read_text())
            self.assertEqual(sorted(row["name"] for row in report["results"]), tests)
            self.assertEqual(report["failed"], 0)
            if backend != "core" and not report["devices"]:
                self.skipTest(f"there is no device of {backend}")
            skipped = [f"{row['name']}: {row['reason']}" for row in report["results"] if row["status"] == "skipped"]
            print("\n".join([f"{len(tests)} tests, {len(skipped)} skipped"] + skipped), file=sys.stderr)
            suites = xml.etree.ElementTree.parse(junit_path).getroot()
            self.assertEqual([int(suites[0].get(key)) for key in ("tests", "failures", "skipped")],
                             [len(tests), 0, len(skipped)])

    def test_core(self):
        self.check("core")

    def test_vk(self):
        self.check("vk")

    def test_gl(self):
        self.check("gl")

    def test_vk_long(self):
        self.check("vk", "*/long")

    def test_gl_versions(self):
        """On the version of MESA_GL_VERSION_OVERRIDE."""
        self.check("gl", "general/techniques/versions")


class Program(unittest.TestCase):
    def test_filter(self):
        self.assertEqual(set(listed("--filter", "agaaGetVersion/*")), {"agaaGetVersion/no_errors"})
        result = run(LIBRARY, "--backend", "core", "--filter", "agaaGetVersion/*", "--verbose")
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("1 tests: 1 passed, 0 failed, 0 skipped.", result.stdout)

    def test_refusals(self):
        for arguments, words in ((("/nonexistent/libagaa.so",), "/nonexistent/libagaa.so"),
                                 ((LIBRARY, "--filter", "nothing"), "no test matches"),
                                 ((LIBRARY, "--backend", "dx"), "dx"),
                                 ((LIBRARY, "--json", "/nonexistent/r.json"), "/nonexistent/r.json"),
                                 (("libm.so.6",), "lacks the function")):
            result = run(*arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertIn(words, result.stderr)

    def test_device_that_is_not_there(self):
        result = run(LIBRARY, "--backend", "vk", "--device", "no such device", "--filter", "agaaVkCreateContext/*")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("skipped, because", result.stdout)


if __name__ == "__main__":
    unittest.main()
