#!/usr/bin/env python3
"""Measures `adaptive` against shading every sample: share of samples, error, times.

Writes OUT/adaptive.json and OUT/adaptive.md. An interrupted run continues with the results in OUT/work.
"""
import math
import statistics
import time

from command_line import tool_parser
from markdown_table import table
from runs import Runs, find_scenes, view_options, write_results

SIDES = (2, 3, 4)
PRINTED = ["--printed-metric", "--in-order", "--equal-weights"]
# Name and options of each configuration of the decision.
CONFIGURATIONS = [
    ("adaptive", []),
    ("geometry alone", ["--metrics", "geometry"]),
    ("shading alone", ["--metrics", "shading"]),
    ("half the thresholds", ["--surface", "0.9875,0.75,0.04"]),
    ("a quarter of the thresholds", ["--surface", "0.996875,0.375,0.02"]),
    ("in order", ["--in-order"]),
    ("equal weights", ["--equal-weights"]),
    ("the paper's way", PRINTED),
    ("the paper's metric", PRINTED[:1]),
    ("the paper's metric, with the background", [*PRINTED[:1], "--count-background"]),
    ("by id", ["--tier", "generation=ids"]),
    ("by id, footprints of one sample", ["--tier", "generation=ids", "--sample-footprints"]),
    ("at most 1.5 events", ["--target-events", "1.5"]),
    ("at most 2 events", ["--target-events", "2"]),
    ("at most 3 events", ["--target-events", "3"]),
]
# The paper's table 1: samples shaded and mean squared error.
PAPER = {2: (0.578, 5.0e-5), 3: (0.534, 3.08e-5), 4: (0.5313, 3.79e-5)}
# Name and options of each configuration of section 4.2; their times are compared.
SHADING = [
    ("distributed", []),
    ("loop", ["--loop"]),
    ("loop, buckets", ["--loop", "--buckets"]),
    ("loop, sorted", ["--loop", "--sorted"]),
    ("loop, maximum of a tile", ["--loop", "--tile-maximum"]),
]
COSTS = (1, 4, 16)


class Measurement:
    def __init__(self, arguments):
        self.arguments = arguments
        self.lights = ["--no-culling"] if arguments.all_lights else []
        self.runs = Runs("adaptive", arguments.harness, arguments.out,
                         {"size": arguments.size, "frames": arguments.frames, "turns": arguments.turns,
                          "configurations": CONFIGURATIONS, "shading": SHADING, **({"lights": self.lights} if self.lights else {})})
        self.image = self.runs.work / "image.exr"
        self.reference = self.runs.work / "reference.exr"

    def render(self, view, technique, n, *options):
        return self.runs.call("render", *view, "--no-validation", "--technique", technique, "--samples", n, *options)

    def errors(self, name, view, side):
        """Errors of each configuration against all samples of the same grid: {name: {share, mse, flip, events}}."""
        n = side * side
        full = self.render(view, "ssaa", n, "--tier", "visibility=ordered-grid", "--exr", self.reference, "--no-timestamps")
        out = {"device": full["device"], "driver": full["driver"], "ways": {}}
        for configuration, options in CONFIGURATIONS:
            data = self.render(view, "adaptive", n, "--exr", self.image, "--no-timestamps", *options)
            counters = data["counters"]
            error = self.runs.call("compare", self.reference, self.image)
            out["ways"][configuration] = {
                "share": counters["shadingEvents"] / counters["visible"], "mse": error["mseTm"], "flip": error["flip"],
                "events": counters["shadingEvents"] / counters["shadedPixels"], "pixelsByEvents": counters["pixelsByEvents"]}
        print(f"{name}, {side} x {side}", flush=True)
        return out

    def times(self, view, side, rows):
        """Median milliseconds of each row, {name: ms}. The rows are measured in alternating order."""
        frames = {name: [] for name, _, _ in rows}
        for turn in range(self.arguments.turns):
            for name, technique, options in rows if turn % 2 == 0 else reversed(rows):
                data = self.render(view, technique, side * side, "--frames", self.arguments.frames, "--no-timestamps", *options)
                frames[name].append(data["frameMs"]["median"])
        return {name: statistics.median(values) for name, values in frames.items()}

    def scene(self, name, source, camera):
        view = view_options(source, camera, self.arguments.size)
        out = {"scene": name, "errors": {}, "times": {}}
        for side in SIDES:
            out["errors"][side] = self.runs.kept(f"{name}-{side}", lambda: self.errors(name, view, side))
        grid = ["--tier", "visibility=ordered-grid"]
        for cost in COSTS:
            rows = [(technique, technique, [*grid, *self.lights, "--shading-cost", cost])
                    for technique in ("ssaa", "simple_complex", "adaptive")]
            out["times"][cost] = self.runs.kept(f"{name}-times-{cost}", lambda: self.times(view, 3, rows))
        return out

    def shading(self, name, source, camera):
        view = view_options(source, camera, self.arguments.size)
        rows = [(configuration, "adaptive", options) for configuration, options in SHADING]
        return self.runs.kept(f"{name}-shading", lambda: self.times(view, 3, rows))


