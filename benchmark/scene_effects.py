#!/usr/bin/env python3
"""Measures what each effect costs in each scene, and what the early-outs of the passes save.

Writes OUT/effects.json (counts, bytes, times), OUT/times.json (for `agaa-harness price --times`) and OUT/effects.md.
An interrupted run continues with the results in OUT/work.
"""
import statistics

from command_line import tool_parser
from markdown_table import table
from runs import Runs, find_scenes, view_options, write_json, write_results

# Name of the effect for agaaQueryPrices, options with the effect, options without it. All else is as in the scene.
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
    ("the same frame", [], []),  # shows how far times of equal frames differ
]
# Leaves only the diffuse light of the sun.
BARE = ["--without", "specular", "--without", "shading-normals", "--without", "emissive", "--without", "ambient", "--without", "shadows",
        "--without", "local-lights"]
# Early-outs and the options that switch them off.
SWITCHABLE_EARLY_OUTS = [
    ("one surface is not clustered", ["--split-surfaces"]),
    ("lights and shadows out of reach are left out", ["--no-culling"]),
]
# A property that a bound could prove for a pixel, whether passes use it, and how or why not.
EARLY_OUTS = [
    ("no sample shows geometry: only background", "yes", "pixels without coverage have no shading event"),
    ("one primitive or one plane: no clustering", "yes", "samples of one surface are one aggregate; `--split-surfaces` switches it off"),
    ("normals do not vary: no widening", "yes", "a mean normal as long as rounding allows leaves the lobe as it is"),
    ("a light does not reach the tile: not evaluated", "yes", "`cull lights`; `--no-culling` switches it off"),
    ("nothing that a shadow's lights reach: no lookup", "yes", "shadows are looked up only where one of their lights reaches the tile"),
    ("flat aggregate: one shadow lookup", "no", "the edge of a shadow may cross a plane between two of its samples"),
    ("all samples lit, or none: one lookup", "no", "a bound would need the least and the greatest depth of an area of the host's shadow map"),
]
# Name and options of each source of the normals that aggregates of two geometry passes have.
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
                          "earlyOuts": SWITCHABLE_EARLY_OUTS, "normals": NORMALS})
        width, height = (int(side) for side in arguments.size.split("x"))
        self.pixels = width * height
        self.image, self.other = self.runs.work / "image.exr", self.runs.work / "other.exr"

    def render(self, view, *options):
        return self.runs.call("render", *view, "--no-validation", "--technique", "agaa", "--samples", 8, *options)

    def ratio(self, view, more, less):
        """The median frame time with `more` as a multiple of that with `less`; the frames alternate."""
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

    def early_outs(self, view):
        data = self.render(view, "--exr", self.image)
        counters, rows = data["counters"], {}
        rows["uncovered pixels"] = {"share": 1 - counters["shadedPixels"] / self.pixels}
        rows["pixels of one aggregate"] = {"share": counters["pixelsByEvents"][0] / max(counters["shadedPixels"], 1)}
        for name, options in SWITCHABLE_EARLY_OUTS:
            other = self.render(view, "--exr", self.other, *options)
            error = self.runs.call("compare", self.image, self.other)
            rows[name] = {"short": summary(data), "long": summary(other), "largest": error["maxAbs"],
                          "mse": error["mseTm"], "ratio": self.ratio(view, options, [])}
        return rows

    def normals(self, view):
        """Errors of two geometry passes against a G-buffer's aggregates, which keep normals with both sets of facts."""
        rows = {}
        for name, options in NORMALS:
            self.render(view, "--exr", self.image, *options)
            self.render(view, "--exr", self.other, "--tier", "generation=gbuffer", "--buffered", *options)
            rows[name] = self.runs.call("compare", self.other, self.image)["mseTm"]
        return rows

    def scene(self, source, camera):
        view = view_options(source, camera, self.arguments.size)
        return {"effects": self.effects(view), "short": self.early_outs(view), "normals": self.normals(view)}


def change(row, key):
    """The change by the effect, as a table's cell."""
    more, less = row["with"][key], row["without"][key]
    if more == less:
        return ""
    difference = more - less
    return f"{difference:+.4g}" if key in ("bytesPerPixel", "tapsPerEvent", "lightsPerEvent") else f"{difference:+d}"


