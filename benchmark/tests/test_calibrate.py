"""Tests that `choose --measured` chooses by the measurements of calibrate.py."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import harness

TOOL = pathlib.Path(__file__).resolve().parents[1] / "calibrate.py"
VIEW = ["--scene", "city", "--size", "48x32"]


class RoundTrip(unittest.TestCase):
    def test_choices_have_the_measured_errors_and_times(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, TOOL, "--harness", harness.HARNESS, "--out", folder, *VIEW, "--spp", "8",
                            "--row", "ssaa-4", "--row", "agaa-8-fast-gbuffer"], check=True, capture_output=True)
            path = pathlib.Path(folder) / "measured.json"
            rows = {row["technique"]: row for row in json.loads(path.read_text())["measured"]}
            self.assertEqual(set(rows), {"single", "ssaa", "agaa"})
            self.assertEqual(rows["single"]["errorShare"], 1)
            for row in rows.values():
                self.assertEqual(row["pixels"], 48 * 32)
                self.assertGreater(row["geometryMs"], 0)
                self.assertGreater(row["shadingMs"], 0)
            self.assertLess(rows["ssaa"]["errorShare"], 1)
            best = min(rows.values(), key=lambda row: row["errorShare"])
            choice = harness.data("choose", *VIEW, "--measured", str(path), "--prefer", "error")
            self.assertEqual(choice["technique"], best["technique"])
            self.assertAlmostEqual(choice["errorShare"], best["errorShare"], places=5)
            self.assertAlmostEqual(choice["milliseconds"], best["geometryMs"] + best["shadingMs"], delta=1e-4 * choice["milliseconds"])


if __name__ == "__main__":
    unittest.main()
