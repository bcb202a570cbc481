#!/usr/bin/env python3
"""Tests of benchmark/calibrate.py and goals.py: the results that they derive from measurements."""
import json
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import calibrate
import goals
from choice_rows import Candidate

SINGLE = Candidate("single", 1, 0, "", "")
SSAA = Candidate("ssaa", 8, 0, "", "")
FAST = Candidate("agaa", 8, 1, "fast", "gbuffer")
MEASURED = {SINGLE: {"error": 0.01, "geometryMs": 1.0, "shadingMs": 2.0},
            SSAA: {"error": 0.001, "geometryMs": 2.0, "shadingMs": 6.0},
            FAST: {"error": 0.002, "geometryMs": 2.0, "shadingMs": 3.0}}


def choice(row):
    return {"options": list(map(str, calibrate.options(row))), "errorShare": 0.1, "milliseconds": 7.0, "missedLimits": []}


class Calibration(unittest.TestCase):
    def test_settings_have_errors_by_that_of_single(self):
        fast = calibrate.measured_settings(MEASURED, "20x10")[2]
        self.assertEqual(fast, {"technique": "agaa", "preset": "fast", "samples": 8, "aggregates": 1, "tier": "gbuffer",
                                "pixels": 200, "errorShare": 0.2, "error": 0.002, "geometryMs": 2.0, "shadingMs": 3.0})

    def test_errors_without_times(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "measured.json"
            calibrate.write_measured(path, MEASURED, "20x10", has_times=False)
            self.assertEqual(json.loads(path.read_text())["measured"][1],
                             {"technique": "ssaa", "preset": None, "samples": 8, "aggregates": 0, "tier": None,
                              "errorShare": 0.1, "error": 0.001})

    def test_times_are_those_of_stages(self):
        stages = [("prepass", 1), ("definition", 2), ("generation", 4), ("shading", 8), ("other", 16)]
        passes = [{"stage": stage, "ms": {"median": ms}} for stage, ms in stages]
        self.assertEqual(calibrate.times(passes), {"geometryMs": 7, "shadingMs": 24})

    def test_the_median_of_turns(self):
        turns = [{"geometryMs": float(i), "shadingMs": 2.0 * i} for i in (9, 1, 2)]
        self.assertEqual(calibrate.middle(turns), turns[2])
        self.assertEqual(calibrate.middle(turns[:2]), turns[1])

    def test_rows_have_names(self):
        self.assertEqual([row.name for row in calibrate.wanted_rows(["ssaa-8"])], ["single-1", "ssaa-8"])
        with self.assertRaises(SystemExit):
            calibrate.wanted_rows(["ssaa-7"])


class Judgement(unittest.TestCase):
    def test_the_fastest_are_those_that_reach_the_target(self):
        found = goals.judge(MEASURED, 0.25, choice(SSAA))
        self.assertEqual((found["choice"], found["error"], found["ms"]), ("ssaa-8", 0.1, 8.0))
        self.assertEqual((found["fastestPreset"], found["fastest"], found["fastestMs"]), (FAST.name, FAST.name, 5.0))
        found = goals.judge(MEASURED, 0.15, choice(FAST))
        self.assertEqual((found["fastestPreset"], found["fastest"], found["fastestMs"]), (None, "ssaa-8", 8.0))
        self.assertIsNone(goals.judge(MEASURED, 0.05, choice(FAST))["fastest"])

    def test_the_summary(self):
        results = [{"scene": "s", "by": "table", **goals.judge(MEASURED, target, choice(row))}
                   for target, row in ((0.25, SSAA), (0.15, FAST), (0.05, SSAA))]
        text = goals.summary(results)
        self.assertIn("1 of 3 targets are reached; no settings reach 1.", text)
        self.assertIn("Errors are at most 1.33 times the target", text)
        self.assertIn("Choices take at most 1.60 times the time of the fastest preset", text)
        self.assertIn("| s | 0.05 | ssaa-8 | 0.100 | 0.100 | 2.00 | 7 | 8 | none |  | none |  |", goals.result_table(results))

    def test_a_moved_camera_aims_at_its_target(self):
        x, y, z, *others = goals.moved([1.0, 2.0, 10.0, 1.0, 2.0, 0.0, 50.0])
        self.assertEqual(others, [1.0, 2.0, 0.0, 50.0])
        self.assertAlmostEqual(abs(x - 1), 10 * goals.STEP)
        self.assertAlmostEqual(y, 2)
        self.assertAlmostEqual(z, 10)


if __name__ == "__main__":
    unittest.main()
