"""Memory figures of the command line: the papers' model and the tiers that run."""
import unittest

import harness


def memory(*arguments):
    return harness.data("memory", "--size", "640x360", "--no-culling", *arguments)


class Memory(unittest.TestCase):
    def native(self, technique, n, c=2):
        return memory("--technique", technique, "--layout", "paper16", "--tier", "native",
                      "--samples", str(n), "--aggregates", str(c))

    def test_the_papers_model(self):
        for n, expected in ((8, 81), (16, 130), (32, 228)):
            data = self.native("agaa", n)
            beyond = sum(s["bytes"] for s in data["surfaces"]
                         if s["name"] == "aggregate-coverage-beyond-8-bits") / (640 * 360)
            self.assertEqual(data["bytesPerPixel"] - beyond, expected)
            self.assertEqual(beyond == 0, n == 8)
            self.assertEqual(data["totalBytes"], sum(s["bytes"] for s in data["surfaces"]))

    def test_multisampled_g_buffers(self):
        for n in (8, 16, 32):
            self.assertEqual(self.native("ssaa", n)["bytesPerPixel"], 16 * n)

    def test_masks_of_lights(self):
        culled = harness.data("memory", "--size", "640x360", "--technique", "ssaa")
        masks = [s["bytes"] for s in culled["surfaces"] if s["name"] == "light-masks"]
        self.assertEqual(masks, [640 * 360 // 64 * 12]) # 64 lights, and a word for shadows
        self.assertEqual(culled["totalBytes"] - masks[0], memory("--technique", "ssaa")["totalBytes"])

    def test_bytes_per_aggregate_with_exact_sums(self):
        for n, most in ((8, 20), (16, 24), (32, 32)):
            data = memory("--layout", "paper16", "--samples", str(n))
            self.assertLessEqual(data["bytesPerAggregate"], most)

    def test_plans_of_scenes_less_effects(self):
        def resources(*arguments):
            return {r["name"] for r in harness.data("plan", "--scene", "metal", *arguments)["resources"]}
        self.assertIn("shadow-map-0", resources())
        self.assertNotIn("shadow-map-0", resources("--without", "shadows"))
        def aggregates(*arguments):
            data = harness.data("plan", "--scene", "metal", "--size", "64x64", *arguments)
            return next(r["bytes"] for r in data["resources"] if r["name"] == "aggregates")
        self.assertEqual(aggregates("--without", "shading-normals"), aggregates())
        self.assertEqual(aggregates("--without", "specular", "--without", "shading-normals"), aggregates("--without", "specular"))
        dull = ("--without", "specular", "--without", "local-lights")
        self.assertEqual(aggregates(*dull) - aggregates(*dull, "--without", "shading-normals"), 2 * 8 * 64 * 64)
        by_id = ("--tier", "generation=ids")
        self.assertGreater(len(resources(*by_id, "--unfetched-every", "3")), len(resources(*by_id)))

    def test_peak_and_surfaces(self):
        data = memory()
        self.assertLessEqual(data["peakBytes"], data["totalBytes"])
        for surface in data["surfaces"]:
            self.assertEqual(set(surface), {"name", "format", "samples", "layers", "width",
                                            "height", "bytes"})

    def test_plans(self):
        plan = harness.data("plan", "--samples", "32", "--aggregates", "4")
        self.assertEqual((plan["scaleX"], plan["scaleY"], plan["deviceSamples"]), (2, 4, 4))
        self.assertEqual(plan["geometryPasses"], 2)
        names = [r["name"] for r in plan["resources"]]
        for needed in ("depth", "normals", "metadata", "aggregates"):
            self.assertIn(needed, names)
        self.assertEqual(plan["bytes"]["total"],
                         sum(r["bytes"] for r in plan["resources"]
                             if r["kind"] in ("image", "buffer")))

    def test_scenes(self):
        scenes = harness.data("scenes")["scenes"]
        self.assertEqual({s["name"] for s in scenes},
                         {"bamboo", "foliage", "furball", "metal", "city"})
        for scene in scenes:
            self.assertGreater(scene["triangles"], 50000)
            self.assertEqual(scene["lights"], 17)
            self.assertEqual(len(scene["camera"]), 7)
            self.assertTrue(0 < scene["camera"][6] < 180)


class ById(unittest.TestCase):
    def test_eight_bytes_a_sample_a_bit_a_pixel_and_nothing_an_aggregate(self):
        for n in (1, 4, 8, 16, 32):
            for c in (1, 2, 4):
                data = memory("--technique", "agaa", "--samples", str(n), "--aggregates", str(c), "--tier", "generation=ids")
                self.assertEqual(data["bytesPerPixel"], 8 * n + 1 / 8)
                self.assertEqual(data["bytesPerAggregate"], 0)

    def test_what_is_kept_besides(self):
        ids = ("--tier", "generation=ids")
        fused = memory(*ids)["totalBytes"]
        self.assertEqual(memory(*ids, "--preset", "accurate")["totalBytes"], fused)
        self.assertGreater(memory(*ids, "--buffered")["bytesPerAggregate"], 0)
        drawn = memory(*ids, "--unfetched-every", "3")["surfaces"]
        self.assertIn("gbuffer-0", [s["name"] for s in drawn])
        self.assertGreater(sum(s["bytes"] for s in drawn), fused)


if __name__ == "__main__":
    unittest.main()
