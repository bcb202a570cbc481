#!/usr/bin/env python3
"""Shows how well agaaChooseSettings predicts the errors of a scene that is not in its table.

Each scene of a sweep is left out in turn. The errors of its settings are predicted from the other scenes, as
src/core/tuning/error_model.h does it, given the errors of some settings, or the counts of a frame. Then targets are chosen for:
a host measures each choice and chooses anew. OUT/choice_errors.json and OUT/choice_errors.md have the results.
"""
import json
import math
import pathlib
import statistics

from choice_rows import SWEEP, candidate, candidates, scenes
from command_line import tool_parser
from markdown_table import paragraph
from runs import write_results

NOISE = 0.1  # of src/core/tuning/error_model.cpp
TARGETS = (0.25, 0.1, 0.05, 0.02)
COUNTS = ("shading events", "aggregates", "primitives", "widened lobes")
GIVEN = [[], list(COUNTS), ["ssaa-8"], ["agaa-8-2-ids"], ["agaa-32-2-ids"], ["ssaa-8", "agaa-8-2-ids"], ["ssaa-8", "agaa-32-2-ids"],
         ["ssaa-8", "ssaa-32", "agaa-32-2-ids"]]


def logarithms(results):
    """For each setting the logarithms of its errors by those of single, in the order of the scenes."""
    rows = candidates(results)
    errors = [{candidate(row): row["errorReference"]["mseTm"] for row in scene["rows"] if row["shadingCost"] == 1}
              for scene in scenes(results)]
    single = next(row for row in rows if row.technique == "single")
    return {row.name: [math.log(of[row] / of[single]) for of in errors] for row in rows if row != single}


def counts(results):
    """The logarithms of the counts of a frame, per covered pixel, in the order of the scenes."""
    found = {name: [] for name in COUNTS}
    for scene in scenes(results):
        rows = {candidate(row).name: row for row in scene["rows"] if row["shadingCost"] == 1}
        covered = rows["single-1"]["eventsPerPixel"]
        by_id = rows["agaa-8-2-ids"]
        for name, count in zip(COUNTS, (rows["simple_complex-8"]["eventsPerPixel"], by_id["aggregatesPerPixel"],
                                        by_id["primitivesPerPixel"], by_id["widenedLobesPerPixel"]), strict=True):
            found[name].append(math.log(count / covered + 1e-3))
    return found


def times(results):
    """For each setting the times of its frames, in the order of the scenes."""
    rows = candidates(results)
    frames = [{candidate(row): row["frameMs"]["median"] for row in scene["rows"] if row["shadingCost"] == 1}
              for scene in scenes(results)]
    return {row.name: [of[row] for of in frames] for row in rows}


def solve(matrix, right):
    """x of matrix x = right, by elimination; the matrix is symmetric and positive definite."""
    rows = [[*row, value] for row, value in zip(matrix, right, strict=True)]
    for i, pivot in enumerate(rows):
        for row in rows[i + 1:]:
            factor = row[i] / pivot[i]
            row[i:] = [a - factor * b for a, b in zip(row[i:], pivot[i:], strict=True)]
    found = [0.0] * len(right)
    for i in reversed(range(len(right))):
        found[i] = (rows[i][-1] - sum(a * x for a, x in zip(rows[i][i + 1:-1], found[i + 1:], strict=True))) / rows[i][i]
    return found


class Conditional:
    """The normal distribution of each variable, given some of them. variables: their values in the known scenes."""

    def __init__(self, variables, given, noise=NOISE):
        self.variables, self.given, self.noise = variables, given, noise
        self.middle = {name: statistics.fmean(values) for name, values in variables.items()}
        names = list(given)
        self.covariances = [[self.covariance(a, b) + (noise ** 2 if a == b else 0) for b in names] for a in names]

    def covariance(self, a, b):
        parts = zip(self.variables[a], self.variables[b], strict=True)
        return sum((x - self.middle[a]) * (y - self.middle[b]) for x, y in parts) / (len(self.variables[a]) - 1)

    def of(self, name):
        """Mean and standard deviation."""
        if name in self.given:
            return self.given[name], 0.0
        common = [self.covariance(name, other) for other in self.given]
        weights = solve(self.covariances, common)
        mean = self.middle[name] + sum(w * (self.given[other] - self.middle[other]) for w, other in zip(weights, self.given, strict=True))
        variance = self.covariance(name, name) + self.noise ** 2 - sum(w * c for w, c in zip(weights, common, strict=True))
        return mean, math.sqrt(max(variance, 0.0))


def without(values, scene):
    return values[:scene] + values[scene + 1:]


def predictions(variables, names, given, scene, noise=NOISE):
    """Mean and standard deviation of each name in the scene, from all other scenes and what is given in this one."""
    known = {name: without(values, scene) for name, values in variables.items()}
    model = Conditional(known, {name: variables[name][scene] for name in given}, noise)
    return {name: model.of(name) for name in names}


