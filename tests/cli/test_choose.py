"""Settings for goals from the command line, with and without frames."""
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
