#!/usr/bin/env python3
"""Measures `adaptive` against shading every sample: share of samples, error, times.

Writes OUT/adaptive.json and OUT/adaptive.md. Resumable: what OUT/work holds is not made again.
"""
import argparse
import json
import math
import pathlib
import statistics
import time

from runs import HARNESS, Runs, find_scenes, view_options

SIDES = (2, 3, 4)
PRINTED = ["--printed-metric", "--in-order", "--equal-weights"]
# Name and options of each way to decide.
WAYS = [
    ("adaptive", []),
    ("geometry alone", ["--metrics", "geometry"]),
    ("shading alone", ["--metrics", "shading"]),
    ("half the thresholds", ["--surface", "0.9875,0.75,0.04"]),
    ("a quarter of the thresholds", ["--surface", "0.996875,0.375,0.02"]),
    ("in order", ["--in-order"]),
    ("equal weights", ["--equal-weights"]),
    ("the paper's way", PRINTED),
    ("the paper's metric", PRINTED[:1]),
    ("by id", ["--tier", "generation=ids"]),
    ("by id, footprints of one sample", ["--tier", "generation=ids", "--sample-footprints"]),
    ("at most 1.5 events", ["--target-events", "1.5"]),
    ("at most 2 events", ["--target-events", "2"]),
    ("at most 3 events", ["--target-events", "3"]),
]
# The paper's table 1: samples shaded and mean squared error.
PAPER = {2: (0.578, 5.0e-5), 3: (0.534, 3.08e-5), 4: (0.5313, 3.79e-5)}
# Of section 4.2, whose times are compared.
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
                          "ways": WAYS, "shading": SHADING, **({"lights": self.lights} if self.lights else {})})
        self.image = self.runs.work / "image.exr"
        self.reference = self.runs.work / "reference.exr"

    def render(self, view, technique, n, *options):
        return self.runs.call("render", *view, "--no-validation", "--technique", technique, "--samples", n, *options)

    def errors(self, name, view, side):
        """{way: {share, mse, flip, events}} against all samples of the same grid."""
        n = side * side
        full = self.render(view, "ssaa", n, "--tier", "visibility=ordered-grid", "--exr", self.reference, "--no-timestamps")
        out = {"device": full["device"], "driver": full["driver"], "ways": {}}
        for way, options in WAYS:
            data = self.render(view, "adaptive", n, "--exr", self.image, "--no-timestamps", *options)
            counters = data["counters"]
            error = self.runs.call("compare", self.reference, self.image)
            out["ways"][way] = {"share": counters["shadingEvents"] / counters["visible"], "mse": error["mseTm"],
                                "flip": error["flip"], "events": counters["shadingEvents"] / counters["shadedPixels"],
                                "pixelsByEvents": counters["pixelsByEvents"]}
        print(f"{name}, {side} x {side}", flush=True)
        return out

    def times(self, view, side, rows):
        """{row: median ms}: frames of all rows take turns."""
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
        rows = [(way, "adaptive", options) for way, options in SHADING]
        return self.runs.kept(f"{name}-shading", lambda: self.times(view, 3, rows))


def decibels(mse):
    return -10 * math.log10(max(mse, 1e-12))


def error_lines(scenes):
    yield "| way | " + " | ".join(f"{side} × {side}: samples | dB | worst dB" for side in SIDES) + " |"
    yield "|---" * (1 + 3 * len(SIDES)) + "|"
    for way, _ in WAYS:
        cells = []
        for side in SIDES:
            rows = [scene["errors"][side]["ways"][way] for scene in scenes]
            noise = [decibels(row["mse"]) for row in rows]
            cells.append(f"{statistics.mean(row['share'] for row in rows):.3f} | {statistics.mean(noise):.1f} | {min(noise):.1f}")
        yield f"| {way} | " + " | ".join(cells) + " |"
    cells = [f"{share:.3f} | {decibels(mse):.1f} | –" for share, mse in (PAPER[side] for side in SIDES)]
    yield "| the paper, Sponza | " + " | ".join(cells) + " |"


def scene_lines(scenes):
    yield "| scene | " + " | ".join(f"{side} × {side}: samples | dB | MSE" for side in SIDES) + " |"
    yield "|---" * (1 + 3 * len(SIDES)) + "|"
    for scene in scenes:
        rows = [scene["errors"][side]["ways"]["adaptive"] for side in SIDES]
        yield f"| {scene['scene']} | " + " | ".join(f"{row['share']:.3f} | {decibels(row['mse']):.1f} | {row['mse']:.1e}"
                                                  for row in rows) + " |"


def time_lines(scenes):
    yield "| scene | " + " | ".join(f"cost {cost}: `ssaa` | `simple_complex`" for cost in COSTS) + " |"
    yield "|---" * (1 + 2 * len(COSTS)) + "|"
    ratios = {}
    for scene in scenes:
        cells = []
        for cost in COSTS:
            times = scene["times"][cost]
            for rival in ("ssaa", "simple_complex"):
                ratio = times[rival] / times["adaptive"]
                ratios.setdefault((cost, rival), []).append(ratio)
                cells.append(f"{ratio:.2f}")
        yield f"| {scene['scene']} | " + " | ".join(cells) + " |"
    yield "| median | " + " | ".join(f"{statistics.median(values):.2f}" for values in ratios.values()) + " |"


def shading_lines(shading):
    yield "| way | " + " | ".join(shading) + " |"
    yield "|---" * (1 + len(shading)) + "|"
    for way, _ in SHADING:
        yield f"| {way} | " + " | ".join(f"{times[way] / times['distributed']:.2f}" for times in shading.values()) + " |"


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
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--harness", default=HARNESS, type=pathlib.Path)
    parser.add_argument("--out", default="adaptive", type=pathlib.Path)
    parser.add_argument("--size", default="320x180")
    parser.add_argument("--frames", default=3, type=int)
    parser.add_argument("--turns", default=3, type=int)
    parser.add_argument("--scene", action="append", help="only these; repeatable")
    parser.add_argument("--all-lights", action="store_true", help="times with all lights, not those in reach of a tile")
    arguments = parser.parse_args()
    wanted = find_scenes("adaptive", arguments.scene)
    measurement = Measurement(arguments)
    begin = time.monotonic()
    data = {"size": arguments.size, "frames": arguments.frames, "turns": arguments.turns,
            "lights": "all lights of the scene" if arguments.all_lights else "the lights in reach of each tile",
            "scenes": [measurement.scene(*scene) for scene in wanted],
            "shading": {scene[0]: measurement.shading(*scene) for scene in wanted if scene[0] in ("metal", "foliage")}}
    (arguments.out / "adaptive.json").write_text(json.dumps(data, indent=1) + "\n")
    (arguments.out / "adaptive.md").write_text(markdown(data))
    print(f"Wrote {arguments.out / 'adaptive.md'} after {time.monotonic() - begin:.0f} s")


if __name__ == "__main__":
    main()
