#!/usr/bin/env python3
"""Tests of benchmark/report/choosing.py: its choices follow from the results."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOOL = ROOT / "benchmark" / "report" / "choosing.py"
sys.path.insert(0, str(TOOL.parent))
import choosing
import choosing_adaptive
import choosing_gpu
import choosing_presets
import choosing_speed
import sweep_rows
from sweep_results import gpu_row


def row(technique, n, c, ms, error, size=100, cost=1, events=1.0, shading=1.0, deciding=0.0, merging=None):
    return {"technique": technique, "n": n, "c": c, "shadingCost": cost, "preset": "", "tiers": {},
            "frameMs": {"median": ms, "p95": ms}, "bytesPerPixel": size, "stageMs": {"shading": shading, "definition": deciding},
            "eventsPerCoveredPixel": events, "errorReference": {"mseTm": error},
            "errorSameSamples": None if merging is None else {"mseTm": merging}}


def scene(**more):
    return {"name": "metal", "reference": {"splitHalfMseTm": 1e-6}, "rows": [
        row("single", 1, 0, 100, 1e-2, 20),
        row("simple_complex", 8, 0, 300, 0.9e-3, 160, events=4, shading=180, deciding=20),
        row("simple_complex", 8, 0, 900, 0.9e-3, 160, cost=4, events=4, shading=800),
        row("agaa", 8, 2, 350, 0.905e-3, 90, events=2, shading=125, deciding=35, merging=3e-5),
        row("agaa", 8, 2, 650, 0.905e-3, 90, cost=4, events=2, shading=425, merging=3e-5),
        row("sbaa", 8, 2, 340, 1.2e-3, 100, merging=5e-5),
        row("sbaa", 8, 4, 390, 0.95e-3, 130, merging=2e-5),
        row("ssaa", 32, 0, 2000, 1e-4, 500)], **more}


class Choosing(unittest.TestCase):
    def setUp(self):
        self.scene = scene()

    def cells(self, lines):
        return [text.strip() for text in lines[2].strip("| ").split("|")]

    def answers(self, question):
        return choosing.by_scene([self.scene], *choosing.QUESTIONS[question][1:])

    def test_how_often(self):
        lines = choosing.how_often([self.scene, scene(name="city")])
        self.assertEqual(lines[2], "| error 1/4 of single's | simple\\_complex n=8 (2) |")
        self.assertEqual(len(lines), 2 + 10 + 1)
        self.scene["rows"] = self.scene["rows"][:1]
        self.assertIn("none (1)", choosing.how_often([self.scene, scene(name="city")])[2])

    def test_claims_beside_a_gpu(self):
        rows = [row("ssaa", 8, 0, 100, 1e-3), row("dcaa", 64, 4, 140, 1e-4), row("agaa", 8, 2, 110, 1e-3), row("msaa", 8, 0, 50, 1e-3)]
        for each, tier in zip(rows, ("", "lists", "ids", ""), strict=True):
            each["tiers"] = {"generation": tier} if tier else {}
        gpu = [gpu_row("metal", "ssaa", 8, 0, "", 3, 1), gpu_row("metal", "dcaa", 64, 4, "lists", 8), gpu_row("metal", "agaa", 8, 2, "ids", 2),
               gpu_row("metal", "dcaa", 64, 4, "lists", 1, way="compute"), gpu_row("metal", "msaa", 8, 0, "", 1, backend="gl"),
               gpu_row("city", "ssaa", 8, 0, "", 1)]
        cpu = {"backend": "vk", "device": "a CPU"}
        lines = choosing_gpu.lines([{"name": "metal", "rows": rows}], cpu, "8x8", [{"rows": gpu}])
        self.assertIn("| row | metal |", lines)
        self.assertIn("| agaa n=8 c=2 by id | 0.50 / 1.10 |", lines)
        self.assertIn("| msaa n=8 | – / 0.50 |", lines)
        self.assertIn("| `agaa` c=2 by id is faster than `ssaa` n=8 | 1 of 1 | 0 of 1 |", lines)
        self.assertIn("| `dcaa` takes at most 1.5 times as long as `ssaa` n=8 | 0 of 1 | 1 of 1 |", lines)
        self.assertIn("| `dcaa`, triangles by compute passes, takes at most 1.5 times as long as `ssaa` n=8 | 1 of 1 | – |", lines)
        self.assertIn("| `agaa` c=2 by id is faster than `simple_complex` n=8 | – | – |", lines)
        self.assertEqual(choosing_gpu.lines([{"name": "sh3d_foliage", "rows": rows}], cpu, "8x8", [{"rows": gpu}]), [])
        self.assertEqual(choosing_gpu.lines([{"name": "metal", "rows": rows}], {**cpu, "backend": "gl"}, "8x8", [{"rows": gpu}]), [])

    def test_a_tie_is_not_faster(self):
        rows = [row("ssaa", 8, 0, 100, 1e-3), row("simple_complex", 8, 0, 98, 1e-3)]
        gpu = [gpu_row("metal", "ssaa", 8, 0, "", 100), gpu_row("metal", "simple_complex", 8, 0, "", 96)]
        lines = choosing_gpu.lines([{"name": "metal", "rows": rows}], {"backend": "vk", "device": "a CPU"}, "8x8", [{"rows": gpu}])
        self.assertIn("| `simple_complex` n=8 is faster than `ssaa` n=8 | 1 of 1 | 0 of 1 |", lines)

    def test_losses_are_those_of_simple_complex(self):
        rows = [{"technique": technique, "n": 8, "c": 0, "shadingCost": 1, "tiers": {}, "preset": "",
                 "errorSameSamples": {"flip": flip, "flipP95": 4 * flip}}
                for technique, flip in (("sbaa", 0.5), ("simple_complex", 0.01234))]
        self.assertEqual(choosing.loss_rows([{"name": "city", "rows": rows}, {"name": "metal", "rows": rows[:1]}]),
                         [["city", "not measured", "0.0123, 0.0494", "not measured", "not measured"]])

    def test_presets_are_beside_the_papers_and_two_passes(self):
        rows = [row(technique, n, c, 500, far, 90, events=2.0) for n in (8, 32)
                for technique, c, far in (("agaa", 2, 3e-3), ("ssaa", 0, 16e-3 / n))]
        for i, (preset, n, by) in enumerate(choosing_presets.PRESETS):
            rows.append(row("agaa", n, 2, 400 - 20 * i, 1e-3, 90, events=1.5, merging=1e-3 / (i + 1)))
            rows[-1].update(preset=preset, tiers={"generation": by} if by else {})
        whole = scene(name="city", rows=[row("single", 1, 0, 100, 1e-2, 20)] + rows)
        table = choosing_presets.preset_rows(choosing_presets.preset_figures([self.scene, whole]))  # the other scene has none
        self.assertEqual((table[0][6], table[-1][6]), ("0.50 to 0.50", "2.00 to 2.00"))
        other = json.loads(json.dumps(whole))
        other["reference"]["splitHalfMseTm"] = 2e-4  # too large to distinguish 1e-3 from 2e-3
        self.assertEqual(choosing_presets.preset_rows(choosing_presets.preset_figures([whole, other]))[0][6], "0.50 to 1.00")
        self.assertEqual(table[0], ["paper", 8, "two passes", "0.1000", "0.1000", "0.100 (city)", "0.50 to 0.50", "1.50",
                                    "0.75", "0.80", "90"])
        self.assertEqual(table[1][:4] + table[1][9:10], ["fast", 8, "from a G-buffer", "0.0500", "0.76"])
        self.assertEqual([line[1] for line in table], [8] * 7 + [32] * 2)
        self.assertEqual(choosing_presets.preset_rows(choosing_presets.preset_figures([self.scene])), [])
        few = json.loads(json.dumps(whole))
        few["rows"] = [r for r in few["rows"] if r["preset"] in ("", "paper") and r["n"] != 32]
        self.assertEqual([line[:2] for line in choosing_presets.preset_rows(choosing_presets.preset_figures([self.scene, few]))], [["paper", 8]])

    def test_the_most_accurate_preset_by_its_aims(self):
        rows = [row("single", 1, 0, 100, 1e-2, 20), row("ssaa", 8, 0, 900, 2e-3), row("agaa", 8, 2, 500, 3e-3, events=2.0)]
        for preset, by, bias, merging in (("paper", None, 2e-5, 1e-3), ("accurate", "ids", 3e-5, 4e-5)):
            rows.append(row("agaa", 8, 4, 400, 1e-3, events=2.5, merging=merging))
            rows[-1].update(preset=preset, tiers={"generation": by} if by else {},
                            temporal={"biasSquared": bias, "variance": 1e-6, "referenceMseTm": 2e-6})
        whole = scene(name="city", rows=rows)
        text = choosing_presets.aim_sentences([whole], choosing_presets.preset_figures([whole]))
        self.assertEqual(text[0], "* `accurate` n=8 by id was to have: error at most 0.005 (0.0040, median 0.0040), "
                                  "no longer frame (0.80): it has; "
                                  "no more events than c=2 (1.25): it has not.")
        self.assertIn("1 of 2 above 1 (city 1.500); 2 gaps are below", text[1])
        rows[-1]["errorSameSamples"]["mseTm"] = 5.002e-5  # rounding would hide the failure
        text = choosing_presets.aim_sentences([whole], choosing_presets.preset_figures([whole]))
        self.assertIn("; error at most 0.005 (0.0050, median 0.0050), no more events", text[0])
        rows[-1]["temporal"]["biasSquared"] = 5e-5
        self.assertIn("1 of 2 above 1 (city 2.500); 1 gaps are below", choosing_presets.steady_sentence([whole]))
        self.assertIsNone(choosing_presets.steady_sentence([self.scene]))

    def test_adaptive_is_beside_its_rivals(self):
        self.assertEqual(choosing_adaptive.lines([self.scene]), [], "no row of it")
        rows = [row("ssaa", 8, 0, 400, 1e-3, events=8), row("adaptive", 8, 0, 200, 1e-3, events=2, merging=1e-5),
                row("simple_complex", 8, 0, 150, 1e-3, events=3, merging=1.5e-4), row("agaa", 8, 2, 300, 1.1e-3, events=1.5, merging=5e-5)]
        rows[3]["tiers"] = {"generation": "ids"}
        for each in rows:
            each["frameMs"]["turns"] = [each["frameMs"]["median"]] * 3
        whole = {"name": "city", "rows": rows}
        self.assertEqual(choosing_adaptive.quickest(whole, 1), "`adaptive`", "the error of simple_complex is too large")
        rows[2]["errorSameSamples"]["mseTm"] = 1e-5
        self.assertEqual(choosing_adaptive.quickest(whole, 1), "`simple_complex`")
        text = "\n".join(choosing_adaptive.lines([self.scene, whole]))
        self.assertIn("| city | 2.00 (2.00 to 2.00) | 0.75 (0.75 to 0.75) | 1.50 (1.50 to 1.50) |", text)
        self.assertIn("| city | 0.25 | 0.38 | 0.19 | not measured |", text)
        self.assertNotIn("Variance", text)

    def test_the_fastest_for_an_error(self):
        cells = self.cells(self.answers(0))
        self.assertEqual(cells[1], "simple\\_complex n=8 (3.00x, 0.09, 160 B)")
        self.assertEqual(cells[2], "simple\\_complex n=8 (3.00x, 0.09, 160 B)")
        self.assertEqual(cells[3], "ssaa n=32 (20.00x, 0.01, 500 B)")

    def test_gaps_that_the_reference_cannot_tell_are_none(self):
        self.assertIn("simple", self.cells(self.answers(1))[3])
        # simple_complex has the least error within 4x. The gap to agaa is below ten times the reference's error.
        for r in self.scene["rows"]:
            if r["technique"] == "agaa":
                r["frameMs"]["median"] -= 60
        self.assertIn("agaa n=8 c=2", self.cells(self.answers(1))[3])
        self.scene["reference"]["splitHalfMseTm"] = 1e-8
        self.assertIn("simple", self.cells(self.answers(1))[3])

    def test_memory_and_nothing_that_fits(self):
        cells = self.cells(self.answers(2))
        self.assertTrue(cells[1].startswith("single"))
        self.assertTrue(cells[2].startswith("agaa n=8 c=2"))
        self.scene["rows"] = [r for r in self.scene["rows"] if r["technique"] != "single"][:1] + [
            row("single", 1, 0, 100, 1e-2, 70)]
        self.assertEqual(self.cells(self.answers(2))[1], "none")

    def test_sources_of_materials_are_distinguished(self):
        for tier, ms in (("gbuffer", 250), ("ids", 200)):
            other = row("agaa", 8, 2, ms, 0.905e-3, 90, events=2, shading=125, merging=3e-5)
            other["tiers"] = {"generation": tier}
            self.scene["rows"].append(other)
        self.assertAlmostEqual(choosing_speed.ratios(self.scene, 8)["frame"], 300 / 350)
        self.assertAlmostEqual(choosing_speed.ratios(self.scene, 8, "gbuffer")["frame"], 300 / 250)
        self.assertAlmostEqual(choosing_speed.ratios(self.scene, 8, "ids")["frame"], 300 / 200)
        self.assertTrue(self.cells(self.answers(0))[1].startswith("agaa n=8 c=2 by id"))

    def test_ratios_and_the_cost_from_which_agaa_wins(self):
        ratios = choosing_speed.ratios(self.scene, 8)
        self.assertEqual(ratios, {"events": 2, "shading": 1.6, "efficiency": 0.8, "frame": 300 / 350, "grouping": 1.25})
        # 100 + 200 s against 250 + 100 s
        self.assertAlmostEqual(choosing_speed.win_cost(self.scene, 8)[1], 1.5)
        self.assertIsNone(choosing_speed.win_cost(self.scene, 32))
        agaa = sweep_rows.find(self.scene, "agaa", 8, 2, cost=4)
        heaviest = [row("simple_complex", 8, 0, 3300, 0.9e-3, cost=16), row("agaa", 8, 2, 2600, 0.9e-3, cost=16)]
        self.scene["rows"] += heaviest  # 100 + 200 s against 200 + 150 s
        self.assertAlmostEqual(choosing_speed.win_cost(self.scene, 8)[1], 2)
        self.scene["rows"].pop()
        self.assertAlmostEqual(choosing_speed.win_cost(self.scene, 8)[1], 1.5, msg="of those that both were measured at")
        agaa["frameMs"]["median"] = 1200  # no lighting is heavy enough
        self.assertEqual(choosing_speed.cost_text(self.scene, 8), "beyond 4")
        sweep_rows.find(self.scene, "agaa", 8, 2)["frameMs"]["median"] = 200  # shorter up to the largest measured cost
        agaa["frameMs"]["median"] = 850
        self.assertEqual(choosing_speed.cost_text(self.scene, 8), "any")
        agaa["frameMs"]["median"] = 250
        sweep_rows.find(self.scene, "agaa", 8, 2)["frameMs"]["median"] = 100
        self.assertEqual(choosing_speed.cost_text(self.scene, 8), "any")

    def test_what_was_not_measured_is_not_a_number(self):
        for r in self.scene["rows"]:
            r["stageMs"] = {"shading": 0}
            r["eventsPerCoveredPixel"] = 0
            r["errorReference"]["mseTm"] *= r["technique"] != "ssaa"
            if r["errorSameSamples"]:
                r["errorSameSamples"]["mseTm"] = 0
        text = choosing.document([{"size": "1x1", "backends": [{"backend": "gl", "device": "d", "driver": "e",
                                                                "scenes": [self.scene]}]}])
        self.assertIn("shading not measured", text)
        self.assertIn("ssaa n=32 (20.00x, 0, 500 B)", text)

    def test_what_merging_costs(self):
        self.assertEqual(choosing.merge_rows([self.scene])[0][4:], ["0.60", "yes", "no"])

    def test_document(self):
        results = {"size": "640x360", "backends": [{"backend": "vk", "device": "d", "driver": "e",
                                                    "scenes": [{**self.scene, "build": "1.2-abc"}, {"name": "bare", "rows": []}]}]}
        few = {"size": "640x360", "rows": ["single-1"], "backends": [{"backend": "gl", "device": "f", "driver": "g",
                                                                      "scenes": [self.scene]}]}
        text = choosing.document([results, few])
        self.assertLess(text.index("## Vulkan: d, e\n\nMeasured by build: 1.2-abc."),
                        text.index("## OpenGL: f, g\n\nMeasured by build: one without a name.\n\n"
                                   "Of a full sweep's rows only these were"))
        self.assertEqual(text.count("only these"), 1)
        self.assertIn("at most 0.75 of the error of sbaa S=2 on 1 of 1 scenes", text)
        self.assertIn("| metal (dense) | 8 | 2.00 | 1.60 | 0.80 | 1.25 | 0.86 | not measured | not measured | 1.5 | not measured | "
                      "not measured |", text)

    def test_the_kept_document_is_of_the_kept_results(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "choosing.md"
            kept = [file for of in ("sweep", "adaptive") for file in sorted(ROOT.glob(f"docs/results/*/{of}/results.json"))]
            self.assertEqual(len(kept), 3)
            subprocess.run([sys.executable, TOOL, *kept, out], check=True)
            self.assertEqual(out.read_text(), (ROOT / "docs/choosing.md").read_text())

    def test_refuses_what_is_no_sweep(self):
        with tempfile.TemporaryDirectory() as folder:
            for text in ("{", "[]", '{"backends": [{}]}'):
                path = Path(folder) / "results.json"
                path.write_text(text)
                done = subprocess.run([sys.executable, TOOL, path, Path(folder) / "out.md"], capture_output=True,
                                      text=True)
                self.assertEqual(done.returncode, 1, text)
                self.assertIn("choosing:", done.stderr)
                self.assertNotIn("Traceback", done.stderr)

    def test_writes_over_no_results(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "results.json"
            path.write_text("{}")
            done = subprocess.run([sys.executable, TOOL, path, path], capture_output=True, text=True)
            self.assertEqual((done.returncode, path.read_text()), (1, "{}"))
            self.assertIn("would be written over", done.stderr)


if __name__ == "__main__":
    unittest.main()
