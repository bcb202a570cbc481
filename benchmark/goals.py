#!/usr/bin/env python3
"""Compares the choices of agaaChooseSettings with their measured errors, and with the fastest settings.

For each scene and each target of the error, `agaa-harness choose --observe` chooses by frames of `single`. All settings of
the table are rendered, and their errors measured against the reference. With --measured, choices are also made by the
measurements of another frame, whose camera is moved to the side. OUT/goals.json has all numbers; tables in Markdown are
printed.
"""
import math

from calibrate import Frame, milliseconds, options, single_error, table_rows, write_measured
from command_line import tool_parser
from markdown_table import table
from runs import Runs, find_scenes, view_options, write_json

STEP = 0.1  # how far the camera moves, as a share of the distance to its target


def moved(camera):
    """The camera ex,ey,ez,tx,ty,tz,fov after a step to the side; it still aims at its target."""
    x, y, z, tx, ty, tz, fov = camera
    forward = (tx - x, ty - y, tz - z)
    distance = math.hypot(*forward)
    level = math.hypot(forward[0], forward[2])
    side = (-forward[2] / level, forward[0] / level)
    return [x + STEP * distance * side[0], y, z + STEP * distance * side[1], tx, ty, tz, fov]


def fastest(measured, rows):
    """Name and time of the fastest row, or None and None."""
    if not rows:
        return None, None
    best = min(rows, key=lambda row: milliseconds(measured[row]))
    return best.name, milliseconds(measured[best])


def judge(measured, target, choice):
    """The error and time of a choice, and the fastest settings that reach the target in the same frame."""
    by_options = {tuple(sorted(map(str, options(row)))): row for row in measured}
    row = by_options[tuple(sorted(choice["options"]))]
    single = single_error(measured)
    reaching = [other for other in measured if measured[other]["error"] <= target * single]
    preset, preset_ms = fastest(measured, [other for other in reaching if other.preset])
    best, best_ms = fastest(measured, reaching)
    return {"target": target, "choice": row.name, "predictedError": choice["errorShare"], "error": measured[row]["error"] / single,
            "predictedMs": choice["milliseconds"], "ms": milliseconds(measured[row]), "fastestPreset": preset,
            "fastestPresetMs": preset_ms, "fastest": best, "fastestMs": best_ms, "missedLimits": choice["missedLimits"]}


class Scene:
    def __init__(self, runs, scene, cameras, arguments):
        name, source, camera = scene
        camera = list(map(float, camera.split(","))) if camera else cameras[name]
        self.runs, self.name, self.arguments = runs, name, arguments
        self.judged = self.frame(name, source, camera)
        self.other = self.frame(f"{name}-other", source, moved(camera)) if arguments.measured else None

    def frame(self, name, source, camera):
        view = view_options(source, ",".join(map(repr, camera)), self.arguments.size)
        return Frame(self.runs, name, view, self.arguments.spp)

    def sources(self):
        """The sources of the choices, with the options of `choose` for them."""
        found = {"table": ["--observe", "--no-validation", "--scene-share", self.arguments.scene_share]}
        if self.other:
            path = self.runs.work / f"{self.name}-measured-settings.json"
            write_measured(path, self.other.measure_all(table_rows(), self.arguments.turns), self.arguments.size)
            found["measured"] = ["--measured", path, "--backend", "vk"]
        return found

    def results(self, targets):
        measured = self.judged.measure_all(table_rows(), self.arguments.turns)
        for source, options_of_source in self.sources().items():
            for target in targets:
                choice = self.runs.kept(f"{self.name}-{source}-choice-{target}", lambda: self.runs.call(
                    "choose", *self.judged.view, "--max-error", target, *options_of_source))
                yield {"scene": self.name, "by": source, **judge(measured, target, choice)}


def cells(name, ms):
    return [name, f"{ms:.0f}"] if name else ["none", ""]


def summary(results):
    """Sentences about the distance of the choices from their targets and from the best settings."""
    possible = [r for r in results if r["fastest"]]
    reached = [r for r in possible if r["error"] <= r["target"]]
    ratios = [("Errors are at most {:.2f} times the target where some settings reach it.", [r["error"] / r["target"] for r in possible]),
              ("Choices take at most {:.2f} times the time of the fastest preset that reaches the target.",
               [r["ms"] / r["fastestPresetMs"] for r in possible if r["fastestPreset"]]),
              ("Choices that reach the target take at most {:.2f} times the time of the fastest settings that do.",
               [r["ms"] / r["fastestMs"] for r in reached])]
    return " ".join([f"{len(reached)} of {len(results)} targets are reached; no settings reach {len(results) - len(possible)}.",
                     *(text.format(max(values)) for text, values in ratios if values)])


def result_table(results):
    rows = [[r["scene"], r["target"], r["choice"], f"{r['predictedError']:.3f}", f"{r['error']:.3f}",
             f"{r['error'] / r['target']:.2f}", f"{r['predictedMs']:.0f}", f"{r['ms']:.0f}",
             *cells(r["fastestPreset"], r["fastestPresetMs"]), *cells(r["fastest"], r["fastestMs"])] for r in results]
    return "\n".join(table(["scene", "target", "choice", "error predicted", "error reached", "reached / target",
                            "ms predicted", "ms", "fastest preset", "its ms", "fastest", "its ms"], rows, "lrlrrrrrlrlr"))


def main():
    parser = tool_parser(__doc__, out="goals", size="320x180", scenes=True, turns=3)
    parser.add_argument("--spp", default=256, type=int, help="samples per pixel of the reference")
    parser.add_argument("--target", action="append", type=float, help="error as a share of single's; repeatable")
    parser.add_argument("--scene-share", default=0.8, type=float, help="AgaaGoal::sceneShare")
    parser.add_argument("--measured", action="store_true", help="also choose by measurements of another frame")
    arguments = parser.parse_args()
    targets = arguments.target or [0.25, 0.1, 0.05, 0.02]
    runs = Runs("goals", arguments.harness, arguments.out,
                {"size": arguments.size, "spp": arguments.spp, "share": arguments.scene_share, "step": STEP})
    cameras = {scene["name"]: scene["camera"] for scene in runs.call("scenes")["scenes"]}
    results = []
    for scene in find_scenes("goals", arguments.scene):
        results += Scene(runs, scene, cameras, arguments).results(targets)
        write_json(arguments.out / "goals.json", results)
    for source in dict.fromkeys(r["by"] for r in results):
        rows = [r for r in results if r["by"] == source]
        title = "the table" if source == "table" else "measurements of another frame"
        print(f"\nBy {title}:\n\n{result_table(rows)}\n\n{summary(rows)}")


if __name__ == "__main__":
    main()
