#!/usr/bin/env python3
"""Measures the settings of agaaChooseSettings in a scene of your own: errors against a reference, and times.

`agaa-harness choose --measured` reads OUT/measured.json, whose rows a host passes as AgaaGoal::measured. An interrupted
run continues with the results in OUT/work.
"""
import json
import sys

from choice_rows import GEOMETRY, SWEEP, candidates
from command_line import tool_parser
from runs import Runs, view_options, write_json



def table_rows():
    return candidates(json.loads(SWEEP.read_text()))


def wanted_rows(names):
    """All rows, or the named ones and "single", whose error is the unit of all errors."""
    rows = table_rows()
    unknown = set(names or ()) - {row.name for row in rows}
    if unknown:
        sys.exit(f"calibrate: no row is called {', '.join(sorted(unknown))}; there are {', '.join(row.name for row in rows)}.")
    return [row for row in rows if not names or row.name in names or row.technique == "single"]


def options(row):
    """The sample engine's options for a row of the table."""
    tier = ["--tier", f"generation={row.tier}"] if row.tier else []
    if row.preset:
        return ["--preset", row.preset, "--samples", row.samples, *tier]
    return ["--technique", row.technique, "--samples", row.samples, *(["--aggregates", row.aggregates] if row.aggregates else []),
            *tier]


def times(passes):
    """Milliseconds of the geometry passes and of the shading passes: medians of the frames."""
    found = {"geometryMs": 0.0, "shadingMs": 0.0}
    for entry in passes:
        found["geometryMs" if entry["stage"] in GEOMETRY else "shadingMs"] += entry["ms"]["median"]
    return found


def milliseconds(found):
    return found["geometryMs"] + found["shadingMs"]


def middle(times_of_turns):
    """The times of the turn with the median total."""
    return sorted(times_of_turns, key=milliseconds)[(len(times_of_turns) - 1) // 2]


class Frame:
    """One camera in one scene, with its reference."""

    def __init__(self, runs, name, view, spp):
        self.runs, self.name, self.view = runs, name, view
        self.reference = runs.work / f"{name}-reference.exr"
        runs.kept(f"{name}-reference", lambda: runs.call("reference", *view, "--spp", spp, "--exr", self.reference))

    def measure(self, row):
        """Error and times of a row's frame, or the refusal of its settings."""
        def make():
            settings = options(row)
            refusal = self.runs.refusal("plan", *self.view, "--backend", "vk", *settings)
            if refusal:
                return {"refusal": refusal}
            image = self.runs.work / f"{self.name}-{row.name}.exr"
            found = self.times(row, "--exr", image)
            return {"error": self.runs.call("compare", self.reference, image)["mseTm"], **found}
        return self.runs.kept(f"{self.name}-{row.name}", make)

    def times(self, row, *more):
        return times(self.runs.call("render", *self.view, "--warmup", 1, "--frames", 5, "--no-counters", "--no-validation", *more,
                                    *options(row))["passes"])

    def measure_all(self, rows, turns):
        """Measurements of the rows that the device can run. Times are medians of turns over all rows, because the load of a
        machine changes."""
        found = {}
        for row in rows:
            measured = self.measure(row)
            if "refusal" in measured:
                print(f"Left out: {row.name}: {measured['refusal']}", flush=True)
            else:
                found[row] = measured
        taken = {row: [found[row]] for row in found}
        for turn in range(1, turns):
            for row in found:
                taken[row].append(self.runs.kept(f"{self.name}-{row.name}-turn-{turn}", lambda: self.times(row)))
        return {row: {**measured, **middle(taken[row])} for row, measured in found.items()}


def single_error(measured):
    error = next((found["error"] for row, found in measured.items() if row.technique == "single"), 0)
    if error <= 0:
        sys.exit("calibrate: single has no error here, or does not run, so that no error can be told by it.")
    return error


def measured_settings(measured, size):
    """The rows in the form that `choose --measured` reads."""
    width, height = map(int, size.split("x"))
    single = single_error(measured)
    return [{"technique": row.technique, "preset": row.preset or None, "samples": row.samples, "aggregates": row.aggregates,
             "tier": row.tier or None, "pixels": width * height, "errorShare": found["error"] / single, **found}
            for row, found in measured.items()]


def write_measured(path, measured, size, has_times=True):
    settings = measured_settings(measured, size)
    if not has_times:
        settings = [{key: value for key, value in one.items() if key != "pixels" and not key.endswith("Ms")} for one in settings]
    write_json(path, {"measured": settings})


def main():
    parser = tool_parser(__doc__, out="calibration", size="320x180", turns=3)
    parser.add_argument("--scene", required=True, help="a scene of the sample engine")
    parser.add_argument("--camera", default="", help="ex,ey,ez,tx,ty,tz,fovDegrees; the scene's own by default")
    parser.add_argument("--spp", default=256, type=int, help="samples per pixel of the reference")
    parser.add_argument("--row", action="append", help="only this row, such as agaa-8-fast-gbuffer, and single; repeatable")
    parser.add_argument("--without-times", action="store_true", help="write errors alone, for `choose --predict-others`")
    arguments = parser.parse_args()
    settings = {name: getattr(arguments, name) for name in ("scene", "camera", "size", "spp")}
    runs = Runs("calibrate", arguments.harness, arguments.out, settings)
    view = view_options(arguments.scene, arguments.camera, arguments.size)
    path = arguments.out / "measured.json"
    measured = Frame(runs, "frame", view, arguments.spp).measure_all(wanted_rows(arguments.row), arguments.turns)
    write_measured(path, measured, arguments.size, not arguments.without_times)
    print(path)


if __name__ == "__main__":
    main()
