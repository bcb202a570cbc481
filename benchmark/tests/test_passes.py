#!/usr/bin/env python3
"""Tests of benchmark/passes.py: the page, and that the kept page is current."""

import json
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark"))
import passes


def row(technique, samples, times, backend="vk", aggregates=0, tier="", scene="metal"):
    return {"backend": backend, "device": "d", "driver": "e", "scene": scene, "size": "8x8", "technique": technique,
            "samples": samples, "aggregates": aggregates, "tiers": {"generation": tier} if tier else {}, "bytesPerPixel": 20.4,
            "shadingEventsPerCoveredPixel": 1.25,
            "passes": [{"name": name, "ms": {"median": ms, "p95": ms}} for name, ms in times.items()]}


class Page(unittest.TestCase):
    def test_sums_passes_and_compares_with_ssaa(self):
        lines = passes.pass_table([row("ssaa", 8, {"gbuffer": 3, "shade": 1}),
                              row("agaa", 8, {"prepass": 1, "clear": 0.5, "generate": 1.5}, aggregates=2, tier="per-sample")])
        self.assertEqual(lines[2:], [
            "| `ssaa`, 8 | 4.000 | 1.00 | gbuffer 3.000, shade 1.000 | 20 | 1.25 |",
            "| `agaa`, 8, 2 by per-sample | 3.000 | 0.75 | generate 1.500, prepass 1.000 | 20 | 1.25 |"])

    def test_compares_with_nothing_where_ssaa_is_missing(self):
        self.assertIn("| 12.0 | – |", passes.pass_table([row("dcaa", 64, {"fragments": 12}, aggregates=4, tier="lists")])[2])

    def test_each_scene_and_backend_has_a_table(self):
        page = passes.document({"command": "benchmark/passes.py", "note": "A note.",
                                "rows": [row("ssaa", 8, {"a": 1}), row("ssaa", 8, {"a": 2}, "gl"),
                                         row("ssaa", 8, {"a": 2}, scene="city")]})
        self.assertIn("`benchmark/passes.py`. A note.", page)
        self.assertEqual([line for line in page.splitlines() if line.startswith("## ")],
                         ["## metal, 8x8, vk: d (e)", "## metal, 8x8, gl: d (e)", "## city, 8x8, vk: d (e)"])

    def test_the_kept_pages_follow_from_their_results(self):
        kept = sorted((ROOT / "docs" / "results").glob("*/passes.json"))
        self.assertTrue(kept)
        for file in kept:
            self.assertEqual(file.with_suffix(".md").read_text(), passes.document(json.loads(file.read_text())), file)

    def test_options_name_what_a_row_has(self):
        self.assertEqual(passes.options("single", 1), ["--technique", "single", "--samples", 1])
        self.assertEqual(passes.options("dcaa", 64, 4, "lists")[-4:], ["--aggregates", 4, "--tier", "generation=lists"])


if __name__ == "__main__":
    unittest.main()
