"""Tests that docs/effects.md is the output of benchmark/effects.py."""
import os
import pathlib
import subprocess
import sys
import unittest


class Page(unittest.TestCase):
    def test_is_what_the_tool_prints(self):
        root = pathlib.Path(__file__).resolve().parents[2]
        command = [sys.executable, root / "benchmark/effects.py", "--harness", os.environ["AGAA_HARNESS"]]
        printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        self.assertEqual((root / "docs" / "effects.md").read_text(), printed, "benchmark/effects.py > docs/effects.md")


if __name__ == "__main__":
    unittest.main()
