#!/usr/bin/env python3
"""Measures what each effect costs in each scene, and what the short ways of the passes save.

Writes OUT/effects.json (counts, bytes, times), OUT/times.json (for `agaa-harness price --times`) and OUT/effects.md.
Resumable: what OUT/work holds is not made again.
"""
import argparse
import json
import pathlib
import statistics

from runs import HARNESS, Runs, find_scenes, view_options

# Name as agaaQueryPrices has it, options with the effect, options without it. What is not named is as in the scene.
EFFECTS = [
    ("specular", [], ["--without", "specular"]),
    ("shading-normals", [], ["--without", "shading-normals"]),
    ("emissive", [], ["--without", "emissive"]),
    ("ambient", [], ["--without", "ambient"]),
    ("local-lights", [], ["--without", "local-lights"]),
    ("shadow-map-0", [], ["--without", "shadows"]),
    ("light-culling", [], ["--no-culling"]),
    ("shadow-filter", [], ["--no-shadow-filter"]),
    ("filtered-diffuse", [], ["--no-diffuse-filter"]),
    ("ndf-widening", [], ["--ndf", "none"]),
    ("lit-aggregates", ["--tier", "generation=gbuffer", "--lit"], ["--tier", "generation=gbuffer"]),
    ("elliptic-lobes", ["--tier", "generation=gbuffer", "--ndf", "lean"], ["--tier", "generation=gbuffer"]),
    ("gloss-weight", ["--tier", "generation=gbuffer", "--gloss-weight", "0.5"], ["--tier", "generation=gbuffer"]),
    ("fact-checks", ["--check-facts"], []),
    ("what facts leave out", ["--plain-facts"], []),
    ("the same frame", [], []), # how far times of equal frames differ
]
# A scene that asks for nothing but diffuse light of the sun.
BARE = ["--without", "specular", "--without", "shading-normals", "--without", "emissive", "--without", "ambient", "--without", "shadows",
        "--without", "local-lights"]
# Of the short ways: options that switch them off.
LONG_WAYS = [
    ("one surface is not clustered", ["--split-surfaces"]),
    ("lights and shadows out of reach are left out", ["--no-culling"]),
]
# What a bound could prove for a pixel, whether passes use it, and how or why not.
SHORT_WAYS = [
    ("no sample shows geometry: only background", "yes", "pixels without coverage have no shading event"),
    ("one primitive or one plane: no clustering", "yes", "samples of one surface are one aggregate; `--split-surfaces` switches it off"),
    ("normals do not vary: no widening", "yes", "a mean normal as long as rounding allows leaves the lobe as it is"),
    ("a light does not reach the tile: not evaluated", "yes", "`cull lights`; `--no-culling` switches it off"),
    ("nothing that a shadow's lights reach: no lookup", "yes", "shadows are looked up only where one of their lights reaches the tile"),
    ("flat aggregate: one shadow lookup", "no", "the edge of a shadow may cross a plane between two of its samples"),
    ("all samples lit, or none: one lookup", "no", "a bound would need the least and the greatest depth of an area of the host's shadow map"),
]
# Of two geometry passes: what aggregates keep of normals, and the options for it.
NORMALS = [
    ("aggregates keep normals", ["--without", "specular", "--without", "local-lights"]),
    ("aggregates take those of the prepass",
     ["--without", "specular", "--without", "local-lights", "--without", "shading-normals"]),
]


def summary(data):
    counters = data["counters"]
    events = max(counters["shadingEvents"], 1)
    return {"passes": len(data["passes"]), "bytesPerPixel": data["bytesPerPixel"], "events": counters["shadingEvents"],
            "taps": counters["shadowTaps"], "lights": counters["lightEvaluations"], "tapsPerEvent": counters["shadowTaps"] / events,
            "lightsPerEvent": counters["lightEvaluations"] / events}


