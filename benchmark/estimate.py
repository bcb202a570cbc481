#!/usr/bin/env python3
"""Estimates what bounds each pass of a frame on a GPU: memory, arithmetic or rasterisation.

    benchmark/estimate.py               counts events of a scene, then writes docs/results/estimate.{json,md}
    benchmark/estimate.py --table       renders nothing; writes the page from the kept counts

The bytes of a pass come from `agaa-harness plan`, its instructions from docs/results/compiled.json, and the numbers of
its lanes from the counters of a frame.
"""
import json
import pathlib
import typing

from command_line import tool_parser
from compiled import read_kept
from markdown_table import paragraph
from runs import ROOT, ask_json, require_harness, write_json

RESULTS = ROOT / "docs" / "results"
CHIP = "navi21"
SIZE = (960, 540)
SCENE = "foliage"
OUTPUT_BYTES = 8  # RGBA16F, which belongs to the host
LIGHT_LOOP = 270  # instructions of a light in the loop of shade samples, counted in the listing of RADV


class Gpu(typing.NamedTuple):
    lanes_per_second: float    # instructions of one lane
    bytes_per_second: float
    samples_per_second: float  # written to one target

    def __str__(self):
        return (f"{self.lanes_per_second / 1e12:.1f} T instructions of a lane, {self.bytes_per_second / 1e9:.0f} GB and "
                f"{self.samples_per_second / 1e9:.0f} G samples of a target a second")


# 60 compute units of 64 lanes, 96 samples a clock, at 2.1 GHz.
STATED = Gpu(60 * 64 * 2.1e9, 512e9, 96 * 2.1e9)

# name, name in compiled.json, options
CONFIGURATIONS = [
    ("ssaa", "ssaa n=8", ["--technique", "ssaa"]),
    ("simple_complex", "simple_complex n=8", ["--technique", "simple_complex"]),
    ("msaa", "msaa n=8", ["--technique", "msaa"]),
    ("adaptive", "adaptive gbuffer n=8", ["--technique", "adaptive", "--tier", "generation=gbuffer"]),
    ("sbaa S=2", "sbaa per-sample n=8 c=2",
     ["--technique", "sbaa", "--aggregates", "2", "--tier", "generation=per-sample"]),
    ("agaa c=2, two passes", "agaa post-depth-atomics n=8 c=2",
     ["--technique", "agaa", "--aggregates", "2", "--tier", "generation=post-depth-atomics"]),
    ("agaa c=2, G-buffer", "agaa gbuffer n=8 c=2",
     ["--technique", "agaa", "--aggregates", "2", "--tier", "generation=gbuffer"]),
    ("agaa c=2, ids", "agaa ids n=8 c=2", ["--technique", "agaa", "--aggregates", "2", "--tier", "generation=ids"]),
    ("accurate, ids", "accurate ids n=8", ["--preset", "accurate", "--tier", "generation=ids"]),
    ("dcaa n=64 S=4", "dcaa lists n=64 c=4",
     ["--technique", "dcaa", "--samples", "64", "--aggregates", "4", "--tier", "generation=lists"]),
]


def options_of(configuration):
    options = configuration[2]
    return options if "--samples" in options else [*options, "--samples", "8"]


def pass_bytes(plan):
    """The bytes per pixel of each surface by pass, with those of the host's output. Passes may have equal names."""
    pixels = plan["width"] * plan["height"]
    found = []
    for one in plan["passes"]:
        found.append({name: size / pixels for name, size in one["traffic"].items()})
        found[-1].update({name: OUTPUT_BYTES for name in one["writes"] if name == "output"})
    return found


class Work(typing.NamedTuple):
    """Numbers per pixel of a compute pass."""
    lanes: float
    events: float = 0  # shading events; each evaluates one light with the instructions that run once
    lights: float = 0


