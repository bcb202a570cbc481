#!/usr/bin/env python3
"""Prints src/core/tuning/choice_table.inc: the settings of agaaChooseSettings with their errors and times.

Errors, and the coefficients of the times, follow from a sweep (benchmark/full_sweep.py). The argument selects another
sweep. Shadow look-ups follow from pixels and events in all rows of a sweep, so that it does not show their time:
benchmark/shadow_taps.py measures it.
"""
import json
import pathlib
import statistics

from choice_rows import GEOMETRY, SWEEP, candidate, candidates, scenes
from command_line import tool_parser
from least_squares import nonnegative
from runs import ROOT

TAPS = ROOT / "docs/results/lavapipe/shadow_taps.json"

TIERS = {"": "AUTO", "lists": "FRAGMENT_LISTS"}  # of names that differ from the enumerator's
LEAST_SHADING = 0.01  # of a frame, or its timestamps do not tell passes apart


class Frame:
    """The work of a row in a scene: counts, and times in nanoseconds, per pixel."""

    def __init__(self, row, lights, pixels):
        self.events = row["eventsPerPixel"]
        self.lights = lights * row["shadingCost"]  # builds that cull lights count the evaluations
        if "lightEvaluationsPerPixel" in row:
            self.lights = row["lightEvaluationsPerPixel"] / self.events
        self.taps = row["shadowTapsPerPixel"]
        times = {True: 0.0, False: 0.0}
        for stage, ms in row["stageMs"].items():
            times[stage in GEOMETRY] += ms * 1e6 / pixels
        self.geometry, self.shading = times[True], times[False]


def tells_passes(frame):
    return frame.shading > LEAST_SHADING * (frame.geometry + frame.shading)


class Costs:
    """The frames of each row and scene, in the order of their shading cost."""

    def __init__(self, results, rows):
        width, height = map(int, results["size"].split("x"))
        self.frames = {}
        self.scenes = [scene["name"] for scene in scenes(results)]
        for scene in scenes(results):
            for row in sorted(scene["rows"], key=lambda row: row["shadingCost"]):
                if candidate(row) in rows:
                    frame = Frame(row, scene["lights"], width * height)
                    self.frames.setdefault((candidate(row), scene["name"]), []).append(frame)
        self.single = next(row for row in rows if row.technique == "single")
        self.reference = next(row for row in rows if row.technique == "simple_complex" and row.samples == 8)

    def of(self, row, scene):
        return self.frames[row, scene][0]

    def coverage(self, scene):
        """The share of the samples with geometry: single shades one event for each."""
        return self.of(self.single, scene).events

    def single_geometry(self, scene):
        return self.of(self.single, scene).geometry

    def complexity(self, scene):
        """The share of the samples beyond a pixel's first that simple_complex shades at n = 8."""
        frame = self.of(self.reference, scene)
        share = (frame.events / self.coverage(scene) - 1) / (self.reference.samples - 1)
        return min(max(share, 0.0), 1.0)


def line(points):
    """Coefficients a and b of y = a + b x, neither of them negative; both are 0 if all y are 0."""
    points = [(x, y) for x, y in points if y > 0]
    if not points:
        return 0.0, 0.0
    found = nonnegative([{"a": 1.0, "b": x} for x, _ in points], [y for _, y in points])
    return found["a"], found.get("b", 0.0)


