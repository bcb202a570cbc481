#!/usr/bin/env python3
"""Measures options that follow the papers, each beside the default: error, bytes per pixel, shading events and, without --turns 0, time.

Moments of depth that fragments store (AGAA 3.5.3), planes in place of samples (AGAA 4.1) and the light of samples as a metric
(Hollaender et al. 2013, section 6). Errors (mseTm, docs/sweep.md) are against `ssaa` with the same samples. OUT/paper_options.json
and OUT/paper_options.md have the results. An interrupted run continues with those in OUT/work.
"""
import statistics

from command_line import tool_parser
from markdown_table import table
from runs import Runs, find_scenes, view_options, write_results

TWO_PASSES = ["--technique", "agaa", "--tier", "generation=post-depth-atomics", "--aggregates", 2, "--samples", 8]
PLANES = ["--technique", "agaa", "--tier", "generation=post-depth-atomics", "--aggregates", 4, "--samples", 32, "--lanes", "pixel"]
ADAPTIVE = ["--technique", "adaptive", "--samples", 16]
# Each group has its settings and its rows, the default first.
GROUPS = {
    "stored depth": (TWO_PASSES, {"taps at samples": [], "taps along depth": ["--shadow-along-depth"],
                                  "taps by stored moments": ["--stored-depth"]}),
    "planes": (PLANES, {"samples": [], "planes": ["--depth-planes"]}),
    "light": (ADAPTIVE, {"default": [], "with light": ["--compare-light"],
                         "without gloss": ["--adaptive-gloss-weight", 0],
                         "light in place of gloss": ["--compare-light", "--adaptive-gloss-weight", 0]}),
    "near lights": ([*ADAPTIVE, "--lights", 64], {"default": [], "with light": ["--compare-light"]}),
}
FIGURES = {"mseTm": "error", "bytesPerPixel": "bytes", "shadingEvents": "events", "shadowTaps": "shadow taps",
           "definitionMs": "definition's time", "frameMs": "time"}


class Scene:
    def __init__(self, runs, scene, arguments):
        self.name, source, camera = scene
        self.runs = runs
        self.options = [*view_options(source, camera, arguments.size), "--backend", "vk", "--no-validation"]

    def render(self, base, more, *measuring):
        return self.runs.call("render", *self.options, *base, *more, *measuring)

    def reference(self, group, base):
        """Renders `ssaa` with the samples and lights of a group once. Returns its file."""
        file = self.runs.work / f"{self.name}-{group}.exr"
        own = ["--technique", "ssaa", *base[base.index("--samples"):]]
        own = own[:4] + (["--lights", 64] if "--lights" in base else [])
        if group in ("light", "near lights"):  # on the grid that `adaptive` has
            own += ["--tier", "visibility=ordered-grid"]
        self.runs.kept(f"{self.name}-{group}-reference", lambda: bool(self.render(own, ["--frames", 1, "--exr", file])))
        return file

    def figures(self, group, base, row, more):
        image = self.runs.work / f"{self.name}-{group}-{row}.exr"
        done = self.render(base, more, "--frames", 1, "--exr", image)
        return {"device": done["device"], "bytesPerPixel": done["bytesPerPixel"],
                "shadowTaps": done["counters"]["shadowTaps"], "shadingEvents": done["counters"]["shadingEvents"],
                "mseTm": self.runs.call("compare", self.reference(group, base), image)["mseTm"]}

    def times(self, base, more):
        done = self.render(base, more, "--no-counters", "--warmup", 1, "--frames", 3)
        definition = [entry["ms"]["median"] for entry in done["passes"] if entry["stage"] == "definition"]
        return [done["frameMs"]["median"], sum(definition)]

    def measure(self, turns):
        found = {}
        for group, (base, rows) in GROUPS.items():
            found[group] = {row: self.runs.kept(f"{self.name}-{group}-{row}", lambda: self.figures(group, base, row, more))
                            for row, more in rows.items()}
            taken = {row: [] for row in rows}
            for turn in range(turns):  # interleaved: the load of a machine changes
                for row, more in rows.items():
                    taken[row].append(self.runs.kept(f"{self.name}-{group}-{row}-turn-{turn}", lambda: self.times(base, more)))
            for row in rows if turns else ():
                found[group][row]["frameMs"] = statistics.median(time[0] for time in taken[row])
                if group == "planes":
                    found[group][row]["definitionMs"] = statistics.median(time[1] for time in taken[row])
        return found


def ratio(figures, default, key):
    return figures[key] / default[key] if default[key] else 1.0


def group_tables(scenes, group):
    rows = list(GROUPS[group][1])
    default, others = rows[0], rows[1:]
    cells = [[scene["scene"], f"{scene[group][default]['mseTm']:.2e}",
              *(f"{ratio(scene[group][row], scene[group][default], 'mseTm'):.3f}" for row in others)] for scene in scenes]
    lines = table(["scene", f"{default}: error", *others], cells)
    known = {key: name for key, name in FIGURES.items() if key in scenes[0][group][default]}
    medians = [[row, *(f"{statistics.median(ratio(scene[group][row], scene[group][default], key) for scene in scenes):.3f}"
                       for key in known)] for row in others]
    return [*lines, "", f"Medians over the scenes, by \"{default}\":", "", *table(["", *known.values()], medians), ""]


def document(scenes, arguments):
    device = scenes[0]["stored depth"]["taps at samples"]["device"]
    turns = f", times of {arguments.turns} {'turn' if arguments.turns == 1 else 'turns'}" if arguments.turns else ""
    lines = ["# Options that follow the papers", "",
             f"Written by `benchmark/paper_options.py` on {device}, {arguments.size}{turns}. Errors are mean squares after tone mapping "
             "against `ssaa` of the same n; rows are by the first of their table. Events are shading events; estimates of light "
             "are not counted among them.", "",
             "## Moments of depth that fragments store (AGAA 3.5.3)", "", "`agaa` by two passes, n = 8, c = 2:", "",
             *group_tables(scenes, "stored depth"),
             "## Planes in place of samples (AGAA 4.1)", "",
             "`agaa` by two passes, n = 32, c = 4, one lane per pixel:", "", *group_tables(scenes, "planes"),
             "## The light of samples (Hollaender et al. 2013, section 6)", "", "`adaptive`, n = 16:", "",
             *group_tables(scenes, "light"), "With 64 lights of short range near surfaces:", "", *group_tables(scenes, "near lights")]
    return "\n".join(lines).rstrip("\n") + "\n"


def main():
    parser = tool_parser(__doc__, out="paper-options", size="320x180", scenes=True, turns=3)
    arguments = parser.parse_args()
    runs = Runs("paper_options", arguments.harness, arguments.out, {"size": arguments.size})
    scenes = []
    for scene in find_scenes("paper_options", arguments.scene):
        scenes.append({"scene": scene[0], **Scene(runs, scene, arguments).measure(arguments.turns)})
        print(scene[0], "done", flush=True)
    write_results(arguments.out, "paper_options", {"size": arguments.size, "turns": arguments.turns, "scenes": scenes},
                  document(scenes, arguments))
    print(f"Wrote {arguments.out / 'paper_options.md'}")


if __name__ == "__main__":
    main()
