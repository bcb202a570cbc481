#!/usr/bin/env python3
"""Tests of benchmark/motion.py: the page, and that the kept page is current."""

import json
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark"))
import motion


def view(name, moves, change=None):
    rows = []
    for number, row_name in enumerate(motion.ROWS):
        row = {"name": row_name, "error": 0.02 / (1 + number), "flicker": 0.1, "ghosting": None, "sharpness": 0.8, "frameMs": 10 + number,
               "bytesPerPixel": 20.4}
        rows.append({**row, **(change or {})})
    return {"name": name, "motion": moves, "backend": "vk", "device": "d", "frames": 64, "spp": 32, "disoccluded": 0.015,
            "referenceMseTm": 0.001, "rows": rows}


class Page(unittest.TestCase):
    def test_rows_are_by_those_of_single(self):
        lines = motion.motion_table(view("metal", "still"))
        self.assertEqual(lines[0], "| view | error | flicker | sharpness | time | bytes per pixel |")
        self.assertEqual(lines[2], "| single | 1.000 | 100.0 | 0.80 | 1.00 | 20 |")
        self.assertEqual(lines[3], "| fxaa | 0.500 | 100.0 | 0.80 | 1.10 | 20 |")

    def test_ghosts_and_lights_have_columns_where_they_occur(self):
        self.assertIn("| ghosting |", motion.motion_table(view("bamboo", "pass", {"ghosting": 0.5}))[0])
        lines = motion.motion_table(view("metal", "light", {"response": [0.5, 0.7, 0.85, 0.9, 0.92]}))
        self.assertIn("| light: first frame, frames |", lines[0])
        self.assertIn("| 0.50, 2 |", lines[2])

    def test_the_share_of_new_surfaces_stands_above_its_table(self):
        page = motion.document("8x8", [view("sh3d_foliage", "pass", {"ghosting": 0.5}), view("metal", "still")])
        self.assertIn("## sh3d\\_foliage, pass, Vulkan\n\nThe references' error is 0.050 of that of `single`.\n1.5 % of the pixels", page)
        self.assertEqual(page.count("of the pixels show"), 1)

    def test_chosen_scenes_and_motions_make_pairs(self):
        self.assertEqual(motion.chosen(None, None), motion.MOTIONS)
        self.assertEqual(motion.chosen(["city"], ["walk", "pass"]), [("city", "walk"), ("city", "pass")])

    def test_the_kept_page_follows_from_its_results(self):
        folder = ROOT / "docs/results/lavapipe/motion"
        kept = json.loads((folder / "motion.json").read_text())
        self.assertEqual((folder / "motion.md").read_text(), motion.document(kept["size"], kept["views"]))


if __name__ == "__main__":
    unittest.main()