def distances(errors, more, given, noise=NOISE):
    """The factors between predicted and measured errors of all settings that are not given, in all scenes, sorted."""
    variables = {**errors, **more}
    found = []
    for scene in range(len(next(iter(errors.values())))):
        predicted = predictions(variables, errors, given, scene, noise)
        found += [abs(predicted[name][0] - errors[name][scene]) for name in errors if name not in given]
    return [math.exp(distance) for distance in sorted(found)]


def times_elsewhere(milliseconds, scene):
    """Times by those of single: the medians of the other scenes, times that of single here."""
    single = milliseconds["single-1"]
    return {name: single[scene] * statistics.median(a / b for a, b in zip(without(values, scene), without(single, scene), strict=True))
            for name, values in milliseconds.items()}


def choose(predicted, expected, target):
    """The fastest settings whose error is predicted to reach the target; without any, those of the least error."""
    reaching = [name for name, (mean, _) in predicted.items() if mean <= math.log(target)]
    return min(reaching, key=expected.get) if reaching else min(predicted, key=lambda name: predicted[name][0])


def settle(errors, milliseconds, scene, target, frames):
    """What a host chooses that measures its choices in so many frames."""
    measured = []
    expected = times_elsewhere(milliseconds, scene)
    for _ in range(frames + 1):
        choice = choose(predictions(errors, errors, measured, scene), expected, target)
        if choice in measured:
            break
        measured.append(choice)
    return choice


def judge(errors, milliseconds, scene, target, frames):
    choice = settle(errors, milliseconds, scene, target, frames)
    reaching = [milliseconds[name][scene] for name in errors if errors[name][scene] <= math.log(target)]
    return {"scene": scene, "target": target, "frames": frames, "choice": choice, "reached": math.exp(errors[choice][scene]) / target,
            "time": milliseconds[choice][scene] / min(reaching) if reaching else None}


def prediction_table(errors, more):
    rows = []
    for given in GIVEN:
        if set(given) - set(errors) - set(more):
            continue
        found = distances(errors, more, given)
        rows.append([", ".join(given) or "nothing", f"{math.exp(statistics.fmean(map(math.log, found))):.2f}",
                     f"{found[int(0.9 * len(found))]:.2f}", f"{found[-1]:.2f}"])
    return rows


def choice_summary(judged):
    possible = [one for one in judged if one["time"]]
    reached = [one for one in possible if one["reached"] <= 1]
    return [judged[0]["frames"], f"{len(reached)} of {len(possible)}", f"{max(one['reached'] for one in possible):.2f}",
            f"{statistics.fmean(one['time'] for one in reached):.2f}", f"{max(one['time'] for one in reached):.2f}"]


def document(results, rows, judged):
    names = [scene["name"] for scene in scenes(results)]
    last = judged[-1]
    lines = ["# Predicted errors", "", "Generated by `benchmark/choice_errors.py` from a sweep: "
             f"{results['size']}, {results['backends'][0]['device']}, "
             f"build {', '.join(sorted({scene['build'] for scene in scenes(results)}))}. Each scene is predicted from the others.", "",
             "Factors between predicted and measured errors of all settings in all scenes, by what is known of the scene. Counts are of "
             "one frame, per covered pixel.", "",
             *paragraph(["known", "mean", "90 % are below", "largest"], rows, "lr"),
             f"Targets of the error ({', '.join(map(str, TARGETS))} of that of `single`), where settings exist that reach them. A host "
             "measures each choice and chooses anew, in so many frames. Times are by those of the fastest settings that reach the target.", "",
             *paragraph(["frames", "reached", "largest error by its target", "time, mean", "time, largest"], list(map(choice_summary, judged)), "r"),
             f"With {last[0]['frames']} frames:", "",
             *paragraph(["scene", "target", "choice", "error by its target", "time"],
                        [[names[one["scene"]], one["target"], one["choice"], f"{one['reached']:.2f}",
                          f"{one['time']:.2f}" if one["time"] else "no settings reach it"] for one in last], "lrlr")]
    return "\n".join(lines).rstrip() + "\n"


def main():
    parser = tool_parser(__doc__, out="choice-errors", harness=False)
    parser.add_argument("results", nargs="?", default=SWEEP, type=pathlib.Path, help="results.json of a sweep")
    arguments = parser.parse_args()
    results = json.loads(arguments.results.read_text())
    errors, milliseconds = logarithms(results), times(results)
    rows = prediction_table(errors, counts(results))
    judged = [[judge(errors, milliseconds, scene, target, frames) for scene in range(len(scenes(results))) for target in TARGETS]
              for frames in range(5)]
    arguments.out.mkdir(parents=True, exist_ok=True)
    write_results(arguments.out, "choice_errors", {"predictions": rows, "choices": judged}, document(results, rows, judged))


if __name__ == "__main__":
    main()
