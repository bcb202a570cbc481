#!/usr/bin/env python3
"""Tests of the page that benchmark/report/sweep_report.py writes, in headless Chromium.

With --keep DIR, leaves the page and pictures of it there, to be looked at.
"""

import json
import re
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser, find_chromium
from sweep_results import gpu_row, make_results, run_tool, write_gpu, write_motion, write_results

KEEP = None


def rows_of(scene):
    """Rows of the scene's own lights by technique, n and c. Rows of agaa with two passes come first and are taken."""
    return {(row["technique"], row["n"], row["c"]): row for row in reversed(scene["rows"]) if row["shadingCost"] == 1}


@unittest.skipUnless(find_chromium(), "needs Chromium, which is not installed")
class Shown(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = KEEP or Path(folder.name)
        cls.folder.mkdir(parents=True, exist_ok=True)
        cls.results = make_results(cls.folder)
        cls.page = cls.folder / "report.html"
        gpu = [gpu_row("bamboo", "ssaa", 8, 0, "", 6, 4), gpu_row("bamboo", "agaa", 8, 2, "ids", 5),
               gpu_row("bamboo", "agaa", 8, 2, "ids", 1, way="compute"), gpu_row("metal", "single", 1, 0, "", 1)]
        done = run_tool(write_results(cls.folder, cls.results), cls.page, "--motion", write_motion(cls.folder / "motion"),
                        "--gpu", write_gpu(cls.folder / "passes.json", gpu))
        if done.returncode:
            raise RuntimeError(done.stderr)
        cls.browser = Browser(find_chromium())
        cls.addClassCleanup(cls.browser.close)

    def open(self, width=1280, height=900, dark=False, page=None):
        self.browser.complaints.clear()
        self.browser.requests.clear()
        self.browser.open(page or self.page, width, height, dark)
        self.browser.wait("document.fonts.status === 'loaded'")

    def tearDown(self):
        self.assertEqual(self.browser.complaints, [])
        outside = [url for url in self.browser.requests if not re.match("(file|data|blob):", url)]
        self.assertEqual(outside, [])

    def choose(self, select, text):
        self.browser.run(f"""(() => {{
            const select = document.getElementById({json.dumps(select)});
            const option = [...select.options].find((one) => one.textContent === {json.dumps(text)});
            if (!option || option.disabled) throw new Error("no choice " + {json.dumps(text)});
            select.value = option.value;
            select.dispatchEvent(new Event("change"));
        }})()""")

    def rows(self, selector):
        """Texts of the cells of each row of a table. A line break separates a cell's note from its text."""
        return self.browser.run(f"""[...document.querySelectorAll("{selector} tr")].map((row) =>
            [...row.children].map((cell) => [...cell.childNodes].map((node) => node.textContent)
                .join("\\n")))""")

    def painted(self, box):
        return self.browser.run(f"""(() => {{
            const canvas = document.querySelector("#{box} canvas");
            if (!canvas) return 0;
            const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
            return new Set(new Uint32Array(data.buffer)).size;
        }})()""")

    def wait_for_images(self):
        self.browser.wait("""["left", "right"].every((side) => {
            const image = document.getElementById("slider-" + side);
            return image && image.complete && image.naturalWidth > 0; })""")

    def test_charts_are_drawn(self):
        for dark in (False, True):
            self.open(dark=dark)
            for box in ["pareto-time", "pareto-bytes", "stages", "temporal", "flicker", "path", "path-flicker"]:
                self.assertGreater(self.painted(box), 10, box)
            if KEEP:
                self.browser.screenshot(KEEP / ("dark.png" if dark else "desktop.png"), whole=True)

    def test_hover_names_the_row(self):
        self.open()
        for box in ["pareto-time", "pareto-bytes"]:
            self.browser.run(f"document.getElementById('{box}').scrollIntoView({{block: 'center'}})")
            x, y = self.browser.run(f"""(() => {{
                const chart = charts.get("{box}");
                const set = chart.data.datasets.findIndex((one) => one.label === "agaa");
                const at = chart.data.datasets[set].data.findIndex(({{row}}) => row.n === 8 && row.c === 2);
                const point = chart.getDatasetMeta(set).data[at];
                const corner = chart.canvas.getBoundingClientRect();
                return [corner.left + point.x, corner.top + point.y];
            }})()""")
            self.browser.mouse("mouseMoved", x - 30, y - 30)
            self.browser.mouse("mouseMoved", x, y)
            self.browser.wait(f"charts.get('{box}').tooltip.opacity > 0")
            words = self.browser.run(f"""(() => {{ const tip = charts.get("{box}").tooltip;
                return [...tip.title, ...tip.body.flatMap((part) => part.lines)].join("\\n"); }})()""")
            for part in ["agaa n=8 c=2", "technique agaa, n 8, c 2", "post-depth-atomics", "(98 % of 7 frames)", "in 95 % of pixels below", " dB at a peak of 1"]:
                self.assertIn(part, words)

    def test_stages_tell_their_passes_and_time_its_references(self):
        self.open()
        words = self.browser.run("passesText({passes: [{name: 'clear', stage: 'generation', ms: {median: 0.5, p95: 0.6}},"
                                 " {name: 'generate', stage: 'generation', ms: {median: 40, p95: 50}},"
                                 " {name: 'shade', stage: 'shading', ms: {median: 9, p95: 9}},"
                                 " {name: 'untimed', stage: 'generation', ms: null}]}, 'generation')")
        self.assertEqual(words, ["clear 0.50 ms (p95 0.60)", "generate 40.0 ms (p95 50.0)"])
        self.assertIn("2.5e-6", self.browser.run("document.getElementById('temporal-note').textContent"))

    def expected_equal_time(self, rows):
        """The rows of the table, computed independently: {budget: {technique: (error, n, c)}}."""
        rows = [row for row in rows if row and row.get("shadingCost") == 1]
        out = {}
        for budget in rows:
            if budget["technique"] == "ssaa":
                best = {}
                for row in rows:
                    key = row["technique"]
                    value = (row["errorReference"]["mseTm"], row["n"], 0 if row.get("preset") else row["c"])
                    if row["frameMs"]["median"] <= budget["frameMs"]["median"]:
                        best[key] = min(best.get(key, value), value)
                out[f"ssaa n={budget['n']}"] = best
        return out

    def test_equal_time(self):
        self.open()
        scene = self.results["backends"][0]["scenes"][0]
        expected = self.expected_equal_time(scene["rows"])
        head, *lines = self.rows("#equal-time-table")
        self.assertEqual([line[0] for line in lines], list(expected))
        gap = 10 * scene["reference"]["splitHalfMseTm"]
        for line in lines:
            best = expected[line[0]]
            winner = min(error for error, _, _ in best.values())
            for technique, cell in zip(head[2:], line[2:]):
                if technique not in best:
                    self.assertEqual(cell, "–")
                    continue
                error, n, c = best[technique]
                shown, _, note = cell.partition("\n")
                value = float(shown.removesuffix(" ★"))
                self.assertAlmostEqual(value / error, 1, delta=0.006, msg=cell)
                self.assertEqual(shown.endswith("★"), error == winner, cell)
                self.assertEqual("no difference" in note, 0 < error - winner < gap, cell)
                if n > 1:
                    self.assertIn(f"n={n}", note)
                if c:
                    self.assertRegex(note, f"[cS]={c}")

    def test_equal_quality(self):
        self.open()
        self.choose("metric", "FLIP against the reference")
        head, *lines = self.rows("#equal-quality")
        self.assertGreater(len(lines), 3)
        for line in lines:
            self.assertNotIn("~", "".join(line), "where any difference counts, nothing is alike")

    def test_beside_the_papers_are_rows_of_two_passes(self):
        swapped = json.loads(json.dumps(self.results))
        for backend in swapped["backends"]:
            for scene in backend["scenes"]:
                scene["rows"].reverse()  # rows by id come first
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "swapped.html"
            self.assertEqual(run_tool(write_results(Path(folder), swapped), page).returncode, 0)
            self.open()
            expected = self.rows("#papers")
            self.open(page=page)
            self.assertEqual(self.rows("#papers"), expected)

    def test_choices(self):
        self.open()
        head = "document.getElementById('scene-name').textContent"
        self.assertEqual(self.browser.run(head), "bamboo")
        self.assertIn("measured by build 0.1.0-1234abcdef",
                      self.browser.run("document.getElementById('scene-facts').textContent"))
        self.choose("scene", "metal")
        self.assertEqual(self.browser.run(head), "metal")
        vulkan = self.rows("#equal-time-table")
        self.choose("backend", "OpenGL")
        self.assertEqual(self.browser.run(head), "metal")
        self.assertNotEqual(self.rows("#equal-time-table"), vulkan)
        self.assertIn("Mesa 22.3.6", self.browser.run("document.getElementById('device').textContent"))
        self.assertIn("no times of passes", self.browser.run("document.getElementById('stages').textContent"))
        before = self.rows("#equal-time-table")
        self.choose("cost", "16×")
        self.assertNotEqual(self.rows("#equal-time-table"), before)
        self.choose("metric", "FLIP against ssaa at the same n")
        title = "charts.get('pareto-time').options.scales.y.title.text"
        self.assertEqual(self.browser.run(title), "FLIP against ssaa at the same n")
        self.assertIn("FLIP", self.browser.run("document.querySelector('#equal-time caption').textContent"))

    def test_rows_without_a_second_pass_are_beside_the_others(self):
        self.open()
        lines = {line[0]: line for line in self.rows("#memory")}
        for name, size in (("agaa n=8 c=2 (scaled-target, ids)", "64"), ("agaa n=8 c=2 (scaled-target, gbuffer)", "160"),
                           ("agaa n=8 accurate", "64")):
            self.assertEqual(lines[name][1], size)
        self.assertEqual(lines["agaa n=8 accurate"][-1], "scaled-target, ids")
        self.assertEqual(lines["agaa n=8 c=2 (scaled-target, ids)"][12], "2.5")
        self.choose("cost", "4×")
        self.assertIn("agaa n=8 c=2 (scaled-target, ids)", [line[0] for line in self.rows("#memory")])

    def test_front_is_beaten_by_nothing(self):
        self.open()
        points, front = self.browser.run("""(() => {
            const sets = charts.get("pareto-time").data.datasets;
            const plain = (one) => one.data.map(({x, y}) => [x, y]);
            return [sets.slice(0, -1).flatMap(plain), plain(sets[sets.length - 1])]; })()""")
        self.assertGreater(len(front), 3)
        for x, y in front[:-1]:
            self.assertFalse(any(a <= x and b <= y and (a, b) != (x, y) for a, b in points))
        self.assertEqual(len(points), 46 + 3)

    def test_slider_moves(self):
        self.open()
        self.wait_for_images()
        self.browser.run("document.getElementById('slider').scrollIntoView({block: 'center'})")
        box = self.browser.run("(() => { const {x, y, width, height} = document.getElementById('slider')"
                               ".getBoundingClientRect(); return [x, y, width, height]; })()")
        x, y, width, height = box
        place = "document.getElementById('slider').exposure"
        self.assertAlmostEqual(self.browser.run(place), 50, delta=1)
        self.browser.mouse("mousePressed", x + width / 2, y + height / 2, pressed=True)
        self.browser.mouse("mouseMoved", x + width * 0.8, y + height / 2, pressed=True)
        self.browser.mouse("mouseReleased", x + width * 0.8, y + height / 2)
        self.assertAlmostEqual(self.browser.run(place), 80, delta=3)

    def right_pixels(self):
        """The largest red, green and blue of the right image."""
        return self.browser.run("""(async () => {
            const image = document.getElementById("slider-right");
            await image.decode();
            const canvas = new OffscreenCanvas(image.naturalWidth, image.naturalHeight);
            const context = canvas.getContext("2d");
            context.drawImage(image, 0, 0);
            const most = [0, 0, 0];
            context.getImageData(0, 0, canvas.width, canvas.height).data.forEach((value, i) => {
                if (i % 4 < 3) most[i % 4] = Math.max(most[i % 4], value); });
            return most; })()""")

    def shown_mode(self, mode):
        self.browser.wait(f"document.getElementById('slider').dataset.mode === '{mode}'")
        self.wait_for_images()

    def test_difference_and_events(self):
        self.open()
        self.wait_for_images()
        self.choose("mode", "left − right, 4×")
        self.shown_mode("between")
        self.choose("right", "agaa n=8 c=2 (scaled-target, post-depth-atomics)")
        self.browser.wait("document.getElementById('side-right').textContent.includes('agaa n=8 c=2')")
        self.assertGreater(max(self.right_pixels()), 100)
        self.choose("left", "agaa n=8 c=2 (scaled-target, post-depth-atomics)")
        self.browser.wait("document.getElementById('side-left').textContent.includes('agaa n=8 c=2')")
        self.assertEqual(self.right_pixels(), [0, 0, 0])
        self.choose("mode", "shading events")
        self.shown_mode("heat")
        self.assertEqual(self.right_pixels()[1:], [60, 120])
        self.choose("right", "ssaa n=8")
        self.shown_mode("image")
        disabled = "document.querySelector('#mode option[value=heat]').disabled"
        self.assertTrue(self.browser.run(disabled))

    def test_a_budget_shows_the_least_error_within_it_and_four_numbers(self):
        self.open()
        scene = self.results["backends"][0]["scenes"][0]
        rows = [row for row in scene["rows"] if row["shadingCost"] == 1]
        single = next(row for row in rows if row["technique"] == "single")
        for factor in (1.5, 3, 10):
            self.choose("budget", f"{factor}× the time of single")
            limit = factor * single["frameMs"]["median"]
            best = min((row for row in rows if row["frameMs"]["median"] <= limit), key=lambda row: row["errorReference"]["mseTm"])
            right = self.browser.run("document.getElementById('right').selectedOptions[0].textContent")
            self.assertTrue(right.startswith(best["technique"]), right)
            numbers = self.browser.run("[...document.querySelectorAll('#numbers dd')].map((one) => one.firstChild.textContent)")
            self.assertEqual(len(numbers), 4)
            self.assertAlmostEqual(float(numbers[0]) / best["errorReference"]["mseTm"], 1, delta=0.01)
            if best["temporal"]:
                self.assertAlmostEqual(float(numbers[1]) / best["temporal"]["flicker"], 1, delta=0.01)
            self.assertAlmostEqual(float(numbers[2].split()[0]) / best["frameMs"]["median"], 1, delta=0.02)
            self.assertAlmostEqual(float(numbers[3].split()[0]) / best["bytesPerPixel"], 1, delta=0.01)
        self.choose("right", "ssaa n=8")
        self.assertEqual(self.browser.run("document.getElementById('budget').value"), "own")

    def test_motions_have_a_picture_and_figures(self):
        self.open()
        names = self.browser.run("[...document.getElementById('motion-view').options].map((one) => one.textContent)")
        self.assertEqual(names, ["city, walk, Vulkan", "metal, light, OpenGL"])
        rows = self.rows("#motion")
        self.assertEqual(rows[0], ["view", "error", "flicker, thousandths", "ghosting", "sharpness", "time", "bytes a pixel"])
        self.assertEqual(rows[1][:4], ["single", "1", "50", "1"])
        self.assertEqual(rows[2][1], "0.5")
        self.browser.wait("document.querySelector('img.motion').naturalWidth === 1")
        self.choose("motion-view", "metal, light, OpenGL")
        self.assertNotIn("ghosting", self.rows("#motion")[0])
        self.assertFalse(self.browser.run("Boolean(document.querySelector('img.motion'))"))

    def test_frames_of_a_gpu_stand_beside(self):
        self.open()
        self.choose("scene", "bamboo")
        rows = {line[0]: line[1:] for line in self.rows("#gpus-table")}
        self.assertEqual(set(rows), {"row", "ssaa n=8", "agaa n=8 c=2 (scaled-target, ids)"})
        self.assertEqual(rows["ssaa n=8"], ["1", "1"])
        own = rows["agaa n=8 c=2 (scaled-target, ids)"]
        self.assertEqual(own[0], "0.5")
        self.assertGreater(float(own[1]), 0)
        self.choose("scene", "metal")
        self.assertIn("no frames of a GPU", self.browser.run("document.getElementById('gpus-table').textContent"))

    def test_claims_are_judged_over_all_scenes(self):
        self.open()
        claims = {line[0]: line[1:] for line in self.rows("#claims")[1:]}
        frames = []
        for scene in self.results["backends"][0]["scenes"][:2]:
            rows = rows_of(scene)
            frames.append(rows["simple_complex", 8, 0]["frameMs"]["median"] / rows["agaa", 8, 2]["frameMs"]["median"])
        ours, holds, why = claims["frames faster than simple/complex on every scene, n = 8 (table 1, with 1.00 on Fur Ball)"]
        self.assertEqual(ours, f"{min(frames):.2f}× to {max(frames):.2f}×")
        self.assertGreater(frames[0], 1)
        self.assertLess(frames[1], 1)
        self.assertEqual(holds, f"on 1 of 2; not on metal {frames[1]:.2f}×")
        self.assertRegex(why, "second geometry pass: prepass and generation are [1-9][0-9]? % of")
        self.assertRegex(why, r"lighting 16× heavier 0\.\d\d×")
        self.assertIn("× on these", claims["shading at least 2× faster than simple/complex, n = 8"][2])
        self.assertEqual(claims["frames faster than simple/complex on every scene, n = 32 (table 1, with 1.00 on Fur Ball)"][1:], ["on all 2", ""])
        self.assertEqual(claims["54 % less memory than deferred supersampling, n = 32 (abstract)"], ["55 %", "on all 2", ""])
        self.assertEqual(claims["19 % less memory than SBAA, two aggregates by two surfaces, n = 8"][:2], ["19 %", "on all 2"])
        events = claims["shading events below 25 % of simple/complex's, n = 8 (§5.2)"]
        self.assertEqual(events[:2], ["25 % to 32 %", "on 1 of 2; not on bamboo 32 %"])
        self.assertIn("6.68 events of 8", events[2])
        self.assertRegex(claims["shading up to 3.5× faster on the best scene, n = 8 (§5.3)"][1], "^not on (bamboo|metal)$")
        for n, share in ((16, 24), (32, 27)):
            claim = f"{share} % less memory than SBAA, two aggregates by two surfaces, n = {n}"
            self.assertEqual(claims.get(claim, ["", "on all 2"])[1], "on all 2")
        ours, holds, why = claims["two aggregates are as good as four surfaces of SBAA, n = 8"]
        share = (9e-4 / 2 ** 2) / (2.6e-3 / 4 ** 2.2)
        self.assertEqual(ours, f"{share:.2f}×")
        self.assertTrue(holds.startswith("on 0 of 2; not on bamboo"), holds)
        self.assertIn("lobe", why)

    def test_one_geometry_pass_and_presets(self):
        self.open()
        scenes = self.results["backends"][0]["scenes"][:2]

        def pick(scene, tier, preset="", cost=1):
            return next(row for row in scene["rows"] if row["technique"] == "agaa" and row["n"] == 8 and row["preset"] == preset
                        and (preset or row["c"] == 2) and row["shadingCost"] == cost and row["tiers"]["generation"] == tier)

        def frames(row):
            return row["frameMs"]["median"]

        for cost in (1, 4):
            self.choose("cost", f"{cost}×")
            lines = {line[0]: line[1:] for line in self.rows("#one-pass")}
            for scene in scenes:
                theirs = next(row for row in scene["rows"] if (row["technique"], row["n"], row["shadingCost"])
                              == ("simple_complex", 8, cost))
                rows = [pick(scene, tier, cost=cost) for tier in ("post-depth-atomics", "gbuffer", "ids")]
                for row, shown in zip(rows, lines[scene["name"]]):
                    errors = row["errorReference"]["mseTm"] / theirs["errorReference"]["mseTm"]
                    self.assertEqual(shown, f"{frames(theirs) / frames(row):.2f}×\nerror {errors:.2f}×")
                self.assertEqual(lines[scene["name"]][3], f"{frames(rows[2]) / frames(rows[0]):.2f}×")
        (name, *cells), = self.rows("#presets")[1:]
        self.assertEqual(name, "accurate by id n=8")
        ratios = {scene["name"]: frames(pick(scene, "ids", "accurate")) / frames(pick(scene, "post-depth-atomics")) for scene in scenes}
        worst = max(ratios, key=ratios.get)
        self.assertEqual(cells[0], f"{sum(ratios.values()) / 2:.2f}×\n{min(ratios.values()):.2f}× to {ratios[worst]:.2f}× ({worst})")
        singles = [rows_of(scene)["single", 1, 0] for scene in scenes]
        shares = [pick(scene, "ids", "accurate")["errorSameSamples"]["mseTm"] / single["errorReference"]["mseTm"]
                  for scene, single in zip(scenes, singles)]
        self.assertAlmostEqual(float(cells[2].split("\n")[0]) / (sum(shares) / 2), 1, delta=0.006)
        against = [pick(scene, "ids", "accurate")["errorReference"]["mseTm"] / rows_of(scene)["ssaa", 8, 0]["errorReference"]["mseTm"]
                   for scene in scenes]
        self.assertEqual(cells[3].split("\n")[0], f"{sum(against) / 2:.2f}×")
        self.assertEqual(cells[4], "–", "no row of the preset paper")
        self.choose("backend", "OpenGL")
        self.choose("scene", "quick <b>")
        self.assertEqual([line[0] for line in self.rows("#one-pass")], ["scene", "metal"])

    def test_ratios_and_effects(self):
        self.open()
        ratios = {line[0]: line[1:] for line in self.rows("#papers")}
        rows = rows_of(self.results["backends"][0]["scenes"][0])
        theirs, ours = rows["simple_complex", 8, 0], rows["agaa", 8, 2]
        shading = theirs["stageMs"]["shading"] / ours["stageMs"]["shading"]
        line = ratios["shading time, simple_complex / agaa c=2, n = 8"]
        self.assertEqual(line[:2], [f"{shading:.2f}×", "3.50×"])
        self.assertRegex(line[2], "^no: .*software rasteriser")
        stages = ours["stageMs"]
        self.assertEqual(ratios["prepass and generation of agaa's passes, c=2, n = 8"][:2],
                         [f"{100 * (stages['prepass'] + stages['generation']) / sum(stages.values()):.0f} %", "61 %"])
        self.assertEqual(ratios["memory, agaa c=2 / sbaa S=2, n = 8"][:2], ["0.81×", "0.81×"])
        merged = rows["sbaa", 8, 4]["errorReference"]["mse"] / rows["msaa", 8, 0]["errorReference"]["mse"]
        self.assertEqual(ratios["MSE against the reference, sbaa S=4 / msaa, n = 8"][:2], [f"{merged:.2f}×", "1.71×"])
        filtered = rows["fxaa", 1, 0]["frameMs"]["median"] / rows["single", 1, 0]["frameMs"]["median"]
        self.assertEqual(ratios["frame time, fxaa / single"][:2], [f"{filtered:.2f}×", "1.03×"])
        effects = {tuple(line[:3]): line[-1] for line in self.rows("#ablation")}
        self.assertEqual(effects["shadow-filter", "bamboo", "yes"], "removes 56 %")
        self.assertEqual(effects["ndf-widening", "bamboo", "no"], "removes 1 %", "the errors have no noise")
        costs = {tuple(line[:3]): line[7] for line in self.rows("#ablation")}
        self.assertEqual(costs["shadow-filter", "bamboo", "yes"], "1.14×")
        self.assertEqual(costs["ndf-widening", "bamboo", "no"], "1.14×\nno difference")
        self.assertEqual(effects["shadow-filter", "metal-plain", "no"], "no difference")
        scenes = self.browser.run("[...document.getElementById('scene').options].map((one) => one.textContent)")
        self.assertEqual(scenes, ["bamboo", "metal"], "a plain one is in the table of effects alone")
        self.assertEqual({line[0]: line[4] for line in self.rows("#ablation")[1:]},
                         {"shadow-filter": "2", "ndf-widening": "2 (accurate)"})

    def test_whatever_is_missing(self):
        self.open()
        self.choose("backend", "OpenGL")
        self.choose("scene", "quick <b>")
        self.assertEqual(self.browser.run("document.getElementById('scene-name').textContent"), "quick <b>")
        self.choose("metric", "FLIP against the reference")
        bare = [{}, {"backends": None}, {"backends": [{}]}, {"backends": [{"scenes": [{}]}]},
                {"quick": True, "size": 3, "backends": [None, {"scenes": [{"reference": None, "rows": [
                    {"technique": "ssaa", "n": 4, "frameMs": {"median": 1}, "stageMs": [3],
                     "errorReference": {"mseTm": 0}, "temporal": {}, "path": 3, "tiers": None, "passes": 1}],
                    "ablation": [{}, {"on": 1}]}]}]}]
        with tempfile.TemporaryDirectory() as folder:
            for results in bare:
                page = Path(folder) / "bare.html"
                done = run_tool(write_results(Path(folder), results), page)
                self.assertEqual(done.returncode, 0, done.stderr)
                with self.subTest(results=results):
                    self.open(page=page)
                    self.assertEqual(self.browser.complaints, [])

    def test_every_sweep_that_is_kept(self):
        kept = sorted((Path(__file__).parents[2] / "docs" / "results").glob("*/sweep/results.json"))
        self.assertTrue(kept)
        for results in kept:
            page = self.folder / "kept.html"
            done = run_tool(results, page, "--image-mib", "2")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.open(page=page)
            for backend in self.browser.run("[...document.getElementById('backend').options].map((o) => o.textContent)"):
                self.choose("backend", backend)
                for scene in self.browser.run("[...document.getElementById('scene').options].map((o) => o.textContent)"):
                    with self.subTest(results=results.parent.parent.name, backend=backend, scene=scene):
                        self.choose("scene", scene)
                        for box in ("pareto-time", "pareto-bytes", "stages"):
                            self.assertGreater(self.painted(box), 10, box)
                        self.assertGreater(len(self.rows("#equal-time-table")), 1)
                        self.assertGreater(len(self.rows("#papers")), 10)

    def test_phone(self):
        self.open(390, 844)
        self.wait_for_images()
        for scene in ["bamboo", "metal"]:
            self.choose("scene", scene)
            self.wait_for_images()
            self.assertEqual(self.browser.run("document.documentElement.scrollWidth"), 390)
            self.assertEqual(self.browser.run("scrollTo(50, 0), scrollX"), 0)
        for box in ["pareto-time", "stages"]:
            width = self.browser.run(f"charts.get('{box}').width")
            self.assertTrue(250 < width <= 390, width)
        wide = self.browser.run("[...document.querySelectorAll('.scroll')]"
                                ".filter((one) => one.scrollWidth > one.clientWidth).length")
        self.assertGreater(wide, 3)
        # Heads of rows stay while the rest scrolls, and leave room for it.
        widest = self.browser.run("[...document.querySelectorAll('tbody th')].map((one) => {"
                                  " one.textContent = 'agaa n=8 c=2 (post-depth-atomics, scaled-target)';"
                                  " return one.offsetWidth; }).sort((a, b) => b - a)[0]")
        self.assertTrue(90 < widest <= 195, widest)
        # The page is turned to landscape, and back.
        for width in (844, 390):
            self.browser.resize(width, 844)
            self.browser.wait(f"document.documentElement.scrollWidth === {width}"
                              f" && charts.get('pareto-time').width <= {width}")
        if KEEP:
            self.browser.screenshot(KEEP / "phone.png", whole=True)


if __name__ == "__main__":
    if len(sys.argv) > 2 and sys.argv[1] == "--keep":
        KEEP = Path(sys.argv.pop(2))
        sys.argv.pop(1)
    if not find_chromium():
        print("Chromium is not installed: how a browser shows the page is not tested.")
    unittest.main()
