"""Prices of the command line: the table, the JSON object, measured times."""
import json
import os
import tempfile
import unittest

import harness

PIXELS = 640 * 360


def price(*arguments):
    return harness.data("price", *arguments)


def named(rows, name):
    return next(row for row in rows if row["name"] == name)


def step(rows, lower, higher):
    return next(row for row in rows if (row["from"], row["to"]) == (lower, higher))


def memory(*arguments):
    return harness.data("memory", *arguments)["totalBytes"]


class Json(unittest.TestCase):
    def test_the_view(self):
        data = price("--technique", "ssaa")
        self.assertEqual((data["width"], data["height"]), (640, 360))
        self.assertEqual(data["view"]["totalBytes"], memory("--technique", "ssaa"))
        self.assertEqual(data["view"]["maxEventsPerPixel"], 8)
        self.assertEqual(data["aggregates"], [])

    def test_effects_are_differences(self):
        for options in (("--technique", "ssaa"), ("--tier", "generation=ids"), ()):
            with self.subTest(options=options):
                culling = named(price(*options)["effects"], "light-culling")
                self.assertTrue(culling["isOn"])
                self.assertEqual(culling["totalBytes"], memory(*options) - memory(*options, "--no-culling"))
                self.assertEqual(culling["passes"], 1)
        aggregated = named(price()["effects"], "specular")
        self.assertGreater(aggregated["aggregateBits"], 0)
        self.assertEqual(aggregated["totalBytes"], aggregated["aggregateBits"] // 8 * 2 * PIXELS)

    def test_effects_that_are_left_out_have_the_same_price(self):
        for options in (("--technique", "ssaa"), ()):
            whole, less = price(*options), price(*options, "--without", "specular")
            with_it, without = named(whole["effects"], "specular"), named(less["effects"], "specular")
            self.assertEqual((with_it.pop("isOn"), without.pop("isOn")), (True, False))
            self.assertEqual(with_it, without)
            self.assertEqual(whole["view"]["totalBytes"] - less["view"]["totalBytes"], with_it["totalBytes"])

    def test_steps(self):
        data = price("--technique", "ssaa")
        for lower, higher in ((4, 8), (8, 16), (16, 32)):
            self.assertEqual(step(data["samples"], lower, higher)["totalBytes"],
                             memory("--technique", "ssaa", "--samples", str(higher))
                             - memory("--technique", "ssaa", "--samples", str(lower)))
        data = price("--aggregates", "2")
        self.assertEqual([(row["from"], row["to"], row["isOn"]) for row in data["aggregates"]],
                         [(1, 2, True), (2, 3, False), (3, 4, False)])
        self.assertEqual(step(data["aggregates"], 3, 4)["totalBytes"],
                         memory("--aggregates", "4") - memory("--aggregates", "3"))

    def test_scenes_have_their_facts(self):
        effects = price("--scene", "metal", "--technique", "ssaa")["effects"]
        shadows = {name: named(effects, name)["isOn"] for name in ("shadow-map-0", "shadow-map-1")}
        self.assertEqual(shadows, {"shadow-map-0": True, "shadow-map-1": False})
        dark = price("--scene", "metal", "--technique", "ssaa", "--without", "shadows")
        self.assertEqual(dark["view"]["maxShadowTapsPerEvent"], 0)

    def test_what_is_not_possible_says_why(self):
        refused = named(price("--technique", "msaa")["effects"], "custom-depth")
        self.assertFalse(refused["isPossible"])
        self.assertIn("AGAA_FACT_CUSTOM_DEPTH", refused["reason"])
        self.assertNotIn("totalBytes", refused)


class Times(unittest.TestCase):
    def test_a_column_of_measured_times(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "times.json")
            with open(path, "w") as file:
                json.dump({"device": "some device", "effects": {"specular": {"ratio": 1.25}, "ambient": {"ratio": 0.99}}}, file)
            data = price("--times", path)
            self.assertEqual(data["measuredOn"], "some device")
            self.assertEqual(named(data["effects"], "specular")["measuredRatio"], 1.25)
            self.assertNotIn("measuredRatio", named(data["effects"], "emissive"))
            table = harness.run("price", "--times", path).stdout
            self.assertIn("some device", table)
            rows = {line.split()[0]: line for line in table.splitlines() if line.split()}
            self.assertTrue(rows["specular"].endswith("+25.0 %"), rows["specular"])
            self.assertTrue(rows["ambient"].endswith("-1.0 %"), rows["ambient"])
            self.assertFalse(rows["emissive"].endswith("%"), rows["emissive"])


class Table(unittest.TestCase):
    def test_columns_are_aligned(self):
        result = harness.run("price")
        self.assertEqual(result.returncode, 0, result.stderr)
        lines = [line for line in result.stdout.splitlines() if "not possible" not in line][1:]
        self.assertIn("events", lines[0])
        self.assertEqual({len(line) for line in lines}, {len(lines[0])})
        self.assertTrue(any(line.startswith("samples 8 to 16") for line in lines))

    def test_shows_every_entry(self):
        data = price("--technique", "msaa")
        text = harness.run("price", "--technique", "msaa").stdout
        for row in data["effects"]:
            self.assertEqual(sum(line.split()[0].rstrip(":") == row["name"] for line in text.splitlines()), 1, row["name"])
        self.assertIn("custom-depth: not possible: ", text)
        self.assertIn("any", text) # events without a bound

    def test_needs_no_device(self):
        environment = dict(os.environ, VK_ICD_FILENAMES="/nonexistent", VK_DRIVER_FILES="/nonexistent")
        result = harness.subprocess.run([harness.HARNESS, "price"], env=environment, capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    unittest.main()
