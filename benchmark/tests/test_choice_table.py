"""Tests that src/core/tuning/choice_table.inc is current, and that its coefficients fit the frames."""
import pathlib
import random
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark"))

import choice_rows
import choice_table
import shadow_taps
from least_squares import nonnegative


class Table(unittest.TestCase):
    def test_is_what_the_tool_prints(self):
        printed = subprocess.run([sys.executable, ROOT / "benchmark/choice_table.py"], check=True, capture_output=True,
                                 text=True).stdout
        self.assertEqual((ROOT / "src/core/tuning/choice_table.inc").read_text(), printed,
                         "benchmark/choice_table.py > src/core/tuning/choice_table.inc")


class Rows(unittest.TestCase):
    def test_what_needs_structs_of_its_own_is_left_out(self):
        def row(technique, preset="", tier=None):
            return {"technique": technique, "preset": preset, "tiers": {"generation": tier} if tier else {}}

        for kept in (row("ssaa"), row("agaa", "accurate", "gbuffer"), row("agaa", tier="ids"), row("dcaa", tier="lists"),
                     row("agaa", tier="fragments"), row("adaptive")):
            self.assertTrue(choice_rows.is_for_hosts(kept), kept)
        for left in (row("taa"), row("dcaa", "lean"), row("adaptive", "device"), row("dcaa", tier="material-lists"),
                     row("agaa", "paper")):
            self.assertFalse(choice_rows.is_for_hosts(left), left)


class LeastSquares(unittest.TestCase):
    def test_finds_the_coefficients(self):
        numbers = random.Random(1)
        rows = [{"a": 1.0, "b": numbers.random(), "c": numbers.random()} for _ in range(40)]
        found = nonnegative(rows, [3 * row["a"] + 5 * row["b"] + 0.5 * row["c"] for row in rows])
        for name, value in (("a", 3), ("b", 5), ("c", 0.5)):
            self.assertAlmostEqual(found[name], value, places=4)

    def test_no_coefficient_is_negative(self):
        rows = [{"a": 1.0, "b": x / 10} for x in range(10)]
        found = nonnegative(rows, [3 - row["b"] for row in rows])
        self.assertEqual(found["b"], 0)
        self.assertGreater(found["a"], 2)
        self.assertLess(found["a"], 3)

    def test_known_parts_are_left_out(self):
        numbers = random.Random(2)
        rows = [{"a": 1.0, "b": numbers.random()} for _ in range(40)]
        known = [numbers.random() for _ in rows]
        found = nonnegative(rows, [3 * row["a"] + 5 * row["b"] + part for row, part in zip(rows, known)], known)
        self.assertAlmostEqual(found["a"], 3, places=4)
        self.assertAlmostEqual(found["b"], 5, places=4)

    def test_a_column_that_is_always_zero(self):
        self.assertEqual(nonnegative([{"a": 1.0, "b": 0.0}], [2.0]), {"a": 2.0, "b": 0.0})


# The coefficients of the frames below, in nanoseconds.
LIGHT, TAP, PIXEL, EVENT = 10.0, 25.0, {1: 40.0, 8: 300.0}, {1: 70.0, 8: 150.0}


def row(technique, n, events, coverage, geometry, cost=1):
    taps = n * coverage  # one for each sample, as many as pixels and coverage tell
    shading = PIXEL[n] + events * (EVENT[n] + LIGHT * 17 * cost) + TAP * taps
    return {"technique": technique, "n": n, "c": 0, "preset": "", "tiers": {"visibility": "native"}, "shadingCost": cost,
            "eventsPerPixel": events, "shadowTapsPerPixel": taps, "errorReference": {"mseTm": 0.1 / n},
            "stageMs": {"generation": geometry * 1e-6 * 100, "shading": 0.9 * shading * 1e-6 * 100,
                        "other": 0.1 * shading * 1e-6 * 100}}


def sweep():
    found = []
    for i in range(10):
        coverage, geometry, complexity = 0.1 + 0.09 * i, 100 + 37 * (i * 7 % 10), 0.05 * (i * 3 % 10)
        events = coverage * (1 + 7 * complexity)
        found.append({"name": f"scene{i}", "plain": False, "lights": 17, "build": "test", "rows": [
            row("single", 1, coverage, coverage, geometry),
            row("simple_complex", 8, events, coverage, 2 * geometry + 50),
            row("simple_complex", 8, events, coverage, 2 * geometry + 50, cost=4)]})
    return {"size": "10x10", "backends": [{"device": "none", "scenes": found}]}


class Model(unittest.TestCase):
    def setUp(self):
        results = sweep()
        self.rows = choice_rows.candidates(results)
        self.costs = choice_table.Costs(results, self.rows)
        self.model = choice_table.Model(self.costs, self.rows, TAP / LIGHT)

    def test_finds_the_costs_of_the_frames(self):
        single, complex8 = self.rows
        self.assertAlmostEqual(self.model.geometry[complex8][0], 2, places=3)
        self.assertAlmostEqual(self.model.geometry[complex8][1], 50, places=0)
        self.assertAlmostEqual(self.model.shading["light"], LIGHT, places=1)
        self.assertAlmostEqual(self.model.shading["tap"], TAP, places=0)
        for found, n in ((single, 1), (complex8, 8)):
            self.assertAlmostEqual(self.model.shading[found.name, "pixel"], PIXEL[n], delta=1)
            self.assertAlmostEqual(self.model.shading[found.name, "event"], EVENT[n], delta=1)
            self.assertLess(max(self.model.fit_error(found)), 0.001)

    def test_more_lookups_cost_more(self):
        for found in self.rows:
            self.assertGreater(self.model.shading_time(found, 1, 17, 8), self.model.shading_time(found, 1, 17, 1))

    def test_finds_the_complexity(self):
        for i, scene in enumerate(self.costs.scenes):
            self.assertAlmostEqual(self.costs.complexity(scene), 0.05 * (i * 3 % 10))
        self.assertAlmostEqual(self.model.events[self.rows[1]][0], 1, places=3)
        self.assertAlmostEqual(self.model.events[self.rows[1]][1], 7, places=3)


class ShadowTaps(unittest.TestCase):
    def test_the_ratio_is_that_of_the_counts(self):
        taps, lights, cost = 300, 500, shadow_taps.COST
        times = {"without": 12 + lights * 0.1, "with": 12 + lights * 0.1 + taps * 0.3,
                 "heavier": 12 + cost * lights * 0.1 + taps * 0.3}
        self.assertAlmostEqual(shadow_taps.ratio({"shadowTaps": taps, "lightEvaluations": lights, "processorMs": times}), 3)


if __name__ == "__main__":
    unittest.main()
