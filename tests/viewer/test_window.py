"""agaa-viewer on one graphics API: pixels, keys, clicks, sizes and errors."""
import base64
import json
import os
import struct
import time
import unittest

import window
from window import Case, Viewer, run, state

BACKEND = os.environ["AGAA_BACKEND"]


def words(options):
    """The command line of agaa-harness render for the options of a state."""
    line = []
    for name, value in options.items():
        if value is True:
            line.append(name)
        else:
            line += [f"{name}={each}" for each in (value if isinstance(value, list) else [value])]
    return line


class Screenshots(Case):
    def compare(self, content):
        shown, expected = self.folder / "viewer.png", self.folder / "harness.png"
        result = run(window.VIEWER, "--state", self.write("state.json", content), "--frames", "1", "--screenshot", shown)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        result = run(window.HARNESS, "render", *words(content["options"]), "--no-counters", "--no-timestamps", "--png",
                     expected)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(shown.read_bytes(), expected.read_bytes())
        return shown.read_bytes()

    def test_agaa(self):
        first = self.compare(state(BACKEND))
        moved = self.compare(state(BACKEND, options={"--camera": "0.5,1.25,4,0,0.75,0,50", "--lights": 20}))
        self.assertNotEqual(first, moved)

    def test_a_debug_view_of_a_preset(self):
        self.compare(state(BACKEND, options={"--preset": "fast", "--samples": 4, "--view": "events"}))

    def test_a_file(self):
        positions = struct.pack("<9f", -1, 0, 0, 1, 0, 0, 0, 1.5, 0)
        document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                    "buffers": [{"byteLength": len(positions), "uri": "data:application/octet-stream;base64,"
                                 + base64.b64encode(positions).decode()}],
                    "bufferViews": [{"buffer": 0, "byteLength": len(positions)}],
                    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                                   "min": [-1, 0, 0], "max": [1, 1.5, 0]}]}
        self.compare(state(BACKEND, str(self.write("triangle.gltf", document)), options={"--technique": "single",
                                                                                        "--samples": 1}))

    def test_a_script_ends_while_frames_play(self):
        shown = self.folder / "viewer.png"
        content = state(BACKEND, options={"--motion": "walk"}, playFrames=True)
        result = run(window.VIEWER, "--state", self.write("state.json", content), "--frames", "3", "--screenshot", shown,
                     timeout=100)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue(shown.is_file())

    def test_accumulated_frames(self):
        self.compare(state(BACKEND, "hard-stripes", options={"--technique": "taa", "--samples": 1, "--frames": 4}))


class Goal(Case):
    def test_the_chosen_settings_are_those_of_the_image(self):
        shown, saved, expected = (self.folder / name for name in ("viewer.png", "saved.json", "harness.png"))
        content = state(BACKEND, "hard-stripes", goal={"on": True, "maxError": 0.1})
        result = run(window.VIEWER, "--state", self.write("state.json", content), "--frames", "1", "--screenshot", shown,
                     "--save-state", saved)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        options = json.loads(saved.read_text())["options"]
        self.assertNotEqual(options, content["options"])
        result = run(window.HARNESS, "render", *words(options), "--no-counters", "--no-timestamps", "--png", expected)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(shown.read_bytes(), expected.read_bytes())


class Comparison(Case):
    def pixels(self, **members):
        path = self.folder / "view.png"
        content = state(BACKEND, "hard-stripes", otherOptions={"--technique": "single", "--samples": 1}, **members)
        result = run(window.VIEWER, "--state", self.write("state.json", content), "--frames", "1", "--screenshot", path)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return path.read_bytes()

    def test_modes_show_different_pixels(self):
        seen = {self.pixels(mode=mode) for mode in ("a", "b", "split", "difference")}
        self.assertEqual(len(seen), 4)
        self.assertNotIn(self.pixels(mode="b", compareWith="reference", referenceSamples=4), seen)


    def test_the_reference_is_that_of_the_command_line(self):
        for options in ({}, {"--camera": "0.5,1.25,4,0,0.75,0,50", "--lights": 20}):
            shown, expected = self.folder / "viewer.png", self.folder / "harness.png"
            content = state(BACKEND, "hard-stripes", options=options, mode="b", compareWith="reference", referenceSamples=8)
            result = run(window.VIEWER, "--state", self.write("state.json", content), "--frames", "1", "--screenshot", shown)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            result = run(window.HARNESS, "reference", *words(content["options"]), "--spp", "8", "--png", expected)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(shown.read_bytes(), expected.read_bytes())


