#!/usr/bin/env python3
"""Tests of benchmark/report/coverage.py: ratios, and missing rows."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark" / "report"))
import coverage


def row(technique, n, c, error, ms, preset="", cost=1):
    return {"technique": technique, "n": n, "c": c, "shadingCost": cost, "preset": preset, "tiers": {},
            "errorReference": {"mseTm": error, "mse": 10 * error}, "frameMs": {"turns": [ms, 2 * ms, ms]},
            "temporal": {"variance": 3 * error, "biasSquared": 4 * error}, "materialsPerPixel": 3.5, "eventsPerPixel": 1.25}


def document(*rows):
    scene = {"name": "a_b", "build": "1-x", "rows": list(rows)}
    return coverage.document([{"size": "1x1", "rounds": 3, "backends": [
        {"backend": "vk", "device": "d", "driver": "e", "scenes": [scene]}]}])


class Coverage(unittest.TestCase):
    def test_errors_are_by_those_of_ssaa(self):
        text = document(row("ssaa", 8, 0, 0.4, 10), row("dcaa", 64, 4, 0.2, 30), row("dcaa", 64, 4, 0.1, 50, "exact"))
        self.assertEqual(text.count("| scene | `dcaa` S=4 | all fragments |"), 4)
        self.assertEqual(text.count("| a\\_b | 0.50 | 0.25 |"), 4)
        self.assertIn("| a\\_b | 3.50 | 1.25 | 1.25 | 1.25 |", text)

    def test_times_are_of_the_same_turn_and_cost(self):
        text = document(row("ssaa", 8, 0, 0.4, 10), row("dcaa", 64, 4, 0.2, 30), row("dcaa", 64, 4, 0.2, 40, cost=4),
                        row("ssaa", 8, 0, 0.4, 80, cost=4))
        self.assertIn("| a\\_b | 3.00 (3.00 to 3.00) | not measured | 0.50 (0.50 to 0.50) | not measured |", text)

    def test_scenes_without_the_rows_are_left_out(self):
        self.assertIn("No scene has the rows.", document(row("ssaa", 8, 0, 0.4, 10)))


if __name__ == "__main__":
    unittest.main()