def decibels(mse):
    return -10 * math.log10(max(mse, 1e-12))


def error_lines(scenes):
    rows = []
    for configuration, _ in CONFIGURATIONS:
        cells = []
        for side in SIDES:
            found = [scene["errors"][side]["ways"][configuration] for scene in scenes]
            noise = [decibels(each["mse"]) for each in found]
            cells += [f"{statistics.mean(each['share'] for each in found):.3f}", f"{statistics.mean(noise):.1f}",
                      f"{min(noise):.1f}"]
        rows.append([configuration, *cells])
    paper = [cell for share, mse in (PAPER[side] for side in SIDES)
             for cell in (f"{share:.3f}", f"{decibels(mse):.1f}", "–")]
    return table(["way", *(cell for side in SIDES for cell in (f"{side} × {side}: samples", "dB", "worst dB"))],
                 [*rows, ["the paper, Sponza", *paper]])


def scene_lines(scenes):
    rows = []
    for scene in scenes:
        found = [scene["errors"][side]["ways"]["adaptive"] for side in SIDES]
        rows.append([scene["scene"], *(cell for each in found for cell in (
            f"{each['share']:.3f}", f"{decibels(each['mse']):.1f}", f"{each['mse']:.1e}"))])
    return table(["scene", *(cell for side in SIDES for cell in (f"{side} × {side}: samples", "dB", "MSE"))], rows)


def time_lines(scenes):
    rows, ratios = [], {}
    for scene in scenes:
        cells = []
        for cost in COSTS:
            times = scene["times"][cost]
            for rival in ("ssaa", "simple_complex"):
                ratio = times[rival] / times["adaptive"]
                ratios.setdefault((cost, rival), []).append(ratio)
                cells.append(f"{ratio:.2f}")
        rows.append([scene["scene"], *cells])
    rows.append(["median", *(f"{statistics.median(values):.2f}" for values in ratios.values())])
    return table(["scene", *(cell for cost in COSTS for cell in (f"cost {cost}: `ssaa`", "`simple_complex`"))], rows)


def shading_lines(shading):
    return table(["way", *shading],
                 [[configuration, *(f"{times[configuration] / times['distributed']:.2f}" for times in shading.values())]
                  for configuration, _ in SHADING])


def markdown(data):
    first = data["scenes"][0]["errors"][SIDES[0]]
    return "\n".join([
        "# Adaptive supersampling beside shading every sample", "",
        f"Generated by `benchmark/adaptive.py` on {first['device']} ({first['driver']}): {data['size']}, "
        f"{len(data['scenes'])} scenes. Errors are against `ssaa` with the same samples on an ordered grid, after tone mapping; "
        "decibels are of a peak of 1. The share of samples shaded is of those that show geometry. The paper's metric is "
        "calibrated for Sponza.", "",
        "## Means over all scenes", "", *error_lines(data["scenes"]), "",
        "## The default in each scene", "", *scene_lines(data["scenes"]), "",
        "## Frame times at 3 × 3", "",
        f"The rival's frame time by that of `adaptive`, with lighting evaluated 1, 4 and 16 times: medians of {data['turns']} turns "
        f"of {data['frames']} frames. Above 1, `adaptive` is quicker. "
        f"Evaluated are {data['lights']}. The default scenes have 17 lights.", "", *time_lines(data["scenes"]), "",
        "## Ways to shade unequal numbers of samples", "",
        "Frame times by that of the default, which distributes events among all invocations of a group.", "",
        *shading_lines(data["shading"])]) + "\n"


def main():
    parser = tool_parser(__doc__, out="adaptive", size="320x180", scenes=True, frames=3, turns=3)
    parser.add_argument("--all-lights", action="store_true", help="times with all lights, not those in reach of a tile")
    arguments = parser.parse_args()
    wanted = find_scenes("adaptive", arguments.scene)
    measurement = Measurement(arguments)
    begin = time.monotonic()
    data = {"size": arguments.size, "frames": arguments.frames, "turns": arguments.turns,
            "lights": "all lights of the scene" if arguments.all_lights else "the lights in reach of each tile",
            "scenes": [measurement.scene(*scene) for scene in wanted],
            "shading": {scene[0]: measurement.shading(*scene) for scene in wanted if scene[0] in ("metal", "foliage")}}
    write_results(arguments.out, "adaptive", data, markdown(data))
    print(f"Wrote {arguments.out / 'adaptive.md'} after {time.monotonic() - begin:.0f} s")


if __name__ == "__main__":
    main()
