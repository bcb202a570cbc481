"""Rendering from the command line: fields, consistent counters, files, repeatable bits."""
import base64
import functools
import json
import os
import struct
import tempfile
import unittest

import harness

FIELDS = ["frameMs", "recordMs", "passes", "shadingEventsPerPixel", "geometryPasses", "bytesPerPixel",
          "predictedBytes", "memoryBytes", "driverBytes", "peakBytes", "tiers", "counters",
          "apiMessages"]


def options(technique):
    """Of the command line; dcaa and sgbc count coverage samples."""
    return ["--technique", technique] + (["--samples", "64", "--aggregates", "4"] if technique in ("dcaa", "sgbc") else [])


def write_radiance(path, width, height, exponent=129, is_lit=lambda x, y: True):
    """Writes a Radiance file of light of 1, times a power of two, or of none."""
    with open(path, "wb") as file:
        file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + f"-Y {height} +X {width}\n".encode())
        for y in range(height):
            for x in range(width):
                file.write(bytes((128, 128, 128, exponent) if is_lit(x, y) else (0, 0, 0, 0)))


def write_room(path, **material):
    """Writes a glTF file of a cube around the origin, with one material and one light without intensity."""
    corners = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    indices = [side[i] for side in sides for i in (0, 1, 2, 0, 2, 3)]
    data = b"".join(struct.pack("<3f", *c) for c in corners) + struct.pack("<36H", *indices)
    light = {"type": "directional", "intensity": 0}
    scene = {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_clearcoat"],
        "extensions": {"KHR_lights_punctual": {"lights": [light]}},
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"name": "wall", "doubleSided": True, **material}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [-1] * 3, "max": [1] * 3},
            {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
        "buffers": [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}
    with open(path, "w") as file:
        json.dump(scene, file)


def on(backend):
    """For tests of what both graphics APIs share: the other one runs them with AGAA_ALL_SETTINGS alone."""
    def decorate(test):
        @functools.wraps(test)
        def run(self):
            if self.backend != backend and "AGAA_ALL_SETTINGS" not in os.environ:
                self.skipTest(f"{backend} covers it; scripts/test --exhaustive runs it on both")
            self.is_alone = True
            test(self)
        return run
    return decorate


class Render(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    backend = "vk"
    share = 0  # of every two settings of a product, the one that this graphics API renders
    is_alone = False  # the other graphics API does not run the test

    def shared(self, settings):
        """The settings that this graphics API renders: every second one, or all if the other one renders none, and with
        AGAA_ALL_SETTINGS."""
        settings = list(settings)
        return settings if self.is_alone or "AGAA_ALL_SETTINGS" in os.environ else settings[self.share::2]

    def render(self, *arguments, size="96x54", scene="metal", timed=False):
        """timed: adds the times of passes, which another view measures."""
        return harness.data("render", "--backend", self.backend, "--scene", scene, "--size", size,
                            *([] if timed else ["--no-timestamps"]), *arguments)

    def test_counting_changes_no_pixel(self):
        for technique in self.shared(
                ("single", "fxaa", "smaa", "taa", "msaa", "ssaa", "visibility", "simple_complex", "sbaa", "agaa", "dcaa", "sgbc", "adaptive")):
            with self.subTest(technique=technique):
                counted, bare = self.path("counted.exr"), self.path("bare.exr")
                self.render(*options(technique), "--exr", counted, size="48x27")
                self.render(*options(technique), "--exr", bare, "--no-counters", size="48x27")
                self.assertEqual(harness.data("compare", counted, bare)["maxAbs"], 0)

    @on("vk")
    def test_facts_that_change_with_each_frame(self):
        plain, switched = self.path("plain.exr"), self.path("switched.exr")
        self.render("--technique", "ssaa", "--exr", plain, size="48x27")
        data = self.render("--technique", "ssaa", "--exr", switched, "--switch-facts", "--frames", "6", size="48x27")
        self.assertEqual(len(data["frameMilliseconds"]), 6)
        self.assertEqual(data["variants"], 5)
        self.assertEqual(data["apiMessages"], [])
        self.assertEqual(harness.data("compare", plain, switched)["maxAbs"], 0)  # the last frame has all effects again
        self.render("--technique", "ssaa", "--exr", switched, "--switch-facts", "--frames", "5", size="48x27")
        self.assertGreater(harness.data("compare", plain, switched)["maxAbs"], 0)

    @on("vk")
    def test_facts_are_checked(self):
        for scene in ("metal", "bamboo"):
            data = self.render("--technique", "ssaa", "--check-facts", size="48x27", scene=scene)
            self.assertGreater(data["facts"]["inspected"], 0)
            self.assertEqual(data["facts"]["contradicted"], 0, data["facts"]["explanation"])
            plain = self.render("--technique", "ssaa", "--plain-facts", size="48x27", scene=scene)
            self.assertGreaterEqual(plain["bytesPerPixel"], data["bytesPerPixel"])
        self.assertGreater(plain["bytesPerPixel"], data["bytesPerPixel"], "of bamboo, whose reflectance is not stored")
        wrong = self.render("--technique", "ssaa", "--check-facts", "--without", "specular", size="48x27")
        self.assertEqual(wrong["facts"]["contradicted"], 1)
        self.assertIn("missing AGAA_FACT_SPECULAR (100 %", wrong["facts"]["explanation"])
        shown, png = self.path("facts.exr"), self.path("facts.png")
        self.render("--technique", "ssaa", "--view", "facts", "--exr", shown, "--png", png, size="48x27")

    def test_fragments_at_coverage_samples(self):
        data = self.render("--preset", "accurate", "--samples", "64", "--fragments-per-pixel", "64")
        self.assertEqual(data["tiers"]["generation"], "fragments")
        self.assertEqual(data["predictedBytes"], data["memoryBytes"])
        self.assertEqual(data["apiMessages"], [])
        counters = data["counters"]
        self.assertEqual(counters["lostFragments"], 0)
        self.assertEqual(counters["once"], counters["visible"])
        self.assertGreater(counters["fragments"], counters["primitives"])
        self.assertGreater(counters["primitives"], counters["aggregates"])
        self.assertLessEqual(counters["maxEventsPerPixel"], 4)
        plain = self.path("plain.exr")
        fragments = ["--technique", "agaa", "--samples", "64"]
        self.render(*fragments, "--exr", plain, size="48x27")
        for view in self.shared(("events", "clusters", "primitives", "lit", "widened", "tier")):
            with self.subTest(view=view):
                image = self.path("view.exr")
                self.render(*fragments, "--view", view, "--exr", image, size="48x27")
                self.assertGreater(harness.data("compare", image, plain)["mse"], 0)

    @on("gl")
    def test_adaptive_samples_come_near_all_of_them(self):
        for samples in self.shared(("4", "8", "9", "16")):
            images = [self.path(name + ".exr") for name in ("ssaa", "all", "adaptive")]
            grid = ["--samples", samples, "--tier", "visibility=" + ("scaled-target" if samples == "8" else "ordered-grid")]
            full = self.render("--technique", "ssaa", *grid, "--exr", images[0])
            every = self.render("--technique", "adaptive", "--samples", samples, "--metrics", "none", "--exr", images[1])
            chosen = self.render("--technique", "adaptive", "--samples", samples, "--exr", images[2])
            with self.subTest(samples=samples):
                self.assertEqual(every["tiers"]["visibility"], full["tiers"]["visibility"])
                self.assertEqual(every["counters"]["shadingEvents"], full["counters"]["shadingEvents"])
                self.assertLess(harness.data("compare", images[0], images[1])["maxAbs"], 0.01)
                self.assertLess(chosen["counters"]["shadingEvents"], 0.7 * full["counters"]["shadingEvents"])
                self.assertLess(harness.data("compare", images[0], images[2])["mseTm"], 1e-4)
                self.assertEqual(chosen["counters"]["visible"], full["counters"]["visible"])
                self.assertEqual(chosen["apiMessages"], [])

    @on("vk")
    def test_adaptive_options(self):
        adaptive = ["--technique", "adaptive", "--samples", "9"]
        def events(*options, image=None, scene="foliage"):
            data = self.render(*adaptive, *options, *(["--exr", image] if image else []), scene=scene, size="64x36")
            self.assertEqual(data["apiMessages"], [])
            return data["counters"]["shadingEvents"]
        # Numbers that are kept from frame to frame are those of a still image.
        self.assertEqual(events("--count-memory", "0.9", "--frames", "3"), events())
        fine, coarse = self.path("fine.exr"), self.path("coarse.exr")
        ids = ["--tier", "generation=ids"]
        self.assertEqual(events(*ids, "--sample-footprints", image=fine), events(*ids, image=coarse))
        self.assertGreater(harness.data("compare", fine, coarse)["mse"], 1e-6)
        full = self.render(*adaptive, "--target-events", "1.5", scene="foliage", size="64x36")["counters"]
        self.assertLessEqual(full["shadingEvents"], 1.5 * full["shadedPixels"])
        self.assertGreater(full["shadingEvents"], 1.2 * full["shadedPixels"])

    @on("gl")
    def test_lights_out_of_reach_are_left_out(self):
        for technique in self.shared(("ssaa", "agaa")):
            images = [self.path(name + ".exr") for name in ("culled", "all")]
            view = [*options(technique), "--lights", "64"]
            culled = self.render(*view, "--exr", images[0], scene="metal", size="64x36")["counters"]
            every = self.render(*view, "--no-culling", "--exr", images[1], scene="metal", size="64x36")["counters"]
            with self.subTest(technique=technique):
                self.assertEqual(harness.data("compare", *images)["maxAbs"], 0)
                self.assertEqual(every["lightEvaluations"], (17 + 64) * every["shadingEvents"])
                self.assertLess(culled["lightEvaluations"], 0.5 * every["lightEvaluations"])

    @on("vk")
    def test_work_is_within_the_bounds_of_prices(self):
        ids, gbuffer = ["--tier", "generation=ids"], ["--tier", "generation=gbuffer"]
        views = [options(technique) for technique in
                 ("single", "fxaa", "smaa", "taa", "msaa", "ssaa", "visibility", "simple_complex", "sbaa", "agaa", "dcaa", "sgbc", "adaptive")]
        views += [[*options("dcaa"), "--exact", "--fragments-per-pixel", "64"], [*ids, "--lit", "--samples", "32"],
                  [*gbuffer, "--shadow-along-depth"], [*gbuffer, "--shadow-covariance"],
                  [*gbuffer, "--no-shadow-filter", "--aggregates", "4"],
                  [*ids, "--samples", "32", "--shadow-taps", "4", "--fine-materials"],
                  ["--technique", "adaptive", "--equal-weights"]]
        for view in self.shared(views):
            with self.subTest(view=view):
                bounds = harness.data("price", "--scene", "foliage", "--size", "48x27", *view)["view"]
                counters = self.render(*view, scene="foliage", size="48x27")["counters"]
                events = counters["shadingEvents"]
                self.assertGreater(counters["shadowTaps"], 0)
                self.assertLessEqual(counters["shadowTaps"], events * bounds["maxShadowTapsPerEvent"])
                self.assertLessEqual(counters["lightEvaluations"], events * bounds["maxLightsPerEvent"])
                if "msaa" not in view:
                    self.assertLessEqual(counters["maxEventsPerPixel"], bounds["maxEventsPerPixel"])
                    self.assertLessEqual(events, counters["shadedPixels"] * bounds["maxEventsPerPixel"])

    @on("vk")
    def test_fragments_that_carry_materials(self):
        images = []
        for tier in ("lists", "material-lists"):
            images.append(self.path(tier + ".exr"))
            self.render(*options("dcaa"), "--tier", "generation=" + tier, "--fragments-per-pixel", "64", "--exr", images[-1],
                        size="64x36")
        self.assertGreater(harness.data("compare", *images)["psnr"], 50)

    @on("vk")
    def test_patterns_of_the_host(self):
        exact = [*options("dcaa"), "--exact", "--fragments-per-pixel", "64"]
        own = [*exact, "--coverage-pattern", "r2"]
        images = {size: self.path(size + ".exr") for size in ("512", "128", "16")}
        library = self.render(*exact, size="64x36")
        for size, image in images.items():
            data = self.render(*own, "--table-size", size, "--exr", image, size="64x36")
            self.assertEqual(data["apiMessages"], [])
            self.assertEqual(data["memoryBytes"], data["predictedBytes"])
            self.assertEqual(data["memoryBytes"], library["memoryBytes"]) # the table does not grow with the image
        near, far = (harness.data("compare", images["512"], images[size])["mseTm"] for size in ("128", "16"))
        self.assertGreater(near, 0)
        self.assertLess(near, 0.3 * far)

    def test_every_technique(self):
        for technique in self.shared(("single", "ssaa", "agaa", "dcaa", "sgbc", "adaptive")):
            with self.subTest(technique=technique):
                data = self.render(*options(technique), "--frames", "2", timed=True)
                for field in FIELDS:
                    self.assertIn(field, data)
                counters = data["counters"]
                self.assertGreater(counters["visible"], 0)
                self.assertEqual(counters["once"], counters["visible"])
                self.assertEqual(counters["uncovered"], 0)
                self.assertEqual(counters["overlapping"], 0)
                self.assertEqual(data["predictedBytes"], data["memoryBytes"])
                if self.backend == "vk":
                    self.assertGreaterEqual(data["driverBytes"], data["memoryBytes"])
                    self.assertLessEqual(data["peakBytes"], data["driverBytes"])
                else: # cannot alias, and does not tell
                    self.assertEqual(data["driverBytes"], 0)
                    self.assertEqual(data["peakBytes"], data["memoryBytes"])
                self.assertIn(data["timeSource"], ("device", "cpu-finish"))
                self.assertEqual(data["apiMessages"], [])
                self.assertEqual(data["geometryPasses"], 2 if technique == "agaa" else 1)
                for p in data["passes"]:
                    self.assertIn(p["stage"], ("prepass", "definition", "generation", "shading",
                                               "shadowmap", "post", "other"))

    @on("vk")
    def test_files_and_repeatable_bits(self):
        for name in ("a", "b"):
            self.render("--exr", self.path(name + ".exr"), "--png", self.path(name + ".png"))
        self.assertGreater(os.path.getsize(self.path("a.png")), 1000)
        data = harness.data("compare", self.path("a.exr"), self.path("b.exr"), "--difference",
                            self.path("d.png"))
        self.assertEqual(data["maxAbs"], 0)
        self.assertIsNone(data["psnr"])
        self.assertEqual(data["flip"], 0)
        self.assertTrue(os.path.exists(self.path("d.png")))

    def test_values_of_pixels(self):
        values = ("nearest-depth", "mean-depth", "normal", "coverage")
        plain = self.render("--exr", self.path("plain.exr"))
        resolved = self.render("--exr", self.path("image.exr"), "--resolve", ",".join(values))
        self.assertEqual(resolved["apiMessages"], [])
        self.assertEqual(resolved["bytesPerPixel"] - plain["bytesPerPixel"], 16)  # a count and three sums
        self.assertEqual(harness.data("compare", self.path("plain.exr"), self.path("image.exr"))["maxAbs"], 0)
        files = [self.path(f"image-{value}.exr") for value in values]
        for i, first in enumerate(files):
            for second in files[i + 1:]:
                self.assertGreater(harness.data("compare", first, second)["maxAbs"], 0, (first, second))
        for technique in ("msaa", "ssaa"):  # the same samples
            harness.data("render", "--backend", self.backend, "--scene", "metal", "--size", "48x27", "--technique",
                         technique, "--samples", "4", "--resolve", "normal", "--exr",
                         self.path(f"{technique}.exr"), "--json")
        alike = harness.data("compare", self.path("msaa-normal.exr"), self.path("ssaa-normal.exr"))
        self.assertLess(alike["maxAbs"], 1e-3)
        self.assertNotEqual(harness.run("render", "--resolve", "velocity").returncode, 0)

    def test_layers_are_drawn_over_the_image(self):
        self.render("--exr", self.path("plain.exr"))
        data = self.render("--layers", "--exr", self.path("layers.exr"))
        self.assertEqual(data["apiMessages"], [])
        self.assertGreater(harness.data("compare", self.path("plain.exr"), self.path("layers.exr"))["maxAbs"], 0.05)

    def test_white_furnace(self):
        """In light of 1 from everywhere a white surface has the radiance 1, as one that emits 1 and reflects nothing.
        Metal comes near if it is smooth. Aggregates over an edge of the room are rough."""
        light, room, image, white = map(self.path, ("light.hdr", "room.gltf", "image.exr", "white.exr"))
        write_radiance(light, 16, 8)
        black = {"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0}}
        inside = ["--camera=0,0,0,0.3,0.2,-1,80", "--environment", light, "--no-counters"]
        write_room(room, emissiveFactor=[1, 1, 1], **black)
        self.render(*inside, "--without", "specular", "--exr", white, scene=room, size="48x27")
        coat = {"extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 1}}}
        rows = [({"metallicFactor": 0}, {}, ["--without", "specular"], 1e-3),
                ({"metallicFactor": 1, "roughnessFactor": 0.1}, {}, [], 0.01),
                ({"metallicFactor": 1, "roughnessFactor": 0.1}, coat, [], 0.05)]
        for technique in self.shared((["--technique", "ssaa"], ["--technique", "msaa"], ["--technique", "agaa"],
                                      ["--preset", "accurate"])):
            for values, extensions, options, bound in rows:
                with self.subTest(technique=technique, values=values, extensions=extensions):
                    write_room(room, pbrMetallicRoughness=values, **extensions)
                    data = self.render(*inside, *technique, *options, "--exr", image, scene=room, size="48x27")
                    self.assertEqual(data["apiMessages"], [])
                    difference = harness.data("compare", white, image)
                    self.assertLess(difference["maxAbs" if technique[1] != "agaa" else "meanAbsTm"], bound)

    def test_environments_light_surfaces_that_face_them(self):
        """The walls of a room, seen from inside, in light from above and from +x."""
        light, room = self.path("light.hdr"), self.path("room.gltf")
        write_room(room, pbrMetallicRoughness={"metallicFactor": 0})

        def brightness(sight):
            image, black = self.path("image.exr"), self.path("black.exr")
            view = ["--technique", "ssaa", "--without", "specular", f"--camera=0,0,0,{sight},20", "--no-counters"]
            self.render(*view, "--environment", light, "--exr", image, scene=room, size="8x8")
            write_radiance(self.path("dark.hdr"), 16, 8, is_lit=lambda x, y: False)
            self.render(*view, "--environment", self.path("dark.hdr"), "--exr", black, scene=room, size="8x8")
            return harness.data("compare", black, image)["maxAbs"]

        rows = [(lambda x, y: y < 16, "0,-1,0.001", "0,1,0.001"), (lambda x, y: x >= 32, "-1,0,0", "1,0,0"),
                (lambda x, y: 16 <= x < 48, "0,0,1", "0,0,-1")]
        for is_lit, lit, dark in rows:
            write_radiance(light, 64, 32, is_lit=is_lit)
            self.assertAlmostEqual(brightness(lit), 1, delta=0.02)
            self.assertLess(brightness(dark), 0.02)

    def test_environment_lights_every_technique(self):
        light = self.path("light.hdr")
        write_radiance(light, 64, 32, exponent=130)
        self.render("--technique", "ssaa", "--exr", self.path("ambient.exr"), size="48x27")
        lit = ["--environment", light, "--clear-coat", "chrome,brass"]
        data = self.render("--technique", "ssaa", *lit, "--exr", self.path("ssaa.exr"), size="48x27")
        self.assertEqual(data["environment"]["size"], "64x32")
        self.assertEqual(data["environment"]["replacedValues"], 0)
        self.assertGreater(data["environment"]["bytes"], 5000000)
        self.assertGreater(data["environment"]["milliseconds"], 0)
        differences = harness.data("compare", self.path("ambient.exr"), self.path("ssaa.exr"))
        self.assertGreater(differences["meanAbsTm"], 0.01)
        for technique in self.shared(("single", "msaa", "visibility", "simple_complex", "sbaa", "agaa", "dcaa", "sgbc", "adaptive")):
            with self.subTest(technique=technique):
                image = self.path("image.exr")
                data = self.render(*options(technique), *lit, "--exr", image, size="48x27")
                self.assertEqual(data["apiMessages"], [])
                self.assertEqual(data["counters"]["sanitised"], 0)
                near = harness.data("compare", self.path("ssaa.exr"), image)
                self.assertLess(near["meanAbsTm"], 0.5 * differences["meanAbsTm"])

    @on("vk")
    def test_clear_coats_are_of_their_materials(self):
        light = self.path("light.hdr")
        write_radiance(light, 16, 8)
        images = {}
        for names in ("", "chrome", "chrome,brass"):
            images[names] = self.path(names + ".exr")
            coat = ["--clear-coat", names] if names else []
            self.render("--technique", "ssaa", "--environment", light, *coat, "--exr", images[names], size="48x27")
        one = harness.data("compare", images[""], images["chrome"])
        both = harness.data("compare", images[""], images["chrome,brass"])
        self.assertGreater(one["meanAbsTm"], 0)
        self.assertGreater(both["meanAbsTm"], one["meanAbsTm"])
        for arguments in (["--clear-coat", "chrome"], ["--environment", light, "--clear-coat", "gold"],
                          ["--environment", light, "--shading-function", light]):
            refused = harness.run("render", "--scene", "metal", *arguments)
            self.assertEqual(refused.returncode, 2)
            self.assertEqual(len(refused.stderr.strip().splitlines()), 1)
        self.assertIn("chrome", harness.run("render", "--scene", "metal", "--environment", light, "--clear-coat",
                                            "gold").stderr)

    @on("vk")
    def test_filtered_shadows_are_looked_up_once(self):
        plain, filtered = self.path("plain.exr"), self.path("filtered.exr")
        for technique in self.shared(("agaa", "ssaa", "sbaa", "adaptive", "dcaa", "simple_complex")):
            with self.subTest(technique=technique):
                maps = self.render(*options(technique), "--exr", plain, scene="city")["counters"]
                lookups = self.render(*options(technique), "--filtered-shadows", "--exr", filtered, scene="city")["counters"]
                self.assertEqual(lookups["shadowTaps"], lookups["shadingEvents"])
                self.assertEqual(lookups["shadingEvents"], maps["shadingEvents"])
                error = harness.data("compare", plain, filtered)["mseTm"]
                self.render(*options(technique), "--without", "shadows", "--exr", filtered, scene="city")
                self.assertLess(10 * error, harness.data("compare", plain, filtered)["mseTm"])  # a little light bleeds

    @on("vk")
    def test_filtered_shadows_are_equal_on_both_apis(self):
        images = {backend: self.path(backend + ".exr") for backend in ("vk", "gl")}
        for backend, image in images.items():
            harness.data("render", "--backend", backend, "--scene", "city", "--size", "96x54", "--no-timestamps",
                         "--filtered-shadows", "--exr", image)
        self.assertLess(harness.data("compare", *images.values())["mseTm"], 1e-6)

    def test_environments_that_are_none(self):
        def refusal(name):
            result = harness.run("render", "--scene", "metal", "--environment", self.path(name))
            self.assertEqual(result.returncode, 1, name)
            self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
            self.assertIn(name, result.stderr)
            return result.stderr

        for name in ("missing.hdr", "missing.exr", "picture.png"):
            refusal(name)
        for name in ("text.hdr", "text.exr"):
            with open(self.path(name), "w") as file:
                file.write("not an image\n")
            refusal(name)
        for width, height in ((16, 16), (17, 8), (8, 16)):
            write_radiance(self.path("odd.hdr"), width, height)
            self.assertIn(f"{width}x{height}", refusal("odd.hdr"))
        write_radiance(self.path("short.hdr"), 64, 32)
        os.truncate(self.path("short.hdr"), 4000)
        refusal("short.hdr")

    def test_presets(self):
        expected = {"paper": (None, 2), "fast": ("ids", 1), "balanced": ("ids", 4), "accurate": ("ids", 4)}
        for preset, (tier, aggregates) in self.shared(expected.items()):
            data = self.render("--preset", preset, size="48x27")
            self.assertEqual(data["technique"], "agaa")
            self.assertEqual((data["samples"], data["aggregates"]), (8, aggregates))
            if tier:
                self.assertEqual(data["tiers"]["generation"], tier)
            self.assertEqual(data["geometryPasses"], 1 if tier else 2)
            self.assertEqual(data["apiMessages"], [])

    @on("vk")
    def test_samples_are_those_that_were_rendered(self):
        for technique, samples, aggregates in self.shared((("fxaa", 1, 0), ("ssaa", 8, 0), ("sbaa", 8, 2))):
            data = self.render("--technique", technique, size="48x27")
            self.assertEqual((data["samples"], data["aggregates"]), (samples, aggregates), technique)

    @on("gl")
    def test_views(self):
        images = set()
        for view in ("none", "events", "clusters", "primitives", "lit", "widened", "tier"):
            self.render("--tier", "generation=ids", "--view", view, "--png", self.path("v.png"), "--no-counters",
                        size="48x27")
            with open(self.path("v.png"), "rb") as file:
                images.add(file.read())
        self.assertEqual(len(images), 7, "each shows something else")

    def test_odd_sizes(self):
        for size in self.shared(("1x1", "3x5", "33x17")):
            data = self.render("--samples", "32", size=size)
            self.assertEqual(data["apiMessages"], [])
            self.assertEqual(data["counters"]["uncovered"], 0)

    @on("vk")
    def test_reference_says_its_own_error(self):
        def reference(spp):
            return harness.data("reference", "--backend", self.backend, "--scene", "metal", "--size",
                                "48x27", "--spp", str(spp), "--exr", self.path("reference.exr"))

        few, many = reference(4), reference(32)
        self.assertLess(many["splitHalfMseTm"], few["splitHalfMseTm"])

    @on("gl")
    def test_motion_shows_how_late_a_light_appears(self):
        data = harness.data("motion", "--backend", self.backend, "--scene", "metal", "--size", "48x27", "--motion", "light",
                            "--frames", "20", "--spp", "4", "--row", "--technique single", "--row", "--technique taa",
                            "--images", self.path("frames"))
        single, taa = data["rows"]
        self.assertEqual(len(single["errors"]), 20)
        self.assertEqual(len(taa["response"]), 4, "frames with the light")
        self.assertAlmostEqual(single["response"][0], 1, delta=0.2)
        self.assertLess(taa["response"][0], taa["response"][3])
        self.assertLess(taa["response"][0], single["response"][0])
        self.assertIsNone(single["ghosting"], "nothing was hidden")
        for row in ("reference", "row0", "row1"):
            self.assertEqual(len(os.listdir(self.path("frames/" + row))), 20)

    @on("vk")
    def test_footprints_of_references(self):
        for footprint in ("pixel", "sample"):
            data = harness.data("reference", "--backend", self.backend, "--scene", "foliage", "--size", "48x27",
                                "--spp", "16", "--footprint", footprint, "--exr", self.path(footprint + ".exr"))
            self.assertEqual(data["footprint"], footprint)
            self.assertEqual(data["apiMessages"], [])
        data = harness.data("compare", self.path("pixel.exr"), self.path("sample.exr"))
        self.assertGreater(data["mseTm"], 1e-5, "textures are filtered over less")

    # Mesa 22.3's lavapipe never frees the copy of a shader that it makes at each draw whose uniforms decide a branch. With
    # such a branch on the cutoff of each mask a sweep of this scene filled 24 GB.
    def test_masks_make_no_copies_of_shaders(self):
        if self.backend != "vk":
            self.skipTest("of lavapipe")

        def peak(spp):
            process = harness.start("reference", "--scene", "foliage", "--size", "48x27", "--spp", str(spp))
            _, status, usage = os.wait4(process.pid, 0)
            self.assertEqual(status, 0)
            return usage.ru_maxrss / 1024  # MiB
        self.assertLess((peak(40) - peak(8)) / 32, 3, "MiB a frame")

    @on("gl")
    def test_points_where_alpha_is_read(self):
        for points in ("1", "4"):
            data = self.render("--alpha-points", points, "--exr", self.path(points + ".exr"), scene="foliage")
            self.assertEqual((data["counters"]["uncovered"], data["counters"]["overlapping"]), (0, 0))
        self.assertGreater(harness.data("compare", self.path("1.exr"), self.path("4.exr"))["maxAbs"], 0.01)

    # The lists have room for 65536 fragments at least, 4.6 a pixel.
    def test_lists_have_the_room_that_a_frame_needs(self):
        def lists(scene, room):
            return self.render(*options("dcaa"), "--fragments-per-pixel", room, "--frames", "1",
                               size="160x90", scene=scene)

        for scene in self.shared(("foliage", "metal")):
            with self.subTest(scene=scene):
                is_dense = scene == "foliage"
                fixed, fitted = lists(scene, "8"), lists(scene, "auto")
                self.assertEqual(fixed["counters"]["lostFragments"], 0)
                self.assertEqual(fixed["counters"]["batches"] > 1, is_dense)
                self.assertEqual(fitted["counters"]["fragments"], fixed["counters"]["fragments"])
                self.assertEqual(fitted["counters"]["batches"], 1)
                self.assertEqual(fitted["apiMessages"], [])
                self.assertAlmostEqual(fitted["fragmentsPerPixel"], 1.125 * fixed["counters"]["fragments"] / (160 * 90), 4)
                self.assertEqual(fitted["memoryBytes"] > fixed["memoryBytes"], is_dense)
                self.assertEqual(fitted["fragmentsPerPixel"] > 8, is_dense)
                if is_dense:
                    clustered = self.render("--technique", "agaa", "--samples", "64", "--fragments-per-pixel", "auto",
                                            "--frames", "1", size="160x90", scene=scene)
                    self.assertEqual(clustered["counters"]["lostFragments"], 0)
                    self.assertEqual(clustered["fragmentsPerPixel"], fitted["fragmentsPerPixel"])

    # Tiers of coverage samples run on a device without geometry shaders if vertex shaders expand triangles.
    def test_vertex_pulling(self):
        def render(expand, *more):
            return self.render(*options("dcaa"), "--expand", expand, "--exr", self.path(expand + ".exr"), *more, size="64x36",
                               scene="foliage")

        no_geometry = ("--no-geometry-shaders",) if self.backend == "vk" else ()
        geometry, pulling = render("geometry"), render("pulling", *no_geometry)
        self.assertEqual(pulling["counters"]["fragments"], geometry["counters"]["fragments"])
        self.assertEqual(geometry["counters"]["lostFragments"], 0)
        self.assertEqual(pulling["apiMessages"], [])
        self.assertEqual(harness.data("compare", self.path("geometry.exr"), self.path("pulling.exr"))["maxAbs"], 0)
        if not no_geometry:
            return
        caps = harness.data("caps", "--backend", self.backend, *no_geometry)
        self.assertNotIn("geometry-shaders", caps["features"])
        reasons = [row["reason"] for row in caps["tiers"] if row["technique"] == "dcaa" and row["stage"] == "generation"]
        self.assertGreater(len(reasons), 2)
        for reason in reasons:
            self.assertIn("AGAA_VIEW_VERTEX_PULLING", reason)

    def test_caps(self):
        data = harness.data("caps", "--backend", self.backend)
        self.assertIn("fragment-atomics", data["features"])
        without = harness.data("caps", "--backend", self.backend, "--no-conditional-rendering")
        self.assertEqual(without["features"], [f for f in data["features"] if f != "conditional-rendering"])
        self.assertEqual(data["backend"], self.backend)
        self.assertIn(1, data["sampleCounts"])
        for row in data["tiers"]:
            self.assertEqual(set(row), {"technique", "samples", "stage", "tier", "native",
                                        "relativeCost", "reason"})
            self.assertTrue(row["reason"].endswith("."))


class RenderOnOpenGl(Render):
    backend = "gl"
    share = 1

    def test_both_backends_agree(self):
        light = self.path("light.hdr")
        write_radiance(light, 16, 8)
        for layers in ([], ["--layers"], ["--environment", light, "--clear-coat", "chrome"]):
            for backend in ("gl", "vk"):
                self.backend = backend
                self.render(*layers, "--exr", self.path(backend + ".exr"))
            data = harness.data("compare", self.path("vk.exr"), self.path("gl.exr"))
            self.assertLess(data["meanAbsTm"], 0.5 / 255)
            self.assertLessEqual(data["above4of255"], 0.001)


if __name__ == "__main__":
    unittest.main(testLoader=harness.Shard())
