"""Tests benchmark/estimate.py: its bytes, its bounds and the kept page."""
import json
import os
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark"))

import estimate  # noqa: E402
from compiled import Figures  # noqa: E402
from runs import ask_json  # noqa: E402

HARNESS = os.environ["AGAA_HARNESS"]
GPU = estimate.Gpu(lanes_per_second=1e9, bytes_per_second=1e9, samples_per_second=1e9)
FIGURES = Figures(vgprs=64, spilled=0, scratch=0, waves=8, instructions=100, lds=0)
PLAN = {"samples": 8, "passes": [], "lanes": "sample-shared"}
COUNTERS = {"shadingEvents": 20, "lightEvaluations": 60, "severalEvents": 5, "shadedPixels": 8}


class Bytes(unittest.TestCase):
    def test_are_those_of_the_price(self):
        for configuration in estimate.CONFIGURATIONS:
            arguments = ["--size", "64x64", *estimate.options_of(configuration)]
            plan = ask_json(HARNESS, "plan", *arguments)
            price = ask_json(HARNESS, "price", *arguments)["view"]
            surfaces = [(name, size) for one in estimate.pass_bytes(plan) for name, size in one.items()]
            total = sum(64 * 64 * size for name, size in surfaces if name != "output")
            self.assertAlmostEqual(total, price["trafficBytes"], delta=1, msg=configuration[0])


class Estimate(unittest.TestCase):
    def test_counts_each_further_light(self):
        times = estimate.estimate({"kind": "compute", "name": "shade samples"}, PLAN, {"a": 3}, FIGURES, COUNTERS, 10, GPU)
        # Two events and six lights per pixel: two lights are part of the instructions that run once.
        self.assertAlmostEqual(times["arithmetic"], 2 * 100 + 4 * estimate.LIGHT_LOOP)
        self.assertAlmostEqual(times["memory"], 3)

    def test_passes_share_the_events_of_a_frame(self):
        for names in (("shade single primitives", "aggregate and shade"), ("shade first samples", "shade further samples")):
            plan = dict(PLAN, passes=[{"name": name} for name in names])
            first, second = (estimate.work_of(name, plan, COUNTERS, 10) for name in names)
            self.assertAlmostEqual(first.events + second.events, 2)
            self.assertAlmostEqual(first.lights + second.lights, 6)

    def test_lanes_of_samples_evaluate_the_lights_of_events(self):
        times = estimate.estimate({"kind": "compute", "name": "aggregate and shade"}, PLAN, {}, FIGURES, COUNTERS, 10, GPU)
        self.assertAlmostEqual(times["arithmetic"], 8 * 100 + 4 * estimate.LIGHT_LOOP)

    def test_lanes_of_samples_run_each(self):
        times = estimate.estimate({"kind": "compute", "name": "define aggregates"}, PLAN, {}, FIGURES, COUNTERS, 10, GPU)
        self.assertAlmostEqual(times["arithmetic"], 8 * 100)

    def test_draws_write_each_sample_of_each_target(self):
        one = {"kind": "host-draw", "name": "gbuffer", "writes": ["a", "b", "depth"]}
        self.assertAlmostEqual(estimate.estimate(one, PLAN, {}, None, COUNTERS, 10, GPU)["rasterisation"], 8 * 3)

    def test_the_largest_time_bounds(self):
        plan = {"width": 10, "height": 1, "samples": 1, "resources": [], "passes": [
            {"kind": "fill", "name": "clear", "reads": [], "writes": ["a"], "traffic": {"a": 40}},
            {"kind": "compute", "name": "shade samples", "reads": ["a"], "writes": ["output"], "traffic": {"a": 40}}]}
        rows = estimate.rows_of(("x", "y", []), plan, {("y", "shade samples"): FIGURES}, COUNTERS)
        self.assertEqual([row["bound"] for row in rows], ["memory", "arithmetic"])
        self.assertEqual([row["bytes"] for row in rows], [4, 4 + estimate.OUTPUT_BYTES])


    def test_passes_of_equal_names_count_each(self):
        clears = [{"kind": "fill", "name": "clear", "reads": [], "writes": [name], "traffic": {name: size}}
                  for name, size in (("a", 40), ("b", 120))]
        plan = {"width": 10, "height": 1, "samples": 1, "resources": [], "passes": clears}
        rows = estimate.rows_of(("x", "y", []), plan, {}, COUNTERS)
        self.assertEqual([row["bytes"] for row in rows], [4, 12])
        self.assertEqual([row["share"] for row in rows], [0.25, 0.75])


class Page(unittest.TestCase):
    def test_is_current(self):
        kept = json.loads((estimate.RESULTS / "estimate.json").read_text())
        page = estimate.document(kept, estimate.plans_of(HARNESS), estimate.compiled_figures())
        self.assertEqual((estimate.RESULTS / "estimate.md").read_text(), page, "benchmark/estimate.py --table")


if __name__ == "__main__":
    unittest.main()
