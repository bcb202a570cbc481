#!/usr/bin/env python3
"""Measures the time of a shadow look-up relative to that of a light evaluation, for benchmark/choice_table.py.

In the rows of a sweep, look-ups follow from pixels and shading events, so that a fit cannot separate them. Here, one view is
rendered with and without shadows, and with lighting evaluated several times (`--shading-cost`): all else is equal. Times are
those of the processor, which software rasterisers run on: other programs change them less than they change the time of a
frame. OUT/shadow_taps.json has the frames and, as `ratio`, the median of the views' ratios.
"""
import os
import statistics

from command_line import tool_parser
from runs import Runs, find_scenes, view_options, write_json

SCENES = ["bamboo", "metal", "city"]
ROWS = {"ssaa-8": ["--technique", "ssaa", "--samples", 8],
        "agaa-8-2-gbuffer": ["--technique", "agaa", "--samples", 8, "--aggregates", 2, "--tier", "generation=gbuffer"]}
COST = 4  # evaluations of lighting in the heavier frames
FRAMES = {"without": ["--without", "shadows"], "with": [], "heavier": ["--shading-cost", COST]}


def ratio(view):
    """The time of a look-up by that of a light evaluation. view: counts of the frame with shadows, and all times."""
    times = view["processorMs"]
    tap = (times["with"] - times["without"]) / view["shadowTaps"]
    light = (times["heavier"] - times["with"]) / ((COST - 1) * view["lightEvaluations"])
    return tap / light


def processor_ms():
    """The processor time of all finished processes that this one started."""
    times = os.times()
    return 1000 * (times.children_user + times.children_system)


class View:
    def __init__(self, runs, scene, row, size):
        name, source, camera = scene
        self.runs, self.scene, self.row, self.name = runs, name, row, f"{name}-{row}"
        self.options = [*view_options(source, camera, size), *ROWS[row], "--backend", "vk", "--no-validation"]

    def render(self, *more):
        return self.runs.call("render", *self.options, *more)

    def run_ms(self, frame, count):
        before = processor_ms()
        self.render(*FRAMES[frame], "--no-counters", "--warmup", 0, "--frames", count)
        return processor_ms() - before

    def time(self, frame, count):
        """The processor time per frame after the first, before which the scene is loaded and its shadow maps are drawn."""
        return (self.run_ms(frame, 1 + count) - self.run_ms(frame, 1)) / count

    def measure(self, turns, count):
        counters = self.runs.kept(f"{self.name}-counts", lambda: self.render("--frames", 1)["counters"])
        times = {frame: [] for frame in FRAMES}
        for turn in range(turns):  # the load of a machine changes
            for frame in FRAMES:
                times[frame].append(self.runs.kept(f"{self.name}-{frame}-{turn}", lambda: self.time(frame, count)))
        found = {"scene": self.scene, "row": self.row, "shadowTaps": counters["shadowTaps"],
                 "lightEvaluations": counters["lightEvaluations"],
                 "processorMs": {frame: round(statistics.median(times[frame]), 1) for frame in FRAMES}}
        return {**found, "ratio": round(ratio(found), 2)}


def main():
    parser = tool_parser(__doc__, out="shadow-taps", size="480x270", scenes=True, turns=3, frames=10)
    arguments = parser.parse_args()
    runs = Runs("shadow_taps", arguments.harness, arguments.out, {"size": arguments.size, "frames": arguments.frames})
    views = []
    for scene in find_scenes("shadow_taps", arguments.scene or SCENES):
        for row in ROWS:
            views.append(View(runs, scene, row, arguments.size).measure(arguments.turns, arguments.frames))
            print(f"{scene[0]}, {row}: {views[-1]['ratio']:.2f}", flush=True)
    found = statistics.median(view["ratio"] for view in views)
    write_json(arguments.out / "shadow_taps.json", {"size": arguments.size, "ratio": round(found, 2), "views": views})
    print(f"A shadow look-up takes {found:.2f} times as long as a light evaluation.")


if __name__ == "__main__":
    main()
