#!/usr/bin/env python3
"""Tests of benchmark/compiled.py: figures, the page, and that the kept page is current."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark"))
import compiled
import compiled_bounds
from compiled import Figures
from compiled_bounds import KnownMiss

GOOD = Figures(128, 0, 0, 4, 900, 16384)


def line(name, vgprs=88, spilled=0, scratch=0, waves=10, instructions=900, lds=512, size=64):
    return {"name": name, "Subgroup size": size, "VGPRs": vgprs, "Spilled VGPRs": spilled, "Scratch size": scratch,
            "Subgroups per SIMD": waves, "Instructions": instructions, "LDS size": lds}


def row(configuration, name="shade", navi21=GOOD, vega10=GOOD):
    return {"configuration": configuration, "pass": name, "navi21": navi21, "vega10": vega10}


class Page(unittest.TestCase):
    def test_scratch_is_of_a_lane_and_waves_have_64_lanes(self):
        statistics = line("agaa shade", scratch=64 * 432, waves=10)
        self.assertEqual(compiled.figures_of(statistics, "navi21"), (88, 0, 432, 5, 900, 512))
        self.assertEqual(compiled.figures_of(statistics, "vega10").waves, 10)

    def test_variants_of_a_pass_have_the_largest_figures(self):
        lines = [line("agaa shade", vgprs=80, waves=6), line("shadows"), line("agaa shade", vgprs=72, waves=4, lds=1024)]
        self.assertEqual(compiled.passes_of(lines, "vega10"), {"shade": (80, 0, 0, 4, 900, 1024)})

    def test_names_of_configurations_differ(self):
        names = [configuration.name for configuration in compiled.configurations()]
        self.assertEqual(len(names), len(set(names)))
        self.assertIn("agaa ids n=8 c=2", names)

    def test_page_has_passes_misses_and_refusals(self):
        rows = [row("ssaa n=8"), row("agaa ids n=8 c=2", navi21=GOOD._replace(vgprs=136, lds=1024)),
                row("agaa ids n=8 c=4", vega10=GOOD._replace(scratch=1232)), {"configuration": "msaa n=64", "refusal": "Why."}]
        page = compiled.document({"driver": "RADV 1", "chips": ["navi21", "vega10"], "rows": rows})
        self.assertIn("without a GPU:\nRADV 1.", page)
        self.assertIn("| shade | agaa ids | 2 | 136 | 0 | 1,232 | 16,384 |", page)
        self.assertIn("| ssaa n=8 | shade | 128 | 0 | 0 | 4 | 900 | 128 | 0 | 0 | 4 | 900 | 16,384 |", page)
        self.assertIn("* msaa n=64: Why.", page)

    def test_kept_results_are_read_as_written(self):
        results = {"driver": "RADV 1", "chips": ["navi21", "vega10"], "rows": [row("ssaa n=8"), row("ssaa n=16")]}
        text = compiled.kept_text(results)
        self.assertEqual(len(text.splitlines()), 4)
        self.assertEqual(compiled.read_kept(text), results)

    def test_kept_page_follows_from_its_results(self):
        kept = ROOT / "docs" / "results" / "compiled.json"
        results = compiled.read_kept(kept.read_text())
        self.assertEqual(kept.with_suffix(".md").read_text(), compiled.document(results))
        self.assertEqual(list(dict.fromkeys(row["configuration"] for row in results["rows"])),
                         [configuration.name for configuration in compiled.configurations()])


class Bounds(unittest.TestCase):
    def failures(self, rows, *known):
        return compiled_bounds.failures(rows, ["navi21", "vega10"], list(known))

    def test_each_bound_fails_by_itself(self):
        self.assertEqual(self.failures([row("ssaa n=8")]), [])
        for change in ({"vgprs": 132}, {"spilled": 1}, {"scratch": 16}, {"lds": 16896}):
            name, value = next(iter(change.items()))
            bound = compiled_bounds.BOUNDS[name]
            self.assertEqual(self.failures([row("ssaa n=8", vega10=GOOD._replace(**change))]),
                             [f"ssaa n=8, shade, vega10: {value} {name} of {bound}"])

    def test_known_misses_are_upper_bounds(self):
        known = KnownMiss("shade", "ssaa n=*", vgprs=200)
        self.assertEqual(self.failures([row("ssaa n=8", navi21=GOOD._replace(vgprs=200))], known), [])
        self.assertEqual(self.failures([row("ssaa n=8", navi21=GOOD._replace(vgprs=208))], known),
                         ["ssaa n=8, shade, navi21: 208 vgprs of 200"])
        self.assertEqual(len(self.failures([row("ssaa n=8", navi21=GOOD._replace(vgprs=200, spilled=1))], known)), 1)
        self.assertEqual(len(self.failures([row("agaa n=8", navi21=GOOD._replace(vgprs=200))], known)), 1)

    def test_known_misses_that_meet_the_bounds_fail(self):
        known = KnownMiss("shade", "ssaa n=*", vgprs=200)
        self.assertRegex(self.failures([row("ssaa n=8")], known)[0], r"^shade, ssaa n=\*: .* remove its row")
        self.assertEqual(self.failures([row("ssaa n=8"), row("ssaa n=16", vega10=GOOD._replace(vgprs=132))], known), [])
        self.assertEqual(self.failures([row("agaa n=8")], known), [])  # nothing of the row is compiled


if __name__ == "__main__":
    unittest.main()
