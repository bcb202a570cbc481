#!/usr/bin/env python3
"""Measures claims of the papers, and prints docs/papers.md: the paper's number beside ours, with a verdict for each claim.

    benchmark/papers.py measure [--out FOLDER]     OUT/papers.json
    benchmark/papers.py page RESULTS.json          the page, on standard output

Errors (mseTm, docs/sweep.md) are against `ssaa` with the same samples and the same lobe. Bytes are those of plans for the paper's
view of 1280x720 with the layout "paper16", of 16 bytes per sample or aggregate. An interrupted run continues with the results in
OUT/work.
"""
import argparse
import json
import pathlib
import statistics
import sys

from markdown_table import table
from runs import HARNESS, Runs, find_scenes, view_options, write_json

N = 8
TWO_PASSES = ["--tier", "generation=per-sample"]  # of the tiers of two geometry passes, the one that runs everywhere
PHONG, GGX = ["--brdf", "blinn-phong"], ["--brdf", "ggx"]


def agaa(c, *more):
    return ["--technique", "agaa", "--aggregates", c, *TWO_PASSES, *more]


def sbaa(s):
    return ["--technique", "sbaa", "--aggregates", s, *TWO_PASSES]


ROWS = {"phong": {"simple_complex": ["--technique", "simple_complex"],
                  **{f"agaa {c}": agaa(c) for c in (1, 2, 3, 4)},
                  **{f"sbaa {s}": sbaa(s) for s in (1, 2, 3, 4, 6)},
                  "agaa 2 lean": agaa(2, "--ndf", "lean")},
        "ggx": {"agaa 2": agaa(2), "agaa 2 sggx": agaa(2, "--ndf", "sggx"),
                "toksvig diffuse": agaa(2, "--diffuse-filter", "mises-fisher"),
                "sggx diffuse": agaa(2, "--diffuse-filter", "sggx")}}
LOBES = {"phong": PHONG, "ggx": GGX}
PLANS = {**{f"agaa {c} n={n}": ["--technique", "agaa", "--aggregates", c, "--samples", n] for n in (8, 16) for c in (1, 2, 3, 4)},
         **{f"sbaa {s} n=8": ["--technique", "sbaa", "--aggregates", s, "--samples", 8] for s in (2, 4, 6)},
         **{f"ssaa n={n}": ["--technique", "ssaa", "--samples", n] for n in (8, 16)}}
# Resources of the stages that the paper counts.
COUNTED = ("depth", "normals", "aggregates", "metadata", "gbuffer")


def measure_scene(runs, scene, size):
    name, source, camera = scene
    found = {}
    for lobe, rows in ROWS.items():
        options = [*view_options(source, camera, size), "--samples", N, *LOBES[lobe], "--backend", "vk", "--no-validation",
                   "--frames", 1]
        reference, image = runs.work / f"{name}-{lobe}.exr", runs.work / "row.exr"

        def error(row):
            done = runs.call("render", *options, *rows[row], "--exr", image)
            return {"mseTm": runs.call("compare", reference, image)["mseTm"], "events": done["counters"]["shadingEvents"],
                    "device": done["device"]}

        runs.kept(f"{name}-{lobe}-reference",
                  lambda: bool(runs.call("render", *options, "--technique", "ssaa", "--exr", reference)))
        found[lobe] = {row: runs.kept(f"{name}-{lobe}-{row.replace(' ', '-')}", lambda: error(row)) for row in rows}
    return {"scene": name, **found}


def plan_bytes(runs, row):
    """Bytes per pixel of the resources that the paper counts."""
    plan = runs.call("plan", *PLANS[row], "--layout", "paper16", "--size", "1280x720")
    bytes_ = sum(r["bytes"] for r in plan["resources"] if r["name"].startswith(COUNTED))
    return bytes_ / (1280 * 720)