class Measurement:
    def __init__(self, arguments):
        self.arguments = arguments
        self.runs = Runs("scene_effects", arguments.harness, arguments.out,
                         {"size": arguments.size, "frames": arguments.frames, "turns": arguments.turns, "effects": EFFECTS,
                          "long": LONG_WAYS, "normals": NORMALS})
        width, height = (int(side) for side in arguments.size.split("x"))
        self.pixels = width * height
        self.image, self.other = self.runs.work / "image.exr", self.runs.work / "other.exr"

    def render(self, view, *options):
        return self.runs.call("render", *view, "--no-validation", "--technique", "agaa", "--samples", 8, *options)

    def ratio(self, view, more, less):
        """Median frame with `more` by that with `less`; frames take turns."""
        times = {0: [], 1: []}
        for turn in range(self.arguments.turns):
            for which in (0, 1) if turn % 2 == 0 else (1, 0):
                data = self.render(view, "--frames", self.arguments.frames, "--no-timestamps", *(more, less)[which])
                times[which].append(data["frameMs"]["median"])
        return statistics.median(times[0]) / statistics.median(times[1])

    def effects(self, view):
        rows = {}
        for name, more, less in EFFECTS:
            with_it = summary(self.render(view, *more))
            without = summary(self.render(view, *less))
            rows[name] = {"with": with_it, "without": without, "ratio": self.ratio(view, more, less)}
        bare = self.render(view, *BARE)
        rows["bare"] = {"with": summary(self.render(view)), "without": summary(bare), "ratio": self.ratio(view, [], BARE)}
        return rows

    def short_ways(self, view):
        data = self.render(view, "--exr", self.image)
        counters, rows = data["counters"], {}
        pixels = self.pixels
        rows["uncovered pixels"] = {"share": 1 - counters["shadedPixels"] / pixels}
        rows["pixels of one aggregate"] = {"share": counters["pixelsByEvents"][0] / max(counters["shadedPixels"], 1)}
        for name, options in LONG_WAYS:
            other = self.render(view, "--exr", self.other, *options)
            error = self.runs.call("compare", self.image, self.other)
            rows[name] = {"short": summary(data), "long": summary(other), "largest": error["maxAbs"],
                          "mse": error["mseTm"], "ratio": self.ratio(view, options, [])}
        return rows

    def normals(self, view):
        """How far two geometry passes are from aggregates of a G-buffer with the same facts, which keep normals in both rows."""
        rows = {}
        for name, options in NORMALS:
            self.render(view, "--exr", self.image, *options)
            self.render(view, "--exr", self.other, "--tier", "generation=gbuffer", "--buffered", *options)
            rows[name] = self.runs.call("compare", self.other, self.image)["mseTm"]
        return rows

    def scene(self, source, camera):
        view = view_options(source, camera, self.arguments.size)
        return {"effects": self.effects(view), "short": self.short_ways(view), "normals": self.normals(view)}


def change(row, key):
    """What the effect adds, as a table's cell."""
    more, less = row["with"][key], row["without"][key]
    if more == less:
        return ""
    difference = more - less
    return f"{difference:+.4g}" if key in ("bytesPerPixel", "tapsPerEvent", "lightsPerEvent") else f"{difference:+d}"


def effects_table(scenes):
    """A row for each effect, over all scenes."""
    lines = ["| effect | passes | bytes a pixel | events | shadow taps an event | lights an event | time, median (least to most) |",
             "|---|---:|---:|---:|---:|---:|---:|"]
    for name in next(iter(scenes.values()))["effects"]:
        rows = [scene["effects"][name] for scene in scenes.values()]
        cells = []
        for key in ("passes", "bytesPerPixel", "events", "tapsPerEvent", "lightsPerEvent"):
            values = sorted({change(row, key) or "0" for row in rows}, key=float)
            cells.append("" if values == ["0"] else values[0] if len(values) == 1 else f"{values[0]} to {values[-1]}")
        ratios = sorted(row["ratio"] for row in rows)
        title = {"bare": "all but diffuse sun light"}.get(name, f"`{name}`" if " " not in name else name)
        lines.append(f"| {title} | " + " | ".join(cells) + f" | {statistics.median(ratios):.2f} ({ratios[0]:.2f} to {ratios[-1]:.2f}) |")
    return lines


def scene_table(scenes):
    """Time ratio of each effect in each scene."""
    names = list(next(iter(scenes.values()))["effects"])
    lines = ["| effect | " + " | ".join(scenes) + " |", "|---|" + "---:|" * len(scenes)]
    for name in names:
        lines.append(f"| {name} | " + " | ".join(f"{s['effects'][name]['ratio']:.2f}" for s in scenes.values()) + " |")
    return lines


