#!/usr/bin/env python3
"""Tests that compiled passes meet the bounds of benchmark/compiled_bounds.py, by compiling them for AMD GPUs.

AGAA_COMPILED=all compiles all configurations for all chips, otherwise COVERING for the first. The program exits with 77
where RADV cannot compile.
"""
import fnmatch
import os
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark"))
import compiled
import compiled_bounds

# Most techniques and tiers, and for each row of KNOWN_MISSES a configuration that misses a bound.
COVERING = [
    "fxaa n=1", "smaa n=1", "taa n=1", "msaa n=8", "ssaa n=32", "visibility n=32",
    "simple_complex n=32",
    "adaptive gbuffer n=9", "adaptive ids n=16", "adaptive ids n=32", "adaptive target gbuffer n=8",
    "sbaa per-sample n=16 c=4", "sbaa gbuffer n=32 c=4",
    "agaa per-sample n=32 c=4", "paper per-sample n=16",
    "accurate gbuffer n=8", "accurate gbuffer n=16", "accurate gbuffer n=32",
    "accurate ids n=8", "accurate ids n=16", "accurate ids n=32",
    "agaa buffered ids n=8 c=4", "agaa buffered ids n=32 c=4",
    "agaa fragments n=128 c=4", "balanced fragments n=64", "accurate fragments n=64",
    "dcaa lists n=64 c=4", "dcaa expanded lists n=64 c=4", "dcaa material-lists n=64 c=4",
    "dcaa exact material-lists n=64",
]


class Passes(unittest.TestCase):
    compiler = None

    def test_meet_their_bounds(self):
        self.maxDiff = None
        found = {configuration.name: configuration for configuration in compiled.configurations()}
        isAll = os.environ.get("AGAA_COMPILED") == "all"
        names, chips = (found, compiled.CHIPS) if isAll else (COVERING, compiled.CHIPS[:1])
        rows = compiled.measure(self.compiler, [found[name] for name in names], chips)
        self.assertFalse([row for row in rows if "refusal" in row])
        self.assertEqual(compiled_bounds.failures(rows, chips), [])

    def test_known_misses_are_compiled(self):
        for row in compiled_bounds.KNOWN_MISSES:
            self.assertTrue(fnmatch.filter(COVERING, row.configurations), row)


if __name__ == "__main__":
    try:
        with compiled.Compiler(os.environ["AGAA_HARNESS"], Path(os.environ["AGAA_COMPILED_LAYER"])) as Passes.compiler:
            unittest.main()
    except compiled.Unavailable as reason:
        print(f"Skipped: {reason}.")
        sys.exit(77)