def work_of(name, plan, counters, pixels):
    events, lights = counters["shadingEvents"] / pixels, counters["lightEvaluations"] / pixels
    samples = plan["samples"] if plan.get("lanes", "").startswith("sample") else 1
    several = counters["severalEvents"] / pixels
    names = {one["name"] for one in plan["passes"]}

    def shading(number):
        return number, lights * number / events

    if name == "shade single primitives":
        single = (counters["shadedPixels"] - counters["severalEvents"]) / pixels
        return Work(1, *shading(single))
    if name == "aggregate and shade" and "shade single primitives" in names:
        # The pass runs for the pixels that the pass before leaves.
        single = (counters["shadedPixels"] - counters["severalEvents"]) / pixels
        return Work(several * samples, *shading(events - single))
    if name == "aggregate and shade":
        return Work(samples, events, lights)
    if name in ("shade first samples", "shade further samples"):
        first = counters["shadedPixels"] / pixels
        number = first if name == "shade first samples" else events - first
        return Work(number, *shading(number))
    if name.startswith("shade"):
        return Work(events, events, lights)
    return Work(samples if name in ("define aggregates", "select surfaces") else 1)


def estimate(one, plan, traffic, figures, counters, pixels, gpu=STATED):
    """Milliseconds per million pixels by kind: memory, arithmetic, rasterisation."""
    found = {"memory": 1e9 * sum(traffic.values()) / gpu.bytes_per_second}
    if one["kind"] == "host-draw":
        targets = max(1, len([name for name in one["writes"] if name != "aggregates"]))
        found["rasterisation"] = 1e9 * plan["samples"] * targets / gpu.samples_per_second
    elif one["kind"] == "compute" and figures:
        work = work_of(one["name"], plan, counters, pixels)
        further = max(0, work.lights - work.events)
        found["arithmetic"] = 1e9 * (work.lanes * figures.instructions + further * LIGHT_LOOP) / gpu.lanes_per_second
    return found


def rows_of(configuration, plan, compiled, counters):
    """One row per pass: names, bytes, milliseconds per million pixels and the kind that bounds it."""
    pixels = plan["width"] * plan["height"]
    traffic = pass_bytes(plan)
    total = sum(sum(part.values()) for part in traffic)
    rows = []
    for one, bytes_of_pass in zip(plan["passes"], traffic):
        times = estimate(one, plan, bytes_of_pass, compiled.get((configuration[1], one["name"])), counters, pixels)
        rows.append({"pass": one["name"], "bytes": sum(bytes_of_pass.values()), "times": times,
                     "share": sum(bytes_of_pass.values()) / total, "bound": max(times, key=times.get),
                     "surfaces": {name: size for name, size in bytes_of_pass.items() if size >= 0.05}})
    return rows


INTRODUCTION = """# What bounds each pass on a GPU

Generated by `benchmark/estimate.py`. No GPU was measured. The stated GPU executes {gpu}.
A frame of `{scene}` at {size} gives the numbers of lanes and lights.

* Bytes are those of `AgaaPrice::trafficBytes`, per pixel, and {output} of the host's output: a pass reads or writes each surface once
  and as a whole. Pixels that a pass skips, caches and compression are not subtracted.
* Times are microseconds per million pixels. Memory: the bytes. Arithmetic: the instructions of `compiled.json` for `{chip}`, each
  once for each lane, branches that lanes skip included, and {loop} for each light of an event after its first. Rasterisation: each sample of each target once, without overdraw; shaders of
  the host are not known. The largest of the three bounds the pass.
* A pass by id that aggregates counts the pixels with several shading events, the fewest that it can have.
* The estimate compares passes with each other. It says where a change can gain, and no time of a frame.
"""


NOTES = """
## Conclusions

* {arithmetic} of {compute} compute passes are bound by arithmetic. "cull lights" reads the depth of all samples: {bytes} % of the bytes
  of the techniques above that cull, and {times} % of their time. The shading pass could cull for its own tile and save the
  bytes. This is not done: it adds barriers to each pass that shades, and no GPU has shown a gain.
* "clear aggregates" writes {clear} % of the bytes of two passes. In pixels with one aggregate the second needs no clear, but
  neighbouring aggregates share the 32 bytes that memory moves at once. The pass that defines could clear, too; the peak of memory
  would rise, because the aggregates lie where the prepass has its normals. On OpenGL a shader clears, except on software
  devices.
* The stencil is 8 of 40 bytes of the depth. It keeps the first of coplanar fragments.
"""