def short_table(scenes):
    lines = ["| short way | " + " | ".join(scenes) + " | largest difference |", "|---|" + "---:|" * (len(scenes) + 1)]
    for name in ("uncovered pixels", "pixels of one aggregate"):
        lines.append(f"| {name}, share | " + " | ".join(f"{s['short'][name]['share']:.2f}" for s in scenes.values()) + " | |")
    for name, _ in LONG_WAYS:
        rows = [s["short"][name] for s in scenes.values()]
        largest = max(row["largest"] for row in rows)
        for key, what in (("lights", "light evaluations"), ("taps", "shadow taps"), ("events", "events")):
            if any(row["long"][key] != row["short"][key] for row in rows):
                lines.append(f"| {name}: {what} with it | "
                             + " | ".join(f"{row['short'][key] / max(row['long'][key], 1):.2f}" for row in rows)
                             + f" | {largest:.3g} |")
        lines.append(f"| {name}: frame without it | " + " | ".join(f"{row['ratio']:.2f}" for row in rows) + f" | {largest:.3g} |")
    return lines


def normals_table(scenes):
    lines = ["| two geometry passes | " + " | ".join(scenes) + " |", "|---|" + "---:|" * len(scenes)]
    for name, _ in NORMALS:
        lines.append(f"| {name} | " + " | ".join(f"{scene['normals'][name]:.2g}" for scene in scenes.values()) + " |")
    return lines


def times_file(results):
    """What `agaa-harness price --times` reads: medians over the scenes."""
    scenes = results["scenes"].values()
    names = [name for name, _, _ in EFFECTS if " " not in name]
    return {"device": results["device"],
            "effects": {name: {"ratio": statistics.median(s["effects"][name]["ratio"] for s in scenes)} for name in names}}


def page(results):
    scenes = results["scenes"]
    return "\n".join([
        "# What effects cost, measured", "",
        f"Made by `benchmark/scene_effects.py` on {results['device']}, {results['driver']}: `agaa`, n = 8, c = 2, "
        f"{results['size']}, Vulkan. Frames with and without an effect took turns.", "",
        "## Effects over all scenes", "",
        "What an effect adds; from the least to the most of the scenes where they differ. A time is that of frames with the",
        "effect as a multiple of frames without it.",
        "In the row \"the same frame\" both are equal: its times tell the noise.", "", *effects_table(scenes), "",
        "## Time by scene", "", *scene_table(scenes), "",
        "## Short ways", "",
        "| what holds for a pixel | used | |", "|---|---|---|", *(f"| {what} | {used} | {how} |" for what, used, how in SHORT_WAYS), "",
        "Pixels and tiles for which passes do less, because the result is the same or meant to be. A share of counts is that",
        "with the short way as a part of that without. The largest difference is that of a channel of any pixel, linear.", "",
        *short_table(scenes), "",
        "## Normals of the prepass", "",
        "Mean square errors of two geometry passes after tone mapping, against aggregates that a G-buffer fills; without specular",
        "light and without local lights. In the second row both have AGAA_FACT_PLANE_NORMALS, with which aggregates of two",
        "geometry passes then take the 16 bits of the prepass.", "",
        *normals_table(scenes), ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--harness", type=pathlib.Path, default=HARNESS)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--scene", action="append", help="repeatable; all by default")
    parser.add_argument("--size", default="320x180")
    parser.add_argument("--frames", type=int, default=3)
    parser.add_argument("--turns", type=int, default=3)
    arguments = parser.parse_args()
    measurement = Measurement(arguments)
    results = {"size": arguments.size, "scenes": {}}
    for name, source, camera in find_scenes("scene_effects", arguments.scene):
        results["scenes"][name] = measurement.runs.kept(name, lambda: measurement.scene(source, camera))
        print(name, flush=True)
    device = measurement.runs.call("caps", "--backend", "vk")
    results.update(device=device["device"], driver=device["driver"])
    (arguments.out / "effects.json").write_text(json.dumps(results, indent=1) + "\n")
    (arguments.out / "times.json").write_text(json.dumps(times_file(results), indent=1) + "\n")
    (arguments.out / "effects.md").write_text(page(results))
    print(f"Wrote {arguments.out}/effects.json, times.json and effects.md.")


if __name__ == "__main__":
    main()