def effects_table(scenes):
    """A row for each effect, over all scenes."""
    lines = []
    for name in next(iter(scenes.values()))["effects"]:
        rows = [scene["effects"][name] for scene in scenes.values()]
        cells = []
        for key in ("passes", "bytesPerPixel", "events", "tapsPerEvent", "lightsPerEvent"):
            values = sorted({change(row, key) or "0" for row in rows}, key=float)
            cells.append("" if values == ["0"] else values[0] if len(values) == 1 else f"{values[0]} to {values[-1]}")
        ratios = sorted(row["ratio"] for row in rows)
        title = {"bare": "all but diffuse sun light"}.get(name, f"`{name}`" if " " not in name else name)
        lines.append([title, *cells, f"{statistics.median(ratios):.2f} ({ratios[0]:.2f} to {ratios[-1]:.2f})"])
    return table(["effect", "passes", "bytes a pixel", "events", "shadow taps an event", "lights an event",
                  "time, median (least to most)"], lines, "lr")


def scene_table(scenes):
    """The time ratio of each effect in each scene."""
    return table(["effect", *scenes],
                 [[name, *(f"{scene['effects'][name]['ratio']:.2f}" for scene in scenes.values())]
                  for name in next(iter(scenes.values()))["effects"]], "lr")


def narrow(lines):
    """The lines with empty cells of one space."""
    return [line.replace("|  |", "| |") for line in lines]


def early_out_table(scenes):
    lines = []
    for name in ("uncovered pixels", "pixels of one aggregate"):
        lines.append([f"{name}, share", *(f"{scene['short'][name]['share']:.2f}" for scene in scenes.values()), ""])
    for name, _ in SWITCHABLE_EARLY_OUTS:
        rows = [scene["short"][name] for scene in scenes.values()]
        largest = f"{max(row['largest'] for row in rows):.3g}"
        for key, title in (("lights", "light evaluations"), ("taps", "shadow taps"), ("events", "events")):
            if any(row["long"][key] != row["short"][key] for row in rows):
                lines.append([f"{name}: {title} with it",
                              *(f"{row['short'][key] / max(row['long'][key], 1):.2f}" for row in rows), largest])
        lines.append([f"{name}: frame without it", *(f"{row['ratio']:.2f}" for row in rows), largest])
    return narrow(table(["short way", *scenes, "largest difference"], lines, "lr"))


def normals_table(scenes):
    return table(["two geometry passes", *scenes],
                 [[name, *(f"{scene['normals'][name]:.2g}" for scene in scenes.values())] for name, _ in NORMALS], "lr")


def times_file(results):
    """The file that `agaa-harness price --times` reads: medians over the scenes."""
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
        *narrow(table(["what holds for a pixel", "used", ""], EARLY_OUTS)), "",
        "Pixels and tiles for which passes do less, because the result is the same or meant to be. A share of counts is that",
        "with the short way as a part of that without. The largest difference is that of a channel of any pixel, linear.", "",
        *early_out_table(scenes), "",
        "## Normals of the prepass", "",
        "Mean square errors of two geometry passes after tone mapping, against aggregates that a G-buffer fills; without specular",
        "light and without local lights. In the second row both have AGAA_FACT_PLANE_NORMALS, with which aggregates of two",
        "geometry passes then take the 16 bits of the prepass.", "",
        *normals_table(scenes), ""])


def main():
    arguments = tool_parser(__doc__, out="", size="320x180", scenes=True, frames=3, turns=3).parse_args()
    measurement = Measurement(arguments)
    results = {"size": arguments.size, "scenes": {}}
    for name, source, camera in find_scenes("scene_effects", arguments.scene):
        results["scenes"][name] = measurement.runs.kept(name, lambda: measurement.scene(source, camera))
        print(name, flush=True)
    device = measurement.runs.call("caps", "--backend", "vk")
    results.update(device=device["device"], driver=device["driver"])
    write_results(arguments.out, "effects", results, page(results))
    write_json(arguments.out / "times.json", times_file(results))
    print(f"Wrote {arguments.out}/effects.json, times.json and effects.md.")


if __name__ == "__main__":
    main()