class Model:
    """tap: the time of a shadow look-up by that of a light evaluation."""

    def __init__(self, costs, rows, tap):
        self.costs = costs
        self.rows = rows
        self.tap = tap
        self.shading = self.fit_shading()
        self.split_untold_frames()
        self.geometry = {row: self.fit_geometry(row) for row in rows}
        self.events = {row: line([(costs.complexity(s), self.per_covered(row, s, "events")) for s in costs.scenes]) for row in rows}
        self.taps = {row: line([(costs.complexity(s), self.per_covered(row, s, "taps")) for s in costs.scenes]) for row in rows}
        self.lights = {row: self.fit_lights(row) for row in rows}

    def per_covered(self, row, scene, member):
        return getattr(self.costs.of(row, scene), member) / self.costs.coverage(scene)

    def fit_geometry(self, row):
        found = nonnegative([{"single": self.costs.single_geometry(s), "fixed": 1.0} for s in self.costs.scenes],
                            [self.costs.of(row, s).geometry for s in self.costs.scenes])
        return found["single"], found["fixed"]

    def fit_shading(self):
        """Fits one cost of a light for all rows, and costs of an event and of a pixel for each row, beside the known cost of a
        shadow tap. That cost hardly changes the cost of a light, which frames with heavier lighting show."""
        rows, targets, taps = [], [], []
        for row in self.rows:
            for scene in self.costs.scenes:
                for frame in filter(tells_passes, self.costs.frames[row, scene]):
                    rows.append({(row.name, "pixel"): 1.0, (row.name, "event"): frame.events, "light": frame.events * frame.lights})
                    targets.append(frame.shading)
                    taps.append(frame.taps)
        tap = self.tap * nonnegative(rows, targets)["light"]
        return {**nonnegative(rows, targets, [tap * count for count in taps]), "tap": tap}

    def split_untold_frames(self):
        """Gives shading the time of its lights and shadows where timestamps do not tell it from the passes before: lavapipe has
        one time for compute passes in a row."""
        for frames in self.costs.frames.values():
            for frame in frames:
                if not tells_passes(frame):
                    whole = frame.geometry + frame.shading
                    lights = self.shading["light"] * frame.events * frame.lights + self.shading["tap"] * frame.taps
                    frame.shading = min(lights, 0.5 * whole)
                    frame.geometry = whole - frame.shading

    def fit_lights(self, row):
        """Lights of an event as a multiple of single's: techniques that the host shades do not cull lights."""
        return statistics.median(self.costs.of(row, s).lights / self.costs.of(self.costs.single, s).lights for s in self.costs.scenes)

    def shading_time(self, row, events, lights, taps):
        found = self.shading
        own = found.get((row.name, "pixel"), 0.0) + found.get((row.name, "event"), 0.0) * events
        return (own + found["light"] * events * lights
                + found["tap"] * taps)

    def fit_error(self, row):
        """Relative errors of the whole times, predicted from the counts of each frame."""
        errors = []
        for scene in self.costs.scenes:
            frame = self.costs.of(row, scene)
            ratio, fixed = self.geometry[row]
            time = ratio * self.costs.single_geometry(scene) + fixed + self.shading_time(row, frame.events, frame.lights, frame.taps)
            errors.append(abs(time / (frame.geometry + frame.shading) - 1))
        return errors

    def middle(self, number):
        return statistics.median(number(scene) for scene in self.costs.scenes)

    def transfer_error(self, row):
        """Relative errors of the whole times, predicted from the frame of single alone."""
        errors = []
        complexity = self.middle(self.costs.complexity)
        middle = self.middle(self.costs.single_geometry)
        for scene in self.costs.scenes:
            seen, frame = self.costs.of(self.costs.single, scene), self.costs.of(row, scene)
            own = self.geometry[self.costs.single]
            scale = seen.geometry / (own[0] * middle + own[1])
            geometry = (self.geometry[row][0] * middle + self.geometry[row][1]) * scale
            scale = seen.shading / self.shading_time(self.costs.single, seen.events, seen.lights, seen.taps)
            at = [a + b * complexity for a, b in (self.events[row], self.taps[row])]
            shading = self.shading_time(row, at[0] * seen.events, seen.lights * self.lights[row], at[1] * seen.events) * scale
            errors.append(abs((geometry + shading) / (frame.geometry + frame.shading) - 1))
        return errors


def percent(errors):
    return f"{100 * statistics.median(errors):.0f} % ({100 * max(errors):.0f} %)"