class Person(Case):
    def test_keys_and_clicks(self):
        viewer = Viewer(self, state(BACKEND, otherOptions={"--technique": "single", "--samples": 1}))
        before = viewer.seen()
        viewer.key("t")
        seen = viewer.wait(lambda seen: seen["state"]["options"].get("--technique") not in (None, "agaa"))
        viewer.wait(lambda seen: seen["settled"] and seen["version"] > before["version"] or seen["error"])
        viewer.key("shift+t")
        viewer.wait(lambda seen: seen["state"]["options"]["--technique"] == "agaa" and seen["settled"])
        viewer.key("Tab")
        flipped = viewer.wait(lambda seen: seen["state"]["mode"] == "b" and seen["settled"])
        viewer.key("Tab")
        viewer.wait(lambda seen: seen["state"]["mode"] == "a" and seen["version"] > flipped["version"])
        viewer.click("technique")
        viewer.click("technique:ssaa")
        viewer.wait(lambda seen: seen["state"]["options"]["--technique"] == "ssaa" and seen["settled"])
        viewer.drag("view", 60, 20)
        seen = viewer.wait(lambda seen: "--camera" in seen["state"]["options"] and seen["settled"])
        camera = seen["state"]["options"]["--camera"]
        self.assertEqual(len(camera.split(",")), 7)
        viewer.key("Home")
        viewer.wait(lambda seen: "--camera" not in seen["state"]["options"])
        viewer.key("3")
        viewer.wait(lambda seen: seen["state"]["mode"] == "split" and seen["settled"])
        viewer.drag("split line", 40, 0)
        viewer.wait(lambda seen: seen["state"]["split"] > 0.6)
        saved = viewer.end()
        self.assertEqual(saved["options"]["--technique"], "ssaa")
        self.assertEqual(saved["mode"], "split")

    def test_the_table_of_options(self):
        viewer = Viewer(self, state(BACKEND, "hard-stripes"))
        viewer.click("All options")
        viewer.click("search")
        viewer.xdotool("type", "--delay", "30", "ndf")
        viewer.wait(lambda seen: seen["search"] == "ndf" and "--brdf" not in seen["places"])
        for value, sentence in (("leen", "--ndf is \"leen\""), ("lean", "")):
            viewer.click("--ndf")
            viewer.key("ctrl+a")
            viewer.move_to("view")  # a frame has passed: Dear ImGui handles the letters of a frame before its keys
            viewer.xdotool("type", "--delay", "30", value)
            viewer.click("search")
            viewer.wait(lambda seen: seen["state"]["options"].get("--ndf") == value)
            viewer.wait(lambda seen: sentence in seen["error"] if sentence else seen["settled"] and not seen["error"])
        self.assertEqual(viewer.end()["options"]["--ndf"], "lean")

    def test_sizes(self):
        viewer = Viewer(self, state(BACKEND, texelSize=4, followWindow=True))
        first = viewer.wait(lambda seen: seen["settled"])["imageSize"]
        self.assertEqual(first[0], (1000 - 400) // 4)
        viewer.xdotool("windowsize", viewer.window, "800", "500")
        seen = viewer.wait(lambda seen: seen["imageSize"][0] == (800 - 400) // 4 and seen["settled"])
        self.assertLess(seen["imageSize"][1], first[1])
        frames = seen["frames"]
        viewer.xdotool("windowsize", viewer.window, "1", "1")
        time.sleep(1)
        self.assertEqual(viewer.seen()["imageSize"], seen["imageSize"])
        self.assertEqual(viewer.seen()["error"], "")
        viewer.xdotool("windowsize", viewer.window, "1000", "700")
        viewer.wait(lambda seen: seen["imageSize"] == first and seen["settled"] and seen["frames"] > frames)
        viewer.end()

    def test_minimised(self):
        window.start_window_manager(self)
        viewer = Viewer(self, state(BACKEND, texelSize=4, followWindow=True))
        before = viewer.wait(lambda seen: seen["settled"])
        viewer.xdotool("windowminimize", "--sync", viewer.window)
        time.sleep(1)
        seen = viewer.seen()
        self.assertEqual((seen["imageSize"], seen["error"]), (before["imageSize"], ""))
        viewer.xdotool("windowmap", "--sync", viewer.window)
        viewer.xdotool("windowfocus", "--sync", viewer.window)
        viewer.key("shift+t")
        viewer.wait(lambda seen: seen["state"]["options"].get("--technique") == "sbaa" and seen["settled"])
        viewer.end()

    def test_a_missing_file(self):
        viewer = Viewer(self, state(BACKEND))
        viewer.key("ctrl+o")
        viewer.type("missing.glb")
        viewer.key("Return")
        seen = viewer.wait(lambda seen: "missing.glb" in seen["error"])
        self.assertNotIn("start again", seen["places"])
        viewer.key("ctrl+o")
        viewer.type("hard-stripes")
        viewer.click("open file")
        viewer.wait(lambda seen: seen["settled"] and not seen["error"])
        viewer.end()

    def test_a_camera_path(self):
        viewer = Viewer(self, state(BACKEND, "hard-stripes"))
        viewer.key("r")
        for step in (25, 25):
            before = viewer.seen()["state"]["path"]["cameras"]
            viewer.drag("view", step, 0)
            viewer.wait(lambda seen: len(seen["state"]["path"]["cameras"]) > len(before) and seen["settled"])
        viewer.key("r")
        path = viewer.wait(lambda seen: seen["settled"])["state"]["path"]
        viewer.key("l", "p")
        viewer.wait(lambda seen: seen["state"]["path"]["playing"])
        for position in (0, len(path["cameras"]) - 1):
            viewer.wait(lambda seen: seen["state"]["path"]["position"] == position)
        viewer.key("p")
        viewer.wait(lambda seen: not seen["state"]["path"]["playing"] and seen["settled"])
        before = viewer.seen()["state"]["path"]["position"]
        viewer.key("n")
        viewer.wait(lambda seen: seen["state"]["path"]["position"] != before and seen["settled"])
        self.assertEqual(viewer.end()["path"]["cameras"], path["cameras"])


class Errors(Case):
    def refused(self, status, sentence, *arguments):
        result = run(window.VIEWER, "--frames", "1", *arguments)
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertRegex(result.stderr, "^agaa-viewer: [^\n]*\n$")
        self.assertIn(sentence, result.stderr)

    def test_scripts_end_with_a_sentence(self):
        self.refused(1, "missing.glb", "missing.glb", "--backend", BACKEND)
        self.refused(2, "it is a name that", "missing-name", "--backend", BACKEND)
        self.refused(2, "cannot be read", "--state", self.folder / "missing.json")
        self.refused(2, "is not JSON", "--state", self.write("broken.json", "{"))
        self.refused(2, "unknown member", "--state", self.write("member.json", {**state(BACKEND), "spilt": 1}))
        wrong = state(BACKEND, options={"--tecnique": "agaa"})
        self.refused(2, "\"--tecnique\" is not known", "--state", self.write("option.json", wrong))
        self.refused(2, "--ndf is \"leen\"", "--state", self.write("ndf.json", state(BACKEND, options={"--ndf": "leen"})))
        self.refused(2, "--size is \"0x0\"", "--state", self.write("size.json", state(BACKEND, size="0x0")))
        self.refused(2, "--tecnique", "--tecnique", "agaa")


if __name__ == "__main__":
    window.main()