def percent(values):
    low, high = (round(100 * value) for value in (min(values), max(values)))
    return f"{low}" if low == high else f"{low} to {high}"


def conclusions(tables):
    """tables: the rows of each configuration."""
    rows = [row for table in tables for row in table]
    compute = [row for row in rows if "arithmetic" in row["times"]]
    frames = [(table, sum(max(row["times"].values()) for row in table)) for table in tables]
    culling = [(row["share"], max(row["times"].values()) / time) for table, time in frames for row in table
               if row["pass"] == "cull lights"]
    return NOTES.format(arithmetic=sum(row["bound"] == "arithmetic" for row in compute), compute=len(compute),
                        bytes=percent([share for share, _ in culling]), times=percent([time for _, time in culling]),
                        clear=percent([row["share"] for row in rows if row["pass"] == "clear aggregates"]))


def document(kept, plans, compiled):
    lines = [INTRODUCTION.format(gpu=STATED, scene=kept["scene"], size=kept["size"], chip=CHIP, loop=LIGHT_LOOP,
                                 output=OUTPUT_BYTES)]
    tables = []
    for configuration in CONFIGURATIONS:
        name = configuration[0]
        rows = rows_of(configuration, plans[name], compiled, kept["counters"][name])
        tables.append(rows)
        lines += [f"## {name}", ""]
        cells = [[row["pass"], f"{row['bytes']:.1f}", f"{100 * row['share']:.0f}",
                  *(f"{1000 * row['times'][kind]:.0f}" if kind in row["times"] else "–"
                    for kind in ("memory", "arithmetic", "rasterisation")),
                  row["bound"], ", ".join(f"{surface} {size:.1f}" for surface, size in row["surfaces"].items())]
                 for row in rows]
        total = sum(max(row["times"].values()) for row in rows)
        cells.append(["frame", f"{sum(row['bytes'] for row in rows):.1f}", "100", "", "", "", f"{1000 * total:.0f}", ""])
        lines += paragraph(["pass", "bytes", "%", "memory", "arithmetic", "rasterisation", "bound", "surfaces"], cells,
                           "lrrrrrll")
    return "\n".join(lines).rstrip() + "\n" + conclusions(tables)


def plans_of(harness):
    size = "x".join(map(str, SIZE))
    return {one[0]: ask_json(harness, "plan", "--size", size, *options_of(one)) for one in CONFIGURATIONS}


def count(harness):
    """The counters of a frame of each configuration."""
    counters = {}
    for one in CONFIGURATIONS:
        found = ask_json(harness, "render", "--scene", SCENE, "--size", "x".join(map(str, SIZE)), "--frames", "1",
                         "--warmup", "0", *options_of(one))["counters"]
        counters[one[0]] = {key: found[key] for key in ("shadingEvents", "lightEvaluations", "shadedPixels")}
        counters[one[0]]["severalEvents"] = sum(found["pixelsByEvents"][1:])
        print(one[0], counters[one[0]], flush=True)
    return {"scene": SCENE, "size": "x".join(map(str, SIZE)), "counters": counters}


def compiled_figures():
    kept = read_kept((RESULTS / "compiled.json").read_text())
    return {(row["configuration"], row["pass"]): row[CHIP] for row in kept["rows"] if CHIP in row}


def main():
    parser = tool_parser(__doc__, out=RESULTS)
    parser.add_argument("--table", action="store_true", help="render nothing; write the page from the kept counts")
    arguments = parser.parse_args()
    require_harness("estimate", arguments.harness)
    file = pathlib.Path(arguments.out) / "estimate.json"
    if not arguments.table:
        write_json(file, count(arguments.harness))
    page = document(json.loads(file.read_text()), plans_of(arguments.harness), compiled_figures())
    (file.parent / "estimate.md").write_text(page)


if __name__ == "__main__":
    main()
