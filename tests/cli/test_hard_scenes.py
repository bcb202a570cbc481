"""The command hard-scenes: bounds hold in a covering set, and a frame beyond them fails."""
import json
import os
import pathlib
import unittest

import harness

KEPT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "results" / "hard-scenes.json"
TECHNIQUES = {"single", "fxaa", "smaa", "taa", "visibility", "msaa", "ssaa", "simple_complex", "sbaa", "agaa", "dcaa", "sgbc", "adaptive"}
ONLY_AGGREGATES = "dark-ramp-sums", "size-1080p"


def hard_scenes(*arguments):
    return harness.data("hard-scenes", *arguments)


class HardScenes(unittest.TestCase):
    def test_covering_frames_keep_their_bounds(self):
        part = os.environ["AGAA_PART"]
        data = hard_scenes("--covering", "1", "--spp", "32", "--part", part)
        self.assertEqual(data["nonFinite"], 0)
        self.assertEqual(data["exceeding"], 0)
        self.assertEqual(data["apiMessages"], [])
        self.assertEqual({row["backend"] for row in data["results"]}, {"vk", "gl"})
        self.assertEqual({row["technique"] for row in data["results"]}, TECHNIQUES)
        scenes = {frame["scene"] for frame in hard_scenes("--list")} - set(ONLY_AGGREGATES)
        self.assertEqual({row["scene"] for row in data["results"]} - set(ONLY_AGGREGATES), scenes)
        print(f"{data['nonFinite']} non-finite channels in {data['frames']} frames")


class Command(unittest.TestCase):
    def test_flat_triangles_agree_in_all_tiers(self):
        """Expanded triangles need the normal of their plane, if it shades: 1.15e-3 with (0, 0, 1), 4.5e-6 with it."""
        data = hard_scenes("--scene", "duplicates", "--technique", "dcaa", "--samples", "64", "--aggregates", "8",
                           "--backend", "gl", "--spp", "32")
        errors = {row["tier"]: row["mseTm"] for row in data["results"]}
        self.assertLessEqual({"lists", "material-lists"}, set(errors))
        for tier, error in errors.items():
            self.assertLess(error, 2e-5, tier)

    def test_list_names_scenes_of_render(self):
        frames = hard_scenes("--list")
        self.assertGreaterEqual(len(frames), 28)
        scenes = {scene["name"] for scene in harness.data("scenes")["hardScenes"]}
        self.assertEqual({frame["builtin"] for frame in frames} - scenes, set())

    def test_kept_results_have_these_bounds(self):
        kept = {scene["scene"]: scene for scene in json.loads(KEPT.read_text())["scenes"]}
        for frame in hard_scenes("--list"):
            self.assertEqual({key: kept[frame["scene"]][key] for key in frame}, frame)


if __name__ == "__main__":
    unittest.main()
