#!/usr/bin/env python3
"""Tests of benchmark/gpu_run.py with a program that answers in place of the sample engine."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import gpu_pieces
import gpu_rows
import gpu_run

TOOL = pathlib.Path(gpu_run.__file__)
ENGINE = """#!/usr/bin/env python3
import json, pathlib, sys, time
words = sys.argv[1:]
log = pathlib.Path(__file__).with_name("calls")
log.write_text((log.read_text() if log.exists() else "") + " ".join(words) + "\\n")
def after(name, default=""):
    return words[words.index(name) + 1] if name in words else default
if "--exr" in words:
    pathlib.Path(after("--exr")).write_text("image")
if words[0] == "compare":
    print(json.dumps({"mseTm": 1e-4}))
elif words[0] == "reference":
    print("{}")
elif after("--technique") == "msaa":
    sys.exit("agaa-harness: msaa does not run here.")
elif after("--technique") == "simple_complex":
    time.sleep(60)
else:
    time.sleep(2 if after("--size") == "8x8" else 0)
    print(json.dumps({"backend": after("--backend"), "device": "A Card/PCIe", "driver": "1.2", "size": after("--size"),
                      "scene": after("--scene"), "technique": after("--technique"), "samples": int(after("--samples")),
                      "tiers": {}, "bytesPerPixel": 20, "shadingEventsPerCoveredPixel": 1,
                      "passes": [{"name": "shade", "stage": "shading", "ms": {"median": 1.0, "p95": 1.0}},
                                 {"name": "copy", "stage": "other", "ms": None}]}))
"""


class Run(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.programs = self.folder / "bin"
        self.programs.mkdir()
        engine = self.programs / "agaa-harness"
        engine.write_text(ENGINE)
        engine.chmod(0o755)

    def call(self, *arguments):
        command = [sys.executable, TOOL, "--out", self.folder / "out", "--programs", self.programs, "--scene", "metal",
                   "--backend", "vk", *([] if "--size" in arguments else ["--size", "64x36"]), "--documents", self.folder / "documents", *arguments]
        return subprocess.run(command, capture_output=True, text=True)

    def calls(self):
        return (self.programs / "calls").read_text().splitlines()

    def test_results_are_kept_and_merged(self):
        rows = ["--group", "passes", "--group", "errors", "--row", "msaa-8", "--row", "ssaa-8", "--row", "single-1"]
        first = self.call(*rows)
        self.assertEqual(first.returncode, 0, first.stderr)
        self.assertIn("msaa does not run here", first.stdout)
        self.assertIn("All pieces are done.", first.stdout)
        count = len(self.calls())
        self.assertIn("7 of them done before", self.call(*rows).stdout)
        self.assertEqual(len(self.calls()), count, "nothing runs twice")
        self.assertEqual(self.call("--merge").returncode, 0)
        page = (self.folder / "documents" / "a-card" / "passes.md").read_text()
        self.assertLess(page.index("`single`, 1"), page.index("`ssaa`, 8"))
        self.assertNotIn("msaa", page)
        errors = json.loads((self.folder / "documents" / "a-card" / "errors.json").read_text())["rows"]
        self.assertEqual([row["technique"] for row in errors], ["single", "ssaa"])

    def test_a_piece_that_a_call_interrupts_has_another_try(self):
        rows = ["--group", "passes", "--row", "simple_complex-8", "--row", "ssaa-8", "--minutes", "0.05", "--size", "8x8"]
        self.assertIn("1 pieces remain", self.call(*rows).stdout)
        self.assertIn("All pieces are done.", self.call(*rows).stdout)
        result = json.loads((self.folder / "out/passes/8x8-metal-vk-simple_complex-8.json").read_text())
        self.assertIn("it takes more than", result["failure"])

    def test_without_programs(self):
        (self.programs / "agaa-harness").unlink()
        done = self.call()
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("agaa-harness is not there", done.stderr)

    def test_merging_nothing(self):
        self.assertIn("has no rendered rows", self.call("--merge").stderr)


class Parts(unittest.TestCase):
    def test_suites_of_a_program(self):
        listing = "Running main() from gtest.cc\nOne.\n  Test  # GetParam() = 1\nAll/Two/0.  # TypeParam = X\n  Test\n"
        self.assertEqual(gpu_pieces.suites_of(listing), {"One": 1, "All/Two/0": 1})

    def test_failures_name_files_of_the_source_tree(self):
        self.assertEqual(gpu_pieces.without_root("/a/b/tests/c.cpp:1\nx /2/tests"), "tests/c.cpp:1\nx /2/tests")

    def test_devices_of_both_apis_have_one_folder(self):
        self.assertEqual(gpu_run.slug("NVIDIA H200/PCIe/SSE2"), gpu_run.slug("NVIDIA H200"))

    def test_names_of_rows_differ(self):
        names = [row.name for row in gpu_rows.rows()]
        self.assertEqual(len(set(names)), len(names))


if __name__ == "__main__":
    unittest.main()
