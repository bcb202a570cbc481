#!/usr/bin/env python3
"""Tests of benchmark/renew_rows.py: which rows it replaces, and their times."""
import copy
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOOL = ROOT / "benchmark/renew_rows.py"
sys.path.insert(0, str(TOOL.parent))
import renew_rows


def times(ms):
    return {"median": ms, "p95": 2 * ms, "low": ms, "high": 2 * ms, "confidence": 0.75, "frames": 2, "turns": [ms, 2 * ms]}


def row(technique, n, c, ms, tier=None, cost=1):
    return {"technique": technique, "n": n, "c": c, "preset": "", "shadingCost": cost, "tiers": {"generation": tier} if tier else {},
            "frameMs": times(ms), "passes": [{"name": "shade", "stage": "shading", "ms": times(ms / 2)}], "stageMs": {"shading": ms / 2},
            "errorReference": {"mseTm": ms}}


def results(single, dcaa, build):
    scene = {"name": "metal", "build": build, "camera": "", "lights": 17, "triangles": 9, "reference": {"spp": 512}, "rows": [row("single", 1, 0, single), row("dcaa", 64, 4, dcaa, "lists"),
                                                       row("dcaa", 64, 4, 9 * dcaa, "lists", cost=4), row("agaa", 8, 2, 5, "ids")]}
    return {"size": "8x8", "backends": [{"backend": "vk", "device": "d", "driver": "e", "scenes": [scene]}]}


class Renewed(unittest.TestCase):
    def test_times_are_by_those_of_single(self):
        first, later = results(10, 100, "old"), results(20, 120, "new")
        before = copy.deepcopy(first)
        new = renew_rows.renew(first, later, ["dcaa-64-4"])
        rows = first["backends"][0]["scenes"][0]["rows"]
        self.assertEqual(new, [rows[1]])
        self.assertEqual(rows[1]["frameMs"], {**times(60), "confidence": 0.75, "frames": 2})
        self.assertEqual(rows[1]["passes"][0]["ms"]["turns"], [30, 60])
        self.assertEqual(rows[1]["stageMs"], {"shading": 30})
        self.assertEqual(rows[1]["errorReference"]["mseTm"], 120)
        self.assertEqual(rows[1]["build"], "new")
        others = before["backends"][0]["scenes"][0]["rows"]
        self.assertEqual([rows[i] for i in (0, 2, 3)], [others[i] for i in (0, 2, 3)])

    def test_a_row_is_added_that_is_absent(self):
        first, later = results(10, 100, "old"), results(20, 120, "new")
        before = copy.deepcopy(first)
        later["backends"][0]["scenes"][0]["rows"].append(row("sgbc", 64, 4, 50, "lists"))
        part = {**copy.deepcopy(first), "rows": ["dcaa-64-4"]}
        renew_rows.renew(part, later, ["sgbc-64-4", "agaa-8-2-ids"])
        self.assertEqual(part["rows"], ["dcaa-64-4", "sgbc-64-4"])
        new = renew_rows.renew(first, later, ["sgbc-64-4"])
        rows = first["backends"][0]["scenes"][0]["rows"]
        self.assertEqual(rows, before["backends"][0]["scenes"][0]["rows"] + new)
        self.assertEqual((new[0]["frameMs"]["median"], new[0]["build"]), (25, "new"))
        self.assertNotIn("rows", first)

    def test_names_may_have_a_cost_and_a_tier(self):
        first = results(10, 100, "old")
        renew_rows.renew(first, results(10, 200, "new"), ["dcaa-64-4-cost4", "agaa-8-2-ids"])
        rows = first["backends"][0]["scenes"][0]["rows"]
        self.assertEqual([each["frameMs"]["median"] for each in rows], [10, 100, 1800, 5])
        self.assertEqual([each.get("build") for each in rows], [None, None, "new", "new"])

    def test_images_are_copied(self):
        with tempfile.TemporaryDirectory() as folder:
            source, target = Path(folder) / "later", Path(folder) / "out"
            (source / "images").mkdir(parents=True)
            (source / "images/a.jpg").write_text("new")
            renew_rows.copy_images([{"image": "images/a.jpg", "heat": "images/none.jpg", "difference": None}], source, target)
            self.assertEqual([path.read_text() for path in target.rglob("*.jpg")], ["new"])
            renew_rows.copy_images([{"image": "images/a.jpg"}], source, source)

    def test_what_does_not_fit_is_said(self):
        def run(first, later, *names):
            with tempfile.TemporaryDirectory() as folder:
                paths = [Path(folder) / name for name in ("first.json", "later.json", "out.json")]
                for path, content in zip(paths, (first, later), strict=False):
                    path.write_text(json.dumps(content))
                done = subprocess.run([sys.executable, TOOL, *paths[:2], *names, paths[2]], capture_output=True, text=True, check=False)
                self.assertEqual(paths[2].exists(), done.returncode == 0)
                return done.stderr
        good = results(10, 100, "old")
        self.assertEqual(run(good, good, "dcaa-64-4"), "")
        self.assertIn("metal has 0 rows of the name dcaa-32-4, and 0 later ones", run(good, good, "dcaa-32-4"))
        self.assertIn("size differs, 8x8 and 9x9", run(good, {**good, "size": "9x9"}, "dcaa-64-4"))
        self.assertIn("lacks metal", run(good, {**good, "backends": []}, "dcaa-64-4"))
        for member, wrong in (("lights", 1), ("reference", {"spp": 4}), ("rows", [])):
            other = copy.deepcopy(good)
            other["backends"][0]["scenes"][0][member] = wrong
            self.assertRegex(run(good, other, "dcaa-64-4"), "^renew_rows: metal(: (lights|spp) differs| has 0 rows of single)")
        other = copy.deepcopy(good)
        other["backends"][0]["driver"] = "f"
        self.assertIn("vk: driver differs, e and f", run(good, other, "dcaa-64-4"))
        self.assertIn("usage:", run(good, good))


if __name__ == "__main__":
    unittest.main()
