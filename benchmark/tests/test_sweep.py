"""Tests of agaa-sweep over one small scene: the fields of docs/sweep.md, the page, and continuing a sweep."""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import harness

ROW = ["technique", "n", "c", "shadingCost", "preset", "tiers", "frameMs", "passes", "stageMs", "geometryPasses",
       "bytesPerPixel", "peakBytesPerPixel", "eventsPerPixel", "eventsPerCoveredPixel",
       "shadowTapsPerPixel", "lightEvaluationsPerPixel", "aggregatesPerPixel", "primitivesPerPixel", "materialsPerPixel",
       "fragmentsPerPixel", "lostFragments", "widenedLobesPerPixel",
       "errorSameSamples", "errorReference", "temporal", "path", "image", "difference", "heat"]


class Sweep(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.arguments = ["sweep", "--quick", "--scene", "metal", "--size", "64x36", "--out",
                         cls.folder.name]
        cls.written = harness.data(*cls.arguments)
        with open(cls.written["results"]) as file:
            cls.results = json.load(file)

    def test_fields(self):
        self.assertEqual(self.results["schema"], 3)
        self.assertEqual(self.results["rounds"], 7)
        self.assertTrue(self.results["quick"])
        backend = self.results["backends"][0]
        self.assertTrue(backend["device"] and backend["driver"])
        self.assertIn(backend["passTimes"], ("device", "cpu-finish", "none"))
        scene = backend["scenes"][0]
        self.assertEqual(scene["name"], "metal")
        self.assertRegex(scene["build"], r"^\d+\.\d+\.\d+(-[0-9a-f]{10,}(-dirty)?)?$")
        self.assertEqual(scene["camera"], "")
        self.assertEqual(scene["lights"], 17)
        self.assertGreater(scene["reference"]["splitHalfMseTm"], 0)
        for row in scene["rows"]:
            with self.subTest(row=f"{row['technique']} {row['n']} {row['c']}"):
                for field in ROW:
                    self.assertIn(field, row)
                self.assertGreater(row["frameMs"]["median"], 0)
                times = row["frameMs"]
                self.assertEqual(times["frames"], 7)
                self.assertTrue(times["low"] <= times["median"] <= times["p95"] <= times["high"], times)
                self.assertAlmostEqual(times["confidence"], 1 - 2 / 2**7)
                self.assertEqual(len(times["turns"]), 7)
                self.assertAlmostEqual(sorted(times["turns"])[3], times["median"], delta=1e-3)
                for each in row["passes"]:
                    if each["ms"]:
                        self.assertEqual(len(each["ms"]["turns"]), each["ms"]["frames"])
                self.assertGreaterEqual(row["lightEvaluationsPerPixel"], row["shadingCost"] * row["eventsPerPixel"])
                self.assertGreater(row["errorReference"]["mseTm"], 0)
                self.assertEqual(row["errorSameSamples"] is None,
                                 row["technique"] in ("ssaa", "dcaa", "sgbc") or row["n"] == 1)
                self.assertEqual(row["heat"] is None, row["technique"] == "msaa")
                for name in (row["image"], row["difference"], row["heat"]):
                    if name:
                        self.assertTrue(os.path.exists(os.path.join(self.folder.name, name)), name)

    def test_scenes_have_unique_names(self):
        seen_otherwise = harness.run(*(text + "@0,1,4,0,0,0,50" if text == "metal" else text for text in self.arguments))
        self.assertEqual(seen_otherwise.returncode, 1)
        self.assertIn("another camera", seen_otherwise.stderr)
        twice = harness.run(*self.arguments, "--scene", "metal@0,1,4,0,0,0,50")
        self.assertEqual(twice.returncode, 2)
        self.assertIn("a second scene called", twice.stderr)
        with tempfile.TemporaryDirectory() as folder:  # the name collides with the images of a plain scene
            named = os.path.join(folder, "metal-plain.glb")
            open(named, "w").close()
            plain = harness.run("sweep", "--scene", named, "--plain", "metal", "--out", os.path.join(folder, "out"))
        self.assertEqual(plain.returncode, 2)
        self.assertIn('--plain names a second scene called "metal-plain"', plain.stderr)

    def test_effects_that_are_not_called_for_change_nothing(self):
        effects = {e["effect"]: e for e in self.results["backends"][0]["scenes"][0]["ablation"]}
        self.assertFalse(effects["emissive"]["calledFor"])
        self.assertEqual(effects["emissive"]["on"]["mseTm"], effects["emissive"]["off"]["mseTm"])
        self.assertTrue(effects["specular"]["calledFor"])
        self.assertGreater(effects["specular"]["off"]["mseTm"], effects["specular"]["on"]["mseTm"])

    def test_page(self):
        with open(self.written["report"]) as file:
            page = file.read()
        self.assertNotIn('src="http', page)
        embedded = re.search(r'<script[^>]*id="results"[^>]*>(.*?)</script>', page, re.DOTALL)
        shown = json.loads(embedded[1])["backends"][0]["scenes"][0]["rows"]
        self.assertEqual([row["technique"] for row in shown],
                         [row["technique"] for row in self.results["backends"][0]["scenes"][0]["rows"]])

    def test_continues_where_it_stopped(self):
        again = harness.run(*self.arguments)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertNotIn("times of frames", again.stderr, "nothing is measured twice")
        with open(self.written["results"]) as file:
            self.assertEqual(json.load(file), self.results)

    def test_measures_what_is_missing(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "results.json")
            arguments = ["sweep", "--quick", "--size", "32x18", "--row", "single-1", "--out", folder, "--scene", "metal",
                         "--scene", "furball", "--backend", "vk"]
            harness.data(*arguments)
            with open(path) as file:
                first = json.load(file)
            both = harness.run(*arguments, "--backend", "gl")
            self.assertEqual(both.returncode, 0, both.stderr)
            self.assertNotIn("vk", both.stderr)
            self.assertRegex(both.stderr, r"gl furball: times of frames, \d+ s left")
            with open(path) as file:
                vk, gl = json.load(file)["backends"]
            self.assertEqual([vk], first["backends"])
            for a, b in zip(vk["scenes"], gl["scenes"]):
                self.assertEqual(a["name"], b["name"])
                errors = [scene["rows"][0]["errorReference"]["mseTm"] for scene in (a, b)]
                self.assertAlmostEqual(errors[0] / errors[1], 1, delta=0.02, msg="of another scene's reference?")
            for key in ("device", "driver"):
                of_another = json.loads(json.dumps(first))
                of_another["backends"][0][key] = "another"
                with open(path, "w") as file:
                    json.dump(of_another, file)
                refused = harness.run(*arguments, "--scene", "bamboo")
                self.assertEqual(refused.returncode, 1)
                self.assertIn(f'of the {key} "another"', refused.stderr)
                with open(path) as file:
                    self.assertEqual(json.load(file), of_another)

    def test_refuses_a_folder_of_other_arguments(self):
        result = harness.run("sweep", "--scene", "metal", "--size", "64x36", "--out", self.folder.name)
        self.assertEqual(result.returncode, 1)
        self.assertIn("other arguments", result.stderr)
        result = harness.run("sweep", "--scene", "nowhere", "--out", self.folder.name)
        self.assertEqual(result.returncode, 2)
        self.assertIn("nowhere", result.stderr)

    def test_rows_that_are_asked_for(self):
        with tempfile.TemporaryDirectory() as folder:
            arguments = ["sweep", "--quick", "--scene", "metal", "--size", "32x18", "--out", folder]
            result = harness.run(*arguments, "--row", "agaa-9-2")
            self.assertEqual(result.returncode, 2)
            self.assertIn("agaa-9-2", result.stderr)
            self.assertIn("agaa-8-2", result.stderr, "names those that there are")
            result = harness.run(*arguments, "--no-ablation", "--plain", "metal")
            self.assertEqual(result.returncode, 2)
            self.assertIn("--no-ablation", result.stderr)
            written = harness.data(*arguments, "--row", "agaa-8-2", "--row", "ssaa-8")
            with open(written["results"]) as file:
                results = json.load(file)
            self.assertEqual(results["rows"], ["agaa-8-2", "ssaa-8"])
            scene = results["backends"][0]["scenes"][0]
            self.assertEqual([(r["technique"], r["n"], r["c"]) for r in scene["rows"]],
                             [("agaa", 8, 2), ("ssaa", 8, 0)])
            self.assertEqual({effect["preset"] for effect in scene["ablation"]}, {""}, "effects of other rows")

    def test_effects_where_nothing_calls_for_them(self):
        with tempfile.TemporaryDirectory() as folder:
            written = harness.data("sweep", "--quick", "--scene", "metal", "--plain", "city", "--size", "32x18",
                                   "--row", "agaa-8-2", "--out", folder)
            with open(written["results"]) as file:
                scene, plain = json.load(file)["backends"][0]["scenes"]
        self.assertEqual([(s["name"], s["plain"]) for s in (scene, plain)], [("metal", False), ("city-plain", True)])
        effects = {e["effect"]: e for e in plain["ablation"]}
        for effect in ("shadow-filter", "ndf-widening", "specular", "emissive", "ambient", "normal-maps",
                       "lit-aggregates", "elliptic-lobes", "gloss-weight"):
            self.assertFalse(effects[effect]["calledFor"], effect)
            self.assertEqual(effects[effect]["on"]["mseTm"], effects[effect]["off"]["mseTm"], effect)
        self.assertEqual(harness.run("sweep", "--plain", "nowhere").returncode, 2)

    def test_backends_share_a_reference(self):
        with tempfile.TemporaryDirectory() as folder:
            written = harness.data("sweep", "--scene", "metal", "--size", "32x18", "--row", "agaa-8-2", "--rounds", "3",
                                   "--no-ablation", "--backend", "vk", "--backend", "gl", "--out", folder)
            with open(written["results"]) as file:
                vk, gl = (backend["scenes"][0] for backend in json.load(file)["backends"])
        self.assertEqual(vk["reference"], gl["reference"])
        self.assertEqual((vk["ablation"], gl["ablation"]), ([], []))
        a, b = vk["rows"][0], gl["rows"][0]
        self.assertNotEqual(a["image"], b["image"])
        for over_time in ("temporal", "path"):
            for term in ("biasSquared", "variance", "flicker"):
                self.assertAlmostEqual(a[over_time][term] / b[over_time][term], 1, delta=0.02)
        self.assertAlmostEqual(a["errorReference"]["mseTm"] / b["errorReference"]["mseTm"], 1, delta=0.02)


class Forwarding(unittest.TestCase):
    def test_the_harness_runs_the_program_beside_it(self):
        forwarded = harness.run("sweep", "--help")
        self.assertEqual(forwarded.returncode, 0, forwarded.stderr)
        program = os.path.join(os.path.dirname(harness.HARNESS), "agaa-sweep")
        direct = subprocess.run([program, "--help"], capture_output=True, text=True)
        self.assertEqual(forwarded.stdout, direct.stdout)
        self.assertIn("--no-ablation", direct.stdout)
        refused = harness.run("sweep", "--row", "agaa 8")
        self.assertEqual(refused.returncode, 2)
        self.assertIn('agaa-sweep: --row: There is no row "agaa 8"', refused.stderr)
        sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
        import full_sweep
        self.assertLessEqual(set(full_sweep.CORE), set(re.split(r"[ ,.]+", refused.stderr)), "rows of --core")

    def test_a_missing_program_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            alone = shutil.copy(harness.HARNESS, folder)
            result = subprocess.run([alone, "sweep", "--quick"], capture_output=True, text=True)
            self.assertEqual((result.returncode, result.stdout), (1, ""))
            self.assertEqual(result.stderr, f"agaa-harness: The command sweep needs the program {folder}/agaa-sweep, which "
                                            "cannot be run: No such file or directory.\n")


if __name__ == "__main__":
    unittest.main()
