"""Wrong arguments: exit status 2 (1 for what is not an argument's fault) and one line on stderr."""
import json
import os
import tempfile
import unittest

import harness

WRONG = [
    [],
    ["bogus"],
    ["render", "--bogus", "1"],
    ["memory", "--samples", "0"],
    ["memory", "--samples", "3"],
    ["memory", "--samples", "48"],
    ["memory", "--samples", "x"],
    ["memory", "--aggregates", "0"],
    ["memory", "--aggregates", "5"],
    ["memory", "--size", "0x0"],
    ["memory", "--size", "640"],
    ["memory", "--size", "640x"],
    ["memory", "--size", "-4x3"],
    ["memory", "--technique", "mlaa"],
    ["memory", "--layout", "nonesuch"],
    ["memory", "--tier", "generation=bogus"],
    ["memory", "--tier", "nowhere=native"],
    ["memory", "--backend", "d3d"],
    ["caps", "--backend", "metal"],
    ["render", "--scene", "nonesuch"],
    ["render", "--camera", "1,2,3"],
    ["render", "--camera=-1,2,3,4,5,6,x"],
    ["render", "--camera=1,2,3,1,2,3,60"],
    ["render", "--camera=1,2,3,4,5,6,180"],
    ["render", "--frames", "0"],
    ["render", "--brdf", "lambert"],
    ["render", "--backend", "gl", "--state-policy", "often"],
    ["render", "--ndf", "ggx"],
    ["render", "--seeds", "random"],
    ["render", "--k", "-1"],
    ["render", "--jitter", "1"],
    ["render", "--view", "heat"],
    ["render", "--preset", "best"],
    ["render", "--preset", "fast", "--aggregates", "3"],
    ["compare", "only-one.exr"],
    ["reference", "--spp", "1"],
    ["reference", "--footprint", "texel"],
    ["motion", "--row", "--technique single", "--frames", "3"],
    ["motion", "--row", "--technique nothing"],
    ["motion", "--row", "--colour"],
    ["motion", "--row", "--technique single", "--motion", "fall"],
    ["motion"],
    ["render", "--motion", "fall"],
    ["render", "--alpha-points", "2"],
    ["render", "--dither-frame", "-1"],
    ["render", "--shading-function", "/no/such/file.glsl"],
    ["render", "--shading-level", "2"],
    ["render", "--clear-coat", "steel"],
    ["compare", "a.exr", "b.exr", "--environment", "sky.hdr"],
    ["render", "--expand", "mesh"],
    ["render", "--fragments-per-pixel", "many"],
    ["plan", "--technique", "dcaa", "--samples", "64", "--fragments-per-pixel", "auto"],
    ["plan", "--technique", "dcaa", "--samples", "64", "--coverage-pattern", "halton"],
    ["plan", "--technique", "dcaa", "--samples", "64", "--table-size", "-1"],
    ["memory", "--technique", "dcaa", "--samples", "64", "--fragments-per-pixel", "auto"],
    ["choose", "--prefer", "beauty"],
    ["choose", "--max-error", "0.1", "--observe"],
    ["choose", "--max-error", "little"],
    ["choose", "--measured"],
    ["price", "--technique", "mlaa"],
    ["hard-scenes", "--scene", "mirrors"],
    ["hard-scenes", "--part", "3/2"],
    ["hard-scenes", "--part", "0/1"],
    ["hard-scenes", "--technique", "agaa", "--samples", "3"],
    ["hard-scenes", "--covering", "0"],
    ["price", "--samples", "5"],
    ["price", "--without", "fur"],
    ["price", "--times"],
    ["price", "--scene", "nonesuch"],
    ["sweep", "--jpeg", "0"],
]

FAILS = [
    ["render", "--backend", "gl", "--glsl", "300"],
    ["compare", "/nonexistent/a.exr", "/nonexistent/b.exr"],
    ["render", "--scene", "/nonexistent/scene.glb"],
    ["render", "--environment", "/nonexistent/sky.hdr"],
    ["reference", "--environment", "/nonexistent/sky.exr"],
    ["memory", "--size", "20000x20000", "--samples", "32"],
    ["memory", "--samples", "8", "--tier", "visibility=native"],
    ["plan", "--k-per-distance", "0"],
    ["plan", "--technique", "dcaa", "--samples", "64", "--coverage-pattern", "r2", "--table-size", "8"],
    ["plan", "--technique", "ssaa", "--view", "clusters"],
    ["plan", "--lit", "--buffered"],
    ["price", "--times", "/nonexistent/times.json"],
    ["choose", "--measured", "/nonexistent/measured.json"],
    ["choose", "--max-error", "2"],
    ["choose", "--max-ms", "-1"],
    ["choose", "--scene-share", "nan"],
    ["choose", "--max-bytes", "1", "--size", "200000x200000"],
    ["price", "--size", "20000x20000", "--samples", "32"],
    ["plan", "--technique", "dcaa", "--samples", "64", "--no-geometry-shaders"],
]


