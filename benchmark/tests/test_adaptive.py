#!/usr/bin/env python3
"""Tests of benchmark/adaptive.py: the tables that it makes of results."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import adaptive
import runs


def scene(name, share, mse):
    found = {"share": share, "mse": mse, "flip": 0, "events": 9 * share, "pixelsByEvents": [0] * 6}
    return {"scene": name, "errors": {side: {"device": "D", "driver": "E", "ways": {n: found for n, _ in adaptive.CONFIGURATIONS}}
                                      for side in adaptive.SIDES},
            "times": {cost: {"ssaa": 100 * cost, "simple_complex": 60 * cost, "adaptive": 50} for cost in adaptive.COSTS}}


class Adaptive(unittest.TestCase):
    def setUp(self):
        self.data = {"size": "320x180", "frames": 3, "turns": 3, "lights": "lights of a test",
                     "scenes": [scene("metal", 0.2, 1e-5), scene("city", 0.4, 1e-3)],
                     "shading": {"metal": {name: 10 * (i + 1) for i, (name, _) in enumerate(adaptive.SHADING)}}}

    def test_means_are_of_shares_and_decibels(self):
        text = adaptive.markdown(self.data)
        self.assertIn("| adaptive | 0.300 | 40.0 | 30.0 | 0.300 | 40.0 | 30.0 |", text)
        self.assertIn("| the paper, Sponza | 0.578 | 43.0 | – |", text)

    def test_times_are_ratios(self):
        text = adaptive.markdown(self.data)
        self.assertIn("| metal | 2.00 | 1.20 | 8.00 | 4.80 | 32.00 | 19.20 |", text)
        self.assertIn("| median | 2.00 | 1.20 |", text)
        self.assertIn("Evaluated are lights of a test.", text)
        self.assertIn("| loop | 2.00 |", text)

    def test_runs_go_on_where_they_stopped(self):
        with tempfile.TemporaryDirectory() as folder:
            settings = {"configurations": adaptive.CONFIGURATIONS}
            harness = Path(__file__)
            runs.Runs("adaptive", harness, Path(folder), settings).kept("metal", lambda: {"made": 1})
            again = runs.Runs("adaptive", harness, Path(folder), settings).kept("metal", lambda: {"made": 2})
            self.assertEqual(again, {"made": 1})
            with self.assertRaises(SystemExit):
                runs.Runs("adaptive", harness, Path(folder), {"configurations": []})

    def test_no_error_is_finite(self):
        self.assertEqual(adaptive.decibels(0), 120)


if __name__ == "__main__":
    unittest.main()
