#!/usr/bin/env python3
"""Tests of benchmark/report/speed.py: ratios of the same turn, and their confidence bounds."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOOL = ROOT / "benchmark" / "report" / "speed.py"
sys.path[:0] = [str(TOOL.parent), str(TOOL.parents[1])]
import paired
import speed

DRIFT = [1, 3, 1, 5, 2, 8, 1]  # factors of the times in each turn


def row(technique, n, c, ms, by=None, preset="", drift=DRIFT, shading=1):
    def times(each):
        return {"turns": [each * slow for slow in drift]}
    return {"technique": technique, "n": n, "c": c, "shadingCost": 1, "preset": preset,
            "tiers": {"generation": by} if by else {}, "frameMs": times(ms),
            "passes": [{"name": "classify", "stage": "definition", "ms": times(1)},
                       {"name": "shade", "stage": "shading", "ms": times(shading)},
                       {"name": "clear", "stage": "other", "ms": None}]}


def scene(**more):
    return {"name": "sh3d_foliage", "build": "1.2-abc", "rows": [
        row("simple_complex", 8, 0, 30, shading=5), row("agaa", 8, 2, 40, shading=4), row("agaa", 8, 2, 20, "ids"),
        row("agaa", 8, 4, 50, "gbuffer", "accurate")], **more}


def results(*scenes, backend="vk", **more):
    return {"size": "1x1", "rounds": 7, "backends": [{"backend": backend, "device": "d", "driver": "e",
                                                      "scenes": list(scenes)}], **more}


class Paired(unittest.TestCase):
    def test_the_devices_speed_cancels(self):
        self.assertEqual(paired.ratios(row("a", 8, 0, 30), row("b", 8, 0, 40)), [0.75] * 7)
        self.assertEqual(paired.shown([0.75] * 7), "0.75 (0.75 to 0.75)")

    def test_shading_is_with_classification_and_without_clustering(self):
        self.assertEqual(paired.ratios(*scene()["rows"][:2], paired.shading), [1.5] * 7)
        untimed = row("agaa", 8, 2, 40)
        untimed["passes"][1]["ms"] = None
        self.assertEqual(paired.ratios(scene()["rows"][0], untimed, paired.shading), [])

    def test_bounds_are_those_of_the_harness(self):
        # With 95 % confidence, the bounds of n values are the k-th from either end: see tests/render/quantiles_test.cpp.
        for n, k in ((1, 1), (5, 1), (6, 1), (8, 1), (9, 2), (11, 2), (12, 3), (20, 6), (101, 41)):
            with self.subTest(n=n):
                self.assertEqual(paired.bounds(range(n, 0, -1)), (k, n + 1 - k))

    def test_what_is_missing_is_no_ratio(self):
        whole = row("a", 8, 0, 30)
        self.assertEqual(paired.ratios(None, whole), [])
        self.assertEqual(paired.ratios(whole, {"frameMs": {}}), [])
        self.assertEqual(paired.ratios(whole, row("b", 8, 0, 0)), [])
        self.assertEqual(paired.shown([]), "not measured")


class Document(unittest.TestCase):
    def test_ways_beside_the_rival_and_two_passes(self):
        text = speed.document([results(scene(), rows=["simple_complex-8", "agaa-8-2"])])
        self.assertIn("## Vulkan: d, e\n\n1x1, 7 turns of each row; build 1.2-abc.", text)
        self.assertIn("Rows that took turns: simple_complex-8, agaa-8-2.", text)
        self.assertIn("| sh3d\\_foliage (dense) | 8 | 1.50 (1.50 to 1.50) | 0.75 (0.75 to 0.75) | "
                      "1.50 (1.50 to 1.50) |", text)
        self.assertIn("| scene | n | c=2 by id | accurate from a G-buffer |", text)
        self.assertIn("| sh3d\\_foliage (dense) | 8 | 0.50 (0.50 to 0.50) | 1.25 (1.25 to 1.25) |", text)
        self.assertNotIn("| 32 |", text)

    def test_every_sweep_and_no_plain_scene(self):
        text = speed.document([results(scene()), results(scene(name="city", build=None), scene(name="bare", plain=True),
                                                         backend="gl")])
        self.assertIn("## OpenGL: d, e\n\n1x1, 7 turns of each row; build one without a name.", text)
        self.assertIn("| city | 8 |", text)
        self.assertNotIn("bare", text)

    def test_nothing_to_compare(self):
        text = speed.document([results()])
        self.assertIn("Nothing to compare", text)
        self.assertNotIn("###", text)

    def test_the_kept_documents_are_of_the_kept_results(self):
        documents = list((ROOT / "docs/results").glob("*/speed.md"))
        self.assertTrue(documents)
        for document in documents:
            with self.subTest(document=document.parent.name), tempfile.TemporaryDirectory() as folder:
                out = Path(folder) / "out.md"
                subprocess.run([sys.executable, TOOL, document.parent / "sweep/results.json", out], check=True)
                self.assertEqual(out.read_text(), document.read_text())

    def test_refuses_what_is_no_sweep(self):
        with tempfile.TemporaryDirectory() as folder:
            path, out = Path(folder) / "results.json", Path(folder) / "out.md"
            for bytes_ in (b"{", b"[]", b'{"backends": [{}]}', b"[{}]", b"\xff"):
                path.write_bytes(bytes_)
                with self.subTest(bytes=bytes_):
                    done = subprocess.run([sys.executable, TOOL, path, out], capture_output=True, text=True)
                    self.assertEqual(done.returncode, 1)
                    self.assertIn("speed:", done.stderr)
                    self.assertNotIn("Traceback", done.stderr)
                    self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