class Arguments(unittest.TestCase):
    def check(self, arguments, status):
        result = harness.run(*arguments)
        self.assertEqual(result.returncode, status, f"{arguments}: {result.stderr}")
        self.assertEqual(result.stdout, "", arguments)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)

    def test_wrong_arguments_exit_with_2(self):
        for arguments in WRONG:
            with self.subTest(arguments=arguments):
                self.check(arguments, 2)

    def test_other_failures_exit_with_1(self):
        for arguments in FAILS:
            with self.subTest(arguments=arguments):
                self.check(arguments, 1)

    def test_missing_files_are_named(self):
        result = harness.run("compare", "/nonexistent/a.exr", "/nonexistent/b.exr")
        self.assertIn("/nonexistent/a.exr", result.stderr)

    def test_files_of_times(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "times.json")
            for text in ("{", "[]", '{"device": "d"}', '{"device": "d", "effects": {"specular": {}}}',
                         '{"device": 1, "effects": {}}', '{"device": "d", "effects": {"specular": {"ratio": "x"}}}'):
                with open(path, "w") as file:
                    file.write(text)
                with self.subTest(text=text):
                    self.check(["price", "--times", path], 1)

    def test_files_of_measured_settings(self):
        row = {"technique": "single", "samples": 1, "aggregates": 0, "errorShare": 1, "error": 0.01}
        wrong = [{"samples": -1}, {"samples": 1.5}, {"samples": 2**32}, {"technique": None}, {"technique": "mlaa"}, {"samples": 7},
                 {"tier": "fast"}, {"preset": 1}, {"errorShare": -1}, {"errorShare": "1"}, {"error": 1e300}, {"errorShare": 0},
                 {"geometryMs": 1}, {"pixels": 4, "geometryMs": -1}]
        texts = ["{", "[]", "{}", '{"measured": []}', '{"measured": 1}', '{"measured": [1]}', '{"measured": [{}]}']
        texts += [json.dumps({"measured": rows}) for rows in [[row, row], *([{**row, **change}] for change in wrong)]]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "measured.json")
            for text in texts:
                with open(path, "w") as file:
                    file.write(text)
                with self.subTest(text=text):
                    self.check(["choose", "--measured", path], 1)
            with open(path, "w") as file:
                json.dump({"measured": [row]}, file) # what they were changed from
            self.assertEqual(harness.data("choose", "--measured", path)["technique"], "single")

    def test_features_that_a_scene_drops(self):
        scene = {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                 "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," + "A" * 48}],
                 "bufferViews": [{"buffer": 0, "byteLength": 36}],
                 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
                 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": mode} for mode in (1, 3, 4)]}]}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "LINES.GLTF")
            with open(path, "w") as file:
                json.dump(scene, file)
            result = harness.run("plan", "--scene", path, "--json")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(result.stderr, f"warning: {path}: lines are not drawn.\n")
            json.loads(result.stdout)
            scene["buffers"][0]["uri"] += "A" * 1000000  # more bytes than the buffer has
            with open(path, "w") as file:
                json.dump(scene, file)
            self.check(["plan", "--scene", path], 1)
            self.assertLess(len(harness.run("plan", "--scene", path).stderr), 500)

    def test_layout_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "layout.json")
            with open(path, "w") as file:
                file.write('{"attributes": [{"semantic": "diffuse", "channels": 3, "sampleBits": 8},'
                           '{"semantic": "normal", "channels": 3, "sampleBits": 16}]}')
            lean = harness.data("memory", "--layout", path)
            self.assertLess(lean["bytesPerPixel"], harness.data("memory")["bytesPerPixel"])
            with open(path, "w") as file:
                file.write('{"attributes": [{"semantic": "fur"}]}')
            self.check(["memory", "--layout", path], 2)
            with open(path, "w") as file:
                file.write("{")
            self.check(["memory", "--layout", path], 2)
            for channels in ("1e38", "3.7", "-1", "4294967299"):
                with open(path, "w") as file:
                    file.write('{"attributes": [{"semantic": "diffuse", "channels": %s, "sampleBits": 8},'
                               '{"semantic": "normal", "channels": 3, "sampleBits": 16}]}' % channels)
                self.check(["memory", "--layout", path], 2)
                self.assertIn("is not a whole number from 0 to", harness.run("memory", "--layout", path).stderr)

    def test_help_exits_with_0(self):
        self.assertEqual(harness.run("--help").returncode, 0)
        self.assertEqual(harness.run("render", "--help").returncode, 0)


if __name__ == "__main__":
    unittest.main()
