#!/usr/bin/env python3
"""Measures how AGAA sections 3.5.2 and 3.5.3 filter the shading of aggregates: error, shadow taps and, without --turns 0, time of each rule.

Errors (mseTm, docs/sweep.md) are against `ssaa` with the same samples, so that they are those of aggregation alone. A second
picture of each scene has lights of short range near its surfaces. OUT/aggregate_shading.json and OUT/aggregate_shading.md have
the results. An interrupted run continues with those in OUT/work.
"""
import statistics

from command_line import tool_parser
from markdown_table import table
from runs import Runs, find_scenes, view_options, write_results

AGAA = ["--technique", "agaa", "--tier", "generation=gbuffer"]
SUN = {"no diffuse filter": ["--no-diffuse-filter"],
       "von Mises-Fisher diffuse": ["--diffuse-filter", "mises-fisher"],
       "SGGX diffuse": ["--diffuse-filter", "sggx"],
       "one shadow tap": ["--no-shadow-filter"],
       "taps along depth": ["--shadow-along-depth"],
       "taps along the covariance": ["--shadow-covariance"],
       "filtered maps": ["--filtered-shadows"]}
OTHER_MAPS = "filtered maps"  # its errors are against `ssaa` with the same maps
NEAR = {"light directions": ["--light-directions"]}
DEFAULT = "default"


class Picture:
    """A scene with its own lights, or with near ones."""

    def __init__(self, runs, scene, arguments, lights):
        name, source, camera = scene
        self.runs, self.name = runs, f"{name}-{lights}"
        self.rows = {DEFAULT: [], **(NEAR if lights else SUN)}
        self.options = [*view_options(source, camera, arguments.size), "--samples", arguments.samples, "--backend", "vk",
                        "--no-validation", *(["--lights", lights] if lights else [])]
        self.agaa = [*AGAA, "--aggregates", arguments.aggregates]

    def render(self, *more):
        return self.runs.call("render", *self.options, *more)

    def reference(self, row):
        """Renders the reference of a row once. Returns its file."""
        more = self.rows[row] if row == OTHER_MAPS else []
        file = self.runs.work / f"{self.name}{'-other-maps' if more else ''}.exr"
        self.runs.kept(f"{file.stem}-reference", lambda: bool(self.render("--technique", "ssaa", *more, "--frames", 1, "--exr", file)))
        return file

    def error(self, row):
        image = self.runs.work / "row.exr"
        done = self.render(*self.agaa, *self.rows[row], "--frames", 1, "--exr", image)
        return {"device": done["device"], "shadowTaps": done["counters"]["shadowTaps"],
                "shadingEvents": done["counters"]["shadingEvents"],
                "mseTm": self.runs.call("compare", self.reference(row), image)["mseTm"]}

    def time(self, row):
        return self.render(*self.agaa, *self.rows[row], "--no-counters", "--no-timestamps", "--warmup", 1, "--frames",
                           3)["frameMs"]["median"]

    def measure(self, turns):
        found = {row: self.runs.kept(f"{self.name}-{i}", lambda: self.error(row)) for i, row in enumerate(self.rows)}
        times = {row: [] for row in self.rows}
        for turn in range(turns):  # interleaved: the load of a machine changes
            for i, row in enumerate(self.rows):
                times[row].append(self.runs.kept(f"{self.name}-{i}-turn-{turn}", lambda: self.time(row)))
        for row in self.rows if turns else ():
            found[row]["frameMs"] = statistics.median(times[row])
        return found


def ratios(scenes, rows, row, key):
    return [scene[rows][row][key] / scene[rows][DEFAULT][key] if scene[rows][DEFAULT][key] else 1.0 for scene in scenes]


def error_table(scenes, rows, names):
    cells = [[scene["scene"], f"{scene[rows][DEFAULT]['mseTm']:.2e}",
              *(f"{scene[rows][row]['mseTm'] / max(scene[rows][DEFAULT]['mseTm'], 1e-12):.3f}" for row in names)]
             for scene in scenes]
    cells.append(["median", "", *(f"{statistics.median(ratios(scenes, rows, row, 'mseTm')):.3f}" for row in names)])
    return table(["scene", "default: error", *names], cells)


def cost_table(scenes, rows, names):
    figures = {"shadow taps": "shadowTaps", "time": "frameMs"}
    measured = {name: key for name, key in figures.items() if key in scenes[0][rows][DEFAULT]}
    cells = [[row, *(f"{statistics.median(ratios(scenes, rows, row, key)):.2f}" for key in measured.values())] for row in names]
    return table(["rule", *measured], cells)


def document(scenes, arguments):
    device = scenes[0]["sun"][DEFAULT]["device"]
    turns = f", times of {arguments.turns} turns" if arguments.turns else ""
    lines = ["# Rules for the shading of aggregates", "",
             f"Written by `benchmark/aggregate_shading.py` on {device}: `agaa` from a G-buffer, {arguments.size}, "
             f"n = {arguments.samples}, c = {arguments.aggregates}{turns}. Errors are mean squares after "
             "tone mapping against `ssaa` of the same n; rules are by the default, which filters the diffuse term in closed form and "
             "looks shadows up at samples. Filtered maps are exponential variance maps of the sample engine, which its shadow function "
             "looks up once for an event (`AgaaShadowFunction::footprints`); their errors are against `ssaa` with the same maps.", "", *error_table(scenes, "sun", SUN), "", "Medians over the scenes, by the default:",
             "", *cost_table(scenes, "sun", SUN), "",
             f"With {arguments.lights} lights of short range, `AGAA_MEASURE_LIGHT_DIRECTIONS`:", "",
             *error_table(scenes, "near", NEAR), "", *cost_table(scenes, "near", NEAR)]
    return "\n".join(lines) + "\n"


def main():
    parser = tool_parser(__doc__, out="aggregate-shading", size="320x180", scenes=True, turns=3)
    parser.add_argument("--samples", default=8, type=int, help="n")
    parser.add_argument("--aggregates", default=2, type=int, help="c")
    parser.add_argument("--lights", default=64, type=int, help="near lights of the second picture")
    arguments = parser.parse_args()
    kept = {"size": arguments.size, "samples": arguments.samples, "aggregates": arguments.aggregates}
    runs = Runs("aggregate_shading", arguments.harness, arguments.out, kept)
    scenes = []
    for scene in find_scenes("aggregate_shading", arguments.scene):
        found = {key: Picture(runs, scene, arguments, lights).measure(arguments.turns)
                 for key, lights in (("sun", 0), ("near", arguments.lights))}
        scenes.append({"scene": scene[0], **found})
        print(scene[0], "done", flush=True)
    data = {**kept, "lights": arguments.lights, "turns": arguments.turns, "scenes": scenes}
    write_results(arguments.out, "aggregate_shading", data, document(scenes, arguments))
    print(f"Wrote {arguments.out / 'aggregate_shading.md'}")


if __name__ == "__main__":
    main()