def number(value):
    text = f"{value:.4g}" if value > 1e-9 else "0"
    return (text if "." in text or "e" in text else text + ".0") + "f"


def numbers(values):
    return ", ".join(number(value) for value in values)


def error_table(results, rows):
    """Mean squared errors after tone mapping, by row and scene."""
    return {(candidate(row), scene["name"]): row["errorReference"]["mseTm"]
            for scene in scenes(results) for row in scene["rows"] if row["shadingCost"] == 1 and candidate(row) in rows}


def table(results, tap):
    rows = candidates(results)
    names = [scene["name"] for scene in scenes(results)]
    builds = ", ".join(sorted({scene["build"] for scene in scenes(results)}))
    errors = error_table(results, rows)
    costs = Costs(results, rows)
    model = Model(costs, rows, tap)
    single = [errors[costs.single, name] for name in names]
    text = [f"""// Generated by benchmark/choice_table.py: the settings that agaaChooseSettings chooses among.
// Build {builds}, {results["size"]}, {results["backends"][0]["device"]}.
// Scenes: {", ".join(names[:5])},
// {", ".join(names[5:])}.
//
// Includers define
//   AGAA_CHOICE_SCENES     the numbers of scenes, and their errors of "single"
//   AGAA_CHOICE_COMMON     nanoseconds of a light evaluation and of a shadow tap, by benchmark/shadow_taps.py; medians
//                          of the scenes: nanoseconds of the geometry passes of "single" per pixel, coverage,
//                          complexity, lights of an event.
//                          Complexity: the share of the samples beyond a pixel's first that simple_complex shades at
//                          n = 8
//   AGAA_CHOICE_ROW        technique, n, c or S, preset, tier;
//                          geometry passes by those of "single", nanoseconds more per pixel;
//                          nanoseconds of shading per pixel and per event, lights of an event by those of "single";
//                          events per covered pixel: at complexity 0, and more at 1; shadow taps likewise, for one
//                          shadow;
//                          errors by those of "single", in the order of the scenes
// and each is undefined at the end. Comments have the relative error of the times, median and worst of the scenes: with
// the counts of each frame, and predicted from the frame of "single" alone.
AGAA_CHOICE_SCENES({len(names)}, {numbers(single[:5])},
                   {numbers(single[5:])})
AGAA_CHOICE_COMMON({numbers([model.shading["light"], model.shading["tap"], model.middle(costs.single_geometry),
                             model.middle(costs.coverage), model.middle(costs.complexity),
                             model.middle(lambda scene: costs.of(costs.single, scene).lights)])})"""]
    for row in rows:
        found = [*model.geometry[row], model.shading.get((row.name, "pixel"), 0.0), model.shading.get((row.name, "event"), 0.0), model.lights[row],
                 *model.events[row], *model.taps[row]]
        shares = [errors[row, name] / own for name, own in zip(names, single, strict=True)]
        tier = TIERS.get(row.tier, row.tier.upper().replace("-", "_"))
        text.append(f"// {percent(model.fit_error(row))}, {percent(model.transfer_error(row))}")
        text.append(f'AGAA_CHOICE_ROW("{row.technique}", {row.samples}, {row.aggregates}, "{row.preset}", {tier},\n'
                    f"                {numbers(found)},\n                {numbers(shares)})")
    text += [f"#undef AGAA_CHOICE_{name}" for name in ("SCENES", "COMMON", "ROW")]
    return "\n".join(text) + "\n"


def main():
    parser = tool_parser(__doc__, harness=False)
    parser.add_argument("results", nargs="?", default=SWEEP, type=pathlib.Path, help="results.json of a sweep")
    parser.add_argument("--taps", default=TAPS, type=pathlib.Path, help="shadow_taps.json of benchmark/shadow_taps.py")
    arguments = parser.parse_args()
    tap = json.loads(arguments.taps.read_text())["ratio"]
    print(table(json.loads(arguments.results.read_text()), tap), end="")


if __name__ == "__main__":
    main()
