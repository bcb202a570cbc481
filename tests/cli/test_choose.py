"""Settings for goals from the command line, with and without frames."""
import json
import os
import tempfile
import unittest

import harness


def choose(*arguments):
    return harness.data("choose", *arguments)


def memory(options, *arguments):
    return harness.data("memory", *options, *arguments)["totalBytes"]


class FromTheTable(unittest.TestCase):
    def test_errors(self):
        last = 2
        for limit in (1, 0.25, 0.1, 0.05, 0.02):
            with self.subTest(limit=limit):
                choice = choose("--max-error", str(limit))
                self.assertLessEqual(choice["errorShare"], last)
                self.assertEqual(choice["missedLimits"], [] if choice["errorShare"] <= limit else ["max-error"])
                self.assertFalse(choice["hasTimes"])
                self.assertIn(f'"{choice["technique"]}"', choice["reason"])
                last = choice["errorShare"]

    def test_bytes_are_those_of_the_view(self):
        limit = 100 * 640 * 360
        choice = choose("--max-bytes", str(limit), "--prefer", "error")
        self.assertLessEqual(choice["bytes"], limit)
        self.assertEqual(choice["bytes"], memory(choice["options"]))
        self.assertGreater(choose("--prefer", "error")["bytes"], limit)

    def test_a_limit_that_cannot_be_met_is_named(self):
        choice = choose("--max-bytes", "1", "--max-mse", "1e-9")
        self.assertEqual(choice["missedLimits"], ["max-mse", "max-bytes"])
        self.assertIn("maxBytes", choice["reason"])

    def test_what_a_host_lacks_is_left_out(self):
        everything = choose("--max-error", "0.1")["leftOut"]
        self.assertGreater(choose("--max-error", "0.1", "--no-fetch")["leftOut"], everything)
        once = choose("--max-error", "0.1", "--one-geometry-pass")
        self.assertGreater(once["leftOut"], everything)
        self.assertEqual(harness.data("plan", *once["options"])["geometryPasses"], 1)

    def test_text_is_the_reason(self):
        result = harness.run("choose", "--max-error", "0.1")
        self.assertEqual(result.stdout.strip(), choose("--max-error", "0.1")["reason"])


def measured(technique, samples, error, milliseconds):
    return {"technique": technique, "preset": None, "samples": samples, "aggregates": 0, "tier": None, "pixels": 640 * 360,
            "errorShare": error, "error": 0.01 * error, "geometryMs": milliseconds, "shadingMs": 2 * milliseconds}


class FromMeasurements(unittest.TestCase):
    def choose(self, rows, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "measured.json")
            with open(path, "w") as file:
                json.dump({"measured": rows}, file)
            return choose("--measured", path, *arguments)

    def test_errors_and_times_are_those_of_the_file(self):
        rows = [measured("single", 1, 1, 1), measured("ssaa", 4, 0.3, 4), measured("ssaa", 8, 0.02, 3)]
        for limit, expected in ((1, 0), (0.5, 2), (0.01, 2)):
            with self.subTest(limit=limit):
                choice = self.choose(rows, "--max-error", str(limit))
                row = rows[expected]
                self.assertEqual((choice["technique"], choice["samples"]), (row["technique"], row["samples"]))
                self.assertAlmostEqual(choice["errorShareWorst"], row["errorShare"])
                self.assertAlmostEqual(choice["error"], row["error"])
                self.assertAlmostEqual(choice["milliseconds"], 3 * row["geometryMs"], places=4)
                self.assertEqual(choice["missedLimits"], ["max-error"] if row["errorShare"] > limit else [])

    def test_others_are_predicted(self):
        """In a scene where ssaa leaves little, other settings are predicted to leave little as well."""
        errors = []
        for share in (0.3, 0.05):
            row = measured("ssaa", 8, share, 0)
            choice = self.choose([row], "--predict-others", "--prefer", "error")
            self.assertNotEqual((choice["technique"], choice["samples"]), ("ssaa", 8))
            self.assertIn("Predicted from 1 measured setting:", choice["reason"])
            self.assertLess(choice["errorShareMedian"], choice["errorShare"])
            errors.append(choice["errorShare"])
        self.assertLess(errors[1], errors[0])
        self.assertIn("--predict-others needs --measured", harness.run("choose", "--predict-others").stderr)
        timed = measured("ssaa", 8, 0.3, 1)
        with self.assertRaisesRegex(Exception, "times come from observations"):
            self.choose([timed], "--predict-others")

    def test_presets_and_tiers(self):
        row = {**measured("agaa", 8, 0.1, 1), "preset": "fast", "aggregates": 1, "tier": "gbuffer"}
        choice = self.choose([row])
        self.assertEqual((choice["preset"], choice["tier"]), ("fast", "gbuffer"))

    def test_times_need_not_be_measured(self):
        row = measured("ssaa", 4, 0.3, 0)
        del row["pixels"]
        self.assertIn("on the table's device", self.choose([row])["reason"])


class FromFrames(unittest.TestCase):
    def test_a_frame_is_observed(self):
        options = ("--scene", "city", "--size", "96x64", "--max-error", "0.25", "--observe", "--no-validation")
        choice = choose(*options)
        seen = choice["observation"]
        self.assertEqual(seen["technique"], "single")
        self.assertTrue(choice["hasTimes"])
        self.assertGreater(seen["geometryMs"], 0)
        self.assertGreater(seen["shadingMs"], 0)
        self.assertGreater(seen["coverage"], 0.1)
        self.assertAlmostEqual(seen["eventsPerPixel"], seen["coverage"], places=5)
        self.assertGreater(seen["lightsPerEvent"], 1)
        self.assertAlmostEqual(seen["shadowTapsPerEvent"], 1, places=5)
        rendered = harness.data("render", *options[:4], "--no-counters", *choice["options"])
        self.assertEqual(rendered["memoryBytes"], choice["bytes"])


if __name__ == "__main__":
    unittest.main()