def measure(arguments):
    runs = Runs("papers", arguments.harness, arguments.out, {"size": arguments.size})
    data = {"size": arguments.size, "bytesPerPixel": {row: plan_bytes(runs, row) for row in PLANS}, "scenes": []}
    for scene in find_scenes("papers", arguments.scene):
        data["scenes"].append(measure_scene(runs, scene, arguments.size))
        print(scene[0], "done", flush=True)
    write_json(arguments.out / "papers.json", data)
    print(f"Wrote {arguments.out / 'papers.json'}")


def ratios(data, lobe, row, base, key="mseTm"):
    return [s[lobe][row][key] / s[lobe][base][key] for s in data["scenes"]]


def below(values):
    return sum(value < 1 for value in values)


def verdict_of_share(count, total):
    return "holds" if count == total else "holds in part" if 2 * count > total else "does not hold here"


def errors_claim(lobe, row, base, what):
    def found(data):
        values = ratios(data, lobe, row, base)
        count = below(values)
        return (f"{what}: median {statistics.median(values):.2f}, below 1 in {count} of {len(values)} scenes",
                verdict_of_share(count, len(values)))
    return found


def events_claim(base, at_most):
    def found(data):
        share = (sum(s["phong"]["agaa 2"]["events"] for s in data["scenes"]) /
                 sum(s["phong"][base]["events"] for s in data["scenes"]))
        return f"{100 * share:.0f} % of the events of {base.replace('_', '/')} over all scenes", \
            "holds" if share <= at_most else "does not hold here"
    return found


def saved_claim(row, base, least, most):
    """A part of memory that is saved, in percent, beside the paper's."""
    def found(data):
        bytes_ = data["bytesPerPixel"]
        saved = 100 * (1 - bytes_[row] / bytes_[base])
        how = f"{saved:.0f} % less" if saved >= 0 else f"{-saved:.0f} % more"
        return (f"{how} ({bytes_[row]:.0f} for {bytes_[base]:.0f} bytes per pixel)",
                "holds" if saved >= least and saved <= most + 5 else "holds in part" if saved > 0 else "does not hold here")
    return found


def megabytes_claim(row, paper):
    def found(data):
        ours = data["bytesPerPixel"][row] * 1280 * 720 / 2**20
        return f"{ours:.0f} MB", "holds" if ours <= 1.05 * paper else "holds in part" if ours <= 1.25 * paper else \
            "does not hold here"
    return found


def metal_claim(data):
    scene = next((s for s in data["scenes"] if s["scene"] == "metal"), None)
    if not scene:
        return "metal was not measured", "cannot be measured here"
    ratio = scene["phong"]["agaa 2 lean"]["mseTm"] / scene["phong"]["sbaa 4"]["mseTm"]
    return f"error of agaa c = 2 with LEAN by that of sbaa S = 4 in metal: {ratio:.2f}", \
        "holds" if ratio < 1 else "does not hold here"


def not_measured(reason):
    return lambda data: (reason, "cannot be measured here")


