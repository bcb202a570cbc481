"""Tests that docs/papers.md is what benchmark/papers.py prints of the kept results, and its verdicts."""
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark"))
import papers  # noqa: E402


class Page(unittest.TestCase):
    def test_is_what_the_tool_prints(self):
        results = ROOT / "docs/results/lavapipe/papers.json"
        command = [sys.executable, ROOT / "benchmark/papers.py", "page", results]
        printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        self.assertEqual((ROOT / "docs/papers.md").read_text(), printed, "benchmark/papers.py page … > docs/papers.md")

    def test_bad_results_are_refused_in_a_sentence(self):
        for path in (ROOT / "missing.json", ROOT / "docs/papers.md"):
            done = subprocess.run([sys.executable, ROOT / "benchmark/papers.py", "page", path], capture_output=True, text=True)
            self.assertNotEqual(done.returncode, 0)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)


class Verdicts(unittest.TestCase):
    def test_shares_of_scenes(self):
        self.assertEqual([papers.verdict_of_share(k, 4) for k in (4, 3, 2, 0)],
                         ["holds", "holds in part", "does not hold here", "does not hold here"])

    def test_saved_memory(self):
        claim = papers.saved_claim("a", "b", 35, 40)
        for ours, expected in ((62, "holds"), (80, "holds in part"), (110, "does not hold here")):
            self.assertEqual(claim({"bytesPerPixel": {"a": ours, "b": 100}})[1], expected)


if __name__ == "__main__":
    unittest.main()
