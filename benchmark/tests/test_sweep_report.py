#!/usr/bin/env python3
"""Tests of benchmark/report/sweep_report.py: the contents of the page."""

import base64
import copy
import json
import re
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmark" / "report"))
import sweep_images
from sweep_results import make_results, run_tool, write_png, write_results


class Written(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.out = self.folder / "report.html"

    def make(self, results, *arguments):
        done = run_tool(write_results(self.folder, results), self.out, *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return self.out.read_text(encoding="utf-8")

    def embedded(self, source):
        return json.loads(re.search(r'id="results">(.*?)</script>', source, re.DOTALL)[1])

    def test_frames_of_a_gpu_that_cannot_be_read(self):
        path = self.folder / "passes.json"
        for text in ("{", "[]", '{"rows": []}', '{"rows": [{}]}'):
            path.write_text(text)
            done = run_tool(write_results(self.folder, make_results(self.folder)), self.out, "--gpu", path)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, r"^Could not read \S+passes.json: passes.json of benchmark/gpu_run.py is wanted: .+\n$")

    def test_is_one_file(self):
        source = self.make(make_results(self.folder))
        self.assertIsNone(re.search(r"<(script|link|img)[^>]*(src|href)=(?!\"data:)", source))
        self.assertNotRegex(source, r"@import|url\(|sourceMappingURL=index")
        self.assertNotIn("@@", source)
        self.assertIn("Chart.js v", source)
        self.assertIn("Dmitry Snisarenko", source)

    def test_text_of_results_is_no_markup(self):
        results = {"backends": [{"device": "</script><script>alert(1)</script>", "scenes": []}]}
        source = self.make(results)
        self.assertNotIn("</script><script>alert", source)
        self.assertEqual(self.embedded(source)["backends"], results["backends"])

    def test_numbers_without_a_word_in_json(self):
        source = self.make({"backends": [{"scenes": [{"rows": [{"n": float("nan")}]}]}]})
        self.assertIsNone(self.embedded(source)["backends"][0]["scenes"][0]["rows"][0]["n"])

    def test_jpeg_is_taken_as_it_is(self):
        results = make_results(self.folder)
        row = results["backends"][0]["scenes"][0]["rows"][0]
        jpeg = b"\xff\xd8\xff\xe0 and so on"
        (self.folder / "images/one.jpg").write_bytes(jpeg)
        row["image"] = "images/one.jpg"
        self.assertIn(base64.b64encode(jpeg).decode(), self.make(results))

    def test_images_are_kept_once_and_up_to_a_size(self):
        results = make_results(self.folder)
        # Files that differ in their names alone are the same image.
        other = results["backends"][1]["scenes"][0]["rows"][0]
        (self.folder / "images/copy.png").write_bytes((self.folder / other["image"]).read_bytes())
        other["image"] = "images/copy.png"
        source = self.make(copy.deepcopy(results))
        held = self.embedded(source)
        texts = re.findall(r'<script type="text/plain" id="image-\d+">(.*?)</script>', source)
        self.assertEqual(len(texts), len(set(texts)))
        self.assertEqual(held["imagesLeftOut"], 1, "images/none.png is not there")
        ids = [scene["rows"][0]["image"] for backend in held["backends"]
               for scene in backend["scenes"][:1]]
        self.assertTrue(all(isinstance(one, int) for one in ids), ids)

        few = self.embedded(self.make(results, "--image-mib", "0.006"))
        self.assertGreater(few["imagesLeftOut"], 0)
        # The reference of a scene comes first.
        self.assertIsInstance(few["backends"][0]["scenes"][0]["referenceImage"], int)
        self.assertIsNone(few["backends"][0]["scenes"][0]["rows"][-1]["image"])

    def test_selected_images_alone(self):
        results = make_results(self.folder)
        scene = results["backends"][0]["scenes"][0]
        scene["rows"] = scene["rows"][:2]
        for holder, key, name in ((scene, "referenceImage", "reference"), (scene["rows"][0], "image", "single-1"),
                                  (scene["rows"][1], "image", "agaa-8-2")):
            named = f"images/vk-bamboo-{name}.png"
            (self.folder / named).write_bytes((self.folder / holder[key]).read_bytes())
            holder[key] = named
        results["backends"] = [{**results["backends"][0], "scenes": [scene]}]
        kept = self.embedded(self.make(results, "--image", "reference", "--image", "agaa-8-2"))
        scene = kept["backends"][0]["scenes"][0]
        self.assertIsInstance(scene["referenceImage"], int)
        self.assertEqual([isinstance(row["image"], int) for row in scene["rows"]], [False, True])
        self.assertGreater(kept["imagesLeftOut"], 0)

    def test_what_is_compared_first_is_whole_before_the_next_scene(self):
        def row(technique, n, c, tier="post-depth-atomics", preset=""):
            name = f"{technique}-{n}-{c}-{tier}{preset}"
            return {"technique": technique, "n": n, "c": c, "preset": preset, "tiers": {"generation": tier},
                    "image": name, "heat": name + "-events"}
        rows = [row("single", 1, 0), row("ssaa", 8, 0), row("simple_complex", 8, 0), row("agaa", 8, 1),
                row("agaa", 8, 2), row("agaa", 8, 2, "gbuffer"), row("agaa", 8, 0, "ids", "accurate"),
                row("agaa", 8, 0, preset="paper")]
        for row_of, ms, error in ((rows[1], 5.0, 1.0), (rows[3], 6.0, 2.0)):  # the first is on the front
            row_of.update(frameMs={"median": ms}, errorReference={"mseTm": error})
        results = {"backends": [{"scenes": [{"referenceImage": f"reference-{name}-{scene}", "rows": copy.deepcopy(rows)}
                                            for scene in range(2)]} for name in ("vk", "gl")]}
        names = [holder[key] for _, holder, key, _ in sweep_images.wanted(results)]
        first = ["single-1-0-post-depth-atomics", "ssaa-8-0-post-depth-atomics", "simple_complex-8-0-post-depth-atomics", "simple_complex-8-0-post-depth-atomics-events",
                 "agaa-8-2-post-depth-atomics", "agaa-8-2-post-depth-atomics-events", "agaa-8-0-idsaccurate",
                 "agaa-8-0-idsaccurate-events"]
        for place, reference in enumerate(("vk-0", "vk-1", "gl-0", "gl-1")):
            self.assertEqual(names[9 * place:9 * place + 9], ["reference-" + reference] + first)
        self.assertEqual(names[36:40], 4 * ["ssaa-8-0-post-depth-atomics-events"])
        self.assertEqual(len(names), 4 * (1 + 2 * len(rows)))

    def test_images_outside_the_folder_are_not_shown(self):
        (self.folder / "in").mkdir()
        write_png(self.folder / "secret.png", lambda x, y: (1, 2, 3))
        path = self.folder / "in" / "results.json"
        path.write_text(json.dumps({"backends": [{"scenes": [
            {"referenceImage": "../secret.png", "rows": [{"image": 5}]}]}]}), encoding="utf-8")
        self.assertEqual(run_tool(path, self.out).returncode, 0)
        self.assertNotIn('id="image-0"', self.out.read_text(encoding="utf-8"))

    def test_errors(self):
        path = self.folder / "results.json"
        for content in [None, "{", "[]", '{"schema": 1}']:
            if content:
                path.write_text(content, encoding="utf-8")
            done = run_tool(path, self.out)
            self.assertEqual(done.returncode, 1)
            self.assertIn(str(path), done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)
        path.write_text("{}", encoding="utf-8")
        done = run_tool(path, self.out, "--chart-js", self.folder / "none.js")
        self.assertEqual(done.returncode, 1)
        self.assertIn("Chart.js is not at", done.stderr)
        self.assertEqual(run_tool(path).returncode, 2)


if __name__ == "__main__":
    unittest.main()
