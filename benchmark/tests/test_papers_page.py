"""Tests that docs/papers.md is what benchmark/papers.py prints of the kept results, and its verdicts."""
import json
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark"))
import papers  # noqa: E402
import papers_adaptive  # noqa: E402
import papers_agaa  # noqa: E402
import papers_claims as claims  # noqa: E402

RESULTS = ROOT / "docs/results/lavapipe/papers.json"


def scenes(*values, group="g", row="a", base="b", other=1.0):
    """Results in which the row has these errors, and the base another in all scenes."""
    return {"scenes": [{"scene": str(k), group: {row: {"mseTm": value}, base: {"mseTm": other}}}
                       for k, value in enumerate(values)]}


class Page(unittest.TestCase):
    def test_is_what_the_tool_prints(self):
        command = [sys.executable, ROOT / "benchmark/papers.py", "page", RESULTS]
        printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        self.assertEqual((ROOT / "docs/papers.md").read_text(), printed, "benchmark/papers.py page … > docs/papers.md")

    def test_bad_results_are_refused_in_a_sentence(self):
        for path in (ROOT / "missing.json", ROOT / "docs/papers.md"):
            done = subprocess.run([sys.executable, ROOT / "benchmark/papers.py", "page", path], capture_output=True, text=True)
            self.assertNotEqual(done.returncode, 0)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def test_results_have_all_rows_and_plans(self):
        data = json.loads(RESULTS.read_text())
        self.assertEqual(set(data["bytesPerPixel"]), set(papers.PLANS))
        for scene in data["scenes"]:
            for name, group in papers.GROUPS.items():
                self.assertEqual(set(scene[name]), set(group.rows), (scene["scene"], name))

    def test_every_verdict_is_one_of_four(self):
        data = json.loads(RESULTS.read_text())
        for section in papers.SECTIONS:
            for place, claim, found in section.CLAIMS:
                self.assertIn(found(data)[1], (claims.HOLDS, claims.PART, claims.FAILS, claims.UNMEASURED), (place, claim))


class Verdicts(unittest.TestCase):
    def test_shares_of_scenes(self):
        self.assertEqual([claims.verdict_of_share(k, 4) for k in (4, 3, 2, 0)],
                         [claims.HOLDS, claims.PART, claims.FAILS, claims.FAILS])

    def test_saved_memory(self):
        claim = papers_agaa.saved_claim("a", "b", 40)
        for ours, expected in ((62, claims.HOLDS), (80, claims.PART), (110, claims.FAILS)):
            self.assertEqual(claim({"bytesPerPixel": {"a": ours, "b": 100}})[1], expected)

    def test_low_numbers_and_decibels(self):
        self.assertEqual([claims.verdict_at_most(ours, 100) for ours in (50, 105, 125, 126)],
                         [claims.HOLDS, claims.HOLDS, claims.PART, claims.FAILS])
        self.assertEqual([claims.verdict_of_decibels(ours, 90) for ours in (89, 84, 83)],
                         [claims.HOLDS, claims.PART, claims.FAILS])

    def test_errors_and_steps(self):
        below = claims.errors_claim("g", "a", "b", "ratio")
        self.assertEqual([below(scenes(*values))[1] for values in ((0.5, 0.9), (0.5, 0.5, 2), (0.5, 2))],
                         [claims.HOLDS, claims.PART, claims.FAILS])
        self.assertEqual(claims.steps_claim("g", ["b", "a"], "ratio")(scenes(0.5, 1.5))[1], claims.FAILS)

    def test_the_same_error(self):
        same = claims.same_claim("g", "a", "b", "ratio")
        self.assertEqual([same(scenes(*values))[1] for values in ((1, 0.9995), (1, 1, 1.01), (1, 0.99))],
                         [claims.HOLDS, claims.PART, claims.FAILS])

    def test_shadow_taps_are_similar_up_to_a_quarter_more_error(self):
        for (_, _, found), row in zip(papers_agaa.shadow_claims(), ("along depth", "stored depth")):
            verdicts = [found(scenes(*values, group="phong", row=f"agaa 2 {row}", base="agaa 2"))[1]
                        for values in ((0.9, 1.2), (1.2, 1.2, 1.3), (1.3, 1.3))]
            self.assertEqual(verdicts, [claims.HOLDS, claims.PART, claims.FAILS], row)

    def test_light_lowers_errors_and_its_events_are_named(self):
        for values, expected in (((0.5, 0.9), claims.HOLDS), ((0.5, 0.5, 2), claims.PART), ((2, 2), claims.FAILS)):
            data = scenes(*values, group="grid 3x3", row="light", base="default")
            for scene in data["scenes"]:
                scene["grid 3x3"]["light"]["events"], scene["grid 3x3"]["default"]["events"] = 110, 100
            text, verdict = papers_adaptive.light_claim(data)
            self.assertEqual(verdict, expected)
            self.assertIn("110 % of the shading events", text)

    def test_decibels_are_those_of_the_adaptive_paper(self):
        for _, mse, decibels, _ in papers_adaptive.TABLE:
            self.assertAlmostEqual(claims.decibels(float(mse)), decibels, delta=0.02)


if __name__ == "__main__":
    unittest.main()
