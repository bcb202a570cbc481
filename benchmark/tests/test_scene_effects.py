#!/usr/bin/env python3
"""Tests of benchmark/scene_effects.py: the tables that it makes of results."""

import json
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import scene_effects


def counts(passes, size, events, taps, lights):
    return {"passes": passes, "bytesPerPixel": size, "events": events, "taps": taps, "lights": lights,
            "tapsPerEvent": taps / events, "lightsPerEvent": lights / events}


def scene(ratio, lights):
    less = counts(4, 100.0, 10, 0, 10)
    more = counts(5, 100.5, 10, 40, lights)
    effects = {name: {"with": more, "without": less, "ratio": ratio} for name, _, _ in scene_effects.EFFECTS}
    effects["bare"] = {"with": more, "without": less, "ratio": 2 * ratio}
    early_out = {"short": more, "long": counts(5, 100.5, 10, 80, 2 * lights), "largest": 0, "mse": 0, "ratio": 1.5}
    short = {"uncovered pixels": {"share": 0.25}, "pixels of one aggregate": {"share": 0.5}}
    return {"effects": effects, "short": {**short, **{name: early_out for name, _ in scene_effects.SWITCHABLE_EARLY_OUTS}},
            "normals": {name: ratio / 1e5 for name, _ in scene_effects.NORMALS}}


class SceneEffects(unittest.TestCase):
    def setUp(self):
        self.results = {"device": "D", "driver": "E", "size": "320x180",
                        "scenes": {"metal": scene(1.25, 20), "city": scene(1.75, 30)}}

    def test_the_kept_page_follows_from_its_results(self):
        kept = Path(__file__).resolve().parents[2] / "docs" / "results" / "lavapipe" / "effects" / "effects.json"
        self.assertEqual(kept.with_suffix(".md").read_text(), scene_effects.page(json.loads(kept.read_text())))

    def test_effects_are_differences_and_ratios(self):
        text = scene_effects.page(self.results)
        self.assertIn("| `specular` | +1 | +0.5 |  | +4 | +1 to +2 | 1.50 (1.25 to 1.75) |", text)
        self.assertIn("| all but diffuse sun light | +1 |", text)
        self.assertIn("| specular | 1.25 | 1.75 |", text)

    def test_short_ways_are_shares(self):
        text = scene_effects.page(self.results)
        self.assertIn("| uncovered pixels, share | 0.25 | 0.25 | |", text)
        self.assertIn("| flat aggregate: one shadow lookup | no |", text)
        name = scene_effects.SWITCHABLE_EARLY_OUTS[1][0]
        self.assertIn(f"| {name}: light evaluations with it | 0.50 | 0.50 | 0 |", text)
        self.assertIn(f"| {name}: frame without it | 1.50 | 1.50 | 0 |", text)

    def test_normals_are_errors(self):
        text = scene_effects.page(self.results)
        for name, _ in scene_effects.NORMALS:
            self.assertIn(f"| {name} | 1.3e-05 | 1.7e-05 |", text)

    def test_times_have_the_names_of_prices(self):
        times = scene_effects.times_file(self.results)
        self.assertEqual(times["device"], "D")
        self.assertEqual(times["effects"]["specular"]["ratio"], 1.5)
        self.assertFalse([name for name in times["effects"] if " " in name])


if __name__ == "__main__":
    unittest.main()
