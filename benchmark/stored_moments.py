#!/usr/bin/env python3
"""Measures elliptic lobes of aggregates in memory: error, bytes and time, beside those of passes that shade at once.

Errors (mseTm, docs/sweep.md) are against `ssaa` with the same samples, so that they are those of aggregation alone.
OUT/stored_moments.json and OUT/stored_moments.md have the results. An interrupted run continues with those in OUT/work.
"""
import statistics

from command_line import tool_parser
from markdown_table import table
from runs import Runs, find_scenes, view_options, write_results

AGAA = ["--technique", "agaa", "--aggregates", 2]
TWO_PASSES = [*AGAA, "--tier", "generation=per-sample"]
GBUFFER = [*AGAA, "--tier", "generation=gbuffer"]
ROWS = {"two passes, round": [*TWO_PASSES, "--ndf", "toksvig"],
        "two passes, LEAN": [*TWO_PASSES, "--ndf", "lean"],
        "two passes, SGGX": [*TWO_PASSES, "--ndf", "sggx"],
        "buffered, round": [*GBUFFER, "--buffered", "--ndf", "toksvig"],
        "buffered, LEAN": [*GBUFFER, "--buffered", "--ndf", "lean"],
        "at once, round": [*GBUFFER, "--ndf", "toksvig"],
        "at once, LEAN": [*GBUFFER, "--ndf", "lean"],
        "two passes, balanced": ["--preset", "balanced", "--tier", "generation=per-sample"],
        "at once, balanced": ["--preset", "balanced", "--tier", "generation=gbuffer"]}
BALANCED = "two passes, balanced", "at once, balanced"  # without times
TIERS = {"two passes": ["two passes, LEAN", "two passes, SGGX"], "buffered": ["buffered, LEAN"], "at once": ["at once, LEAN"]}


def measure(runs, scene, arguments):
    name, source, camera = scene
    options = [*view_options(source, camera, arguments.size), "--samples", arguments.samples, "--backend", "vk", "--no-validation",
               "--no-counters"]
    reference, image = runs.work / f"{name}.exr", runs.work / "row.exr"

    def render(technique, path):
        return runs.call("render", *options, *technique, "--frames", 1, "--exr", path)

    def error(row):
        done = render(ROWS[row], image)
        return {"device": done["device"], "bytesPerPixel": done["bytesPerPixel"],
                "mseTm": runs.call("compare", reference, image)["mseTm"]}

    def time(row):
        return runs.call("render", *options, *ROWS[row], "--warmup", 1, "--frames", 4, "--no-timestamps")["frameMs"]["median"]

    runs.kept(f"{name}-reference", lambda: bool(render(["--technique", "ssaa"], reference)))
    found = {row: runs.kept(f"{name}-{index}", lambda: error(row)) for index, row in enumerate(ROWS)}
    timed = [row for row in ROWS if row not in BALANCED]
    times = {row: [] for row in timed}
    for turn in range(arguments.turns):
        for index, row in enumerate(timed):
            times[row].append(runs.kept(f"{name}-{index}-turn-{turn}", lambda: time(row)))
    for row in timed:
        found[row]["frameMs"] = statistics.median(times[row])
    return {"scene": name, "device": found["at once, round"]["device"], "rows": found}


def ratios(scenes, row, base, key):
    return [scene["rows"][row][key] / scene["rows"][base][key] for scene in scenes]


def document(scenes, arguments):
    lines = ["# Elliptic lobes of aggregates in memory", "",
             f"Written by `benchmark/stored_moments.py` on {scenes[0]['device']}: {arguments.size}, n = {arguments.samples}, c = 2, "
             f"{arguments.turns} {'turn' if arguments.turns == 1 else 'turns'} of times. Errors are mean squares after tone mapping "
             "against `ssaa` of the same n. Two geometry passes accumulate by the tier per-sample; buffered aggregates come from a G-buffer, as those that are shaded at once.", "",
             "Error by that of the same aggregates with round lobes (`AGAA_NDF_TOKSVIG`):", ""]
    columns = [row for rows in TIERS.values() for row in rows]
    bases = {row: f"{tier}, round" for tier, rows in TIERS.items() for row in rows}
    cells = [[scene["scene"], *(f"{scene['rows'][row]['mseTm'] / scene['rows'][bases[row]]['mseTm']:.3f}" for row in columns)]
             for scene in scenes]
    lines += table(["scene", *columns], cells)
    lines += ["", "Bytes per pixel of the view and the frame's time, by those of round lobes; medians over the scenes:", ""]
    cells = [[row, f"{statistics.median(s['rows'][row]['bytesPerPixel'] for s in scenes):.1f}",
              f"{statistics.median(ratios(scenes, row, bases[row], 'bytesPerPixel')):.3f}",
              f"{statistics.median(ratios(scenes, row, bases[row], 'frameMs')):.3f}"] for row in columns]
    lines += table(["settings", "bytes per pixel", "bytes", "time"], cells)
    lines += ["", "The preset `balanced`. Two geometry passes leave out its lit shadows and its weight of gloss, which need materials "
              "before samples are grouped. Errors by that of c = 2 with round lobes and two passes:", ""]
    cells = [[scene["scene"], *(f"{scene['rows'][row]['mseTm'] / scene['rows']['two passes, round']['mseTm']:.3f}" for row in BALANCED),
              *(f"{scene['rows'][row]['bytesPerPixel']:.1f}" for row in BALANCED)] for scene in scenes]
    lines += table(["scene", *BALANCED, *(f"bytes per pixel, {row}" for row in BALANCED)], cells)
    return "\n".join(lines) + "\n"


def main():
    parser = tool_parser(__doc__, out="stored-moments", size="320x180", scenes=True, turns=3)
    parser.add_argument("--samples", default=8, type=int, help="n")
    arguments = parser.parse_args()
    runs = Runs("stored_moments", arguments.harness, arguments.out, {"size": arguments.size, "samples": arguments.samples})
    scenes = []
    for scene in find_scenes("stored_moments", arguments.scene):
        scenes.append(measure(runs, scene, arguments))
        print(scene[0], "done", flush=True)
    data = {"size": arguments.size, "samples": arguments.samples, "turns": arguments.turns, "scenes": scenes}
    write_results(arguments.out, "stored_moments", data, document(scenes, arguments))
    print(f"Wrote {arguments.out / 'stored_moments.md'}")


if __name__ == "__main__":
    main()