TIMES = "times of software rasterisers say nothing of a GPU; docs/choosing.md has them, and docs/results those of an H100"
# place, claim of the paper, what we found and the verdict
AGAA = [
    ("figure 9, 5.1.1", "c = 2 exceeds the quality of SBAA with S = 4", errors_claim("phong", "agaa 2", "sbaa 4", "error by that of sbaa")),
    *(("5.1.1, figure 16", f"with {k} shading event{'s' if k > 1 else ''} per pixel AGAA has the higher quality",
       errors_claim("phong", f"agaa {k}", f"sbaa {k}", "error by that of sbaa")) for k in (1, 2, 3, 4)),
    ("5.1.2", "highlights of thin rods: better than SBAA with four shading events", metal_claim),
    ("figure 10, 5.1.3", "GGX lobes: SGGX is better than Toksvig", errors_claim("ggx", "agaa 2 sggx", "agaa 2", "error by that of Toksvig")),
    ("figure 11, 5.1.4", "diffuse light: SGGX is better than the isotropic filter",
     errors_claim("ggx", "sggx diffuse", "toksvig diffuse", "error by that of the isotropic filter")),
    ("figure 13, 5.2", "c = 2 has less than 25 % of the shading events of Simple/Complex", events_claim("simple_complex", 0.25)),
    ("figure 13, 5.2", "c = 2 has 45 % of the shading events of SBAA with S = 6", events_claim("sbaa 6", 0.45)),
    ("figure 14, 5.4", "c = 2, n = 8: a little under 40 % less memory than a G-buffer", saved_claim("agaa 2 n=8", "ssaa n=8", 35, 40)),
    ("figure 14, 5.4", "c = 2, n = 16: almost 50 % less", saved_claim("agaa 2 n=16", "ssaa n=16", 45, 50)),
    ("figure 14, 5.4", "c = 2: 20 % less than SBAA with S = 2", saved_claim("agaa 2 n=8", "sbaa 2 n=8", 18, 22)),
    ("figure 14, 5.4", "c = 2: 37 % less than SBAA with S = 4", saved_claim("agaa 2 n=8", "sbaa 4 n=8", 35, 39)),
    *(("slides", f"{name}: {paper} MB at 1280x720, n = 8", megabytes_claim(row, paper)) for name, row, paper in (
        ("c = 1", "agaa 1 n=8", 41), ("c = 2", "agaa 2 n=8", 71), ("SBAA, S = 2", "sbaa 2 n=8", 88),
        ("SBAA, S = 6", "sbaa 6 n=8", 137), ("G-buffer", "ssaa n=8", 112))),
    ("table 1, 5.3", "shading 2 to 3.5 times as fast as Simple/Complex at n = 8, up to 9.2 times at n = 32", not_measured(TIMES)),
    ("5.3", "about 10 % higher speed-ups of shading with GGX", not_measured(TIMES)),
]


def page(data):
    device = data["scenes"][0]["phong"]["agaa 2"]["device"]
    lines = ["# Claims of the papers", "",
             f"Written by `benchmark/papers.py` from `docs/results/lavapipe/papers.json`, which it measured on {device}: "
             f"the scenes {', '.join(s['scene'] for s in data['scenes'])}, {data['size']}, n = {N}, two geometry passes. Errors are mean squares after tone mapping "
             "against `ssaa` with the same samples, with Blinn-Phong and Toksvig as in the paper where the claim names nothing else. "
             "Bytes are those of plans with the layout \"paper16\"; the depth has a stencil, with which the first of equal depths "
             "shows. Our `sbaa` is written to win: samples of a dropped surface join the nearest one that is kept.", "",
             "## Aggregate G-Buffer Anti-Aliasing (Crassin et al., TVCG 2016)", ""]
    lines += table(["place", "claim", "ours", "verdict"], [[place, claim, *found(data)] for place, claim, found in AGAA])
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(dest="command", required=True)
    measuring = commands.add_parser("measure", help="renders the scenes and writes OUT/papers.json")
    measuring.add_argument("--harness", default=HARNESS, type=pathlib.Path, help="the program agaa-harness")
    measuring.add_argument("--out", default=pathlib.Path("papers"), type=pathlib.Path, help="folder of the results")
    measuring.add_argument("--size", default="320x180", help="WxH")
    measuring.add_argument("--scene", action="append", help="only this scene; repeatable")
    printing = commands.add_parser("page", help="prints the page")
    printing.add_argument("results", type=pathlib.Path)
    arguments = parser.parse_args()
    if arguments.command == "measure":
        measure(arguments)
        return
    try:
        text = page(json.loads(arguments.results.read_text()))
    except (OSError, KeyError, ValueError, IndexError, ZeroDivisionError) as problem:
        sys.exit(f"papers: {arguments.results}: no results of `papers.py measure`: {problem!r}")
    print(text, end="")


if __name__ == "__main__":
    main()
