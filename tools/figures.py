#!/usr/bin/env python3
"""Measures accuracy, shading events, memory and times over scenes and writes them as JSON and Markdown.

Two references: `ssaa` at the same n (isolates aggregation) and accumulated jittered frames (isolates
visibility), the latter with its own split-half error. Resumable: what OUT/work holds is not made again.
"""
import argparse
import json
import pathlib
import statistics
import time

from runs import HARNESS, Runs, find_scenes, view_options

RUNS = [("single", 1, 1), ("ssaa", 4, 1), ("ssaa", 8, 1), ("ssaa", 32, 1), ("agaa", 8, 1),
        ("agaa", 8, 2), ("agaa", 8, 3), ("agaa", 8, 4), ("agaa", 32, 2), ("agaa", 32, 4)]


class Bench:
    def __init__(self, arguments):
        self.size = arguments.size
        self.frames = arguments.frames
        self.spp = arguments.spp
        self.times = arguments.times
        self.runs = Runs("figures", arguments.harness, arguments.out,
                         {"size": self.size, "frames": self.frames, "spp": self.spp})
        self.work = self.runs.work

    def told(self, name, arguments):
        begin = time.monotonic()
        out = self.runs.call(*arguments)
        print(f"{name}: {time.monotonic() - begin:.0f} s", flush=True)
        return out

    def call(self, name, arguments):
        return self.runs.kept(name, lambda: self.told(name, arguments))

    def scene(self, name, source, camera):
        view = view_options(source, camera, self.size)
        images, rows = {}, {}
        for technique, n, c in RUNS:
            stem = f"{name}-{technique}-{n}-{c}"
            images[technique, n, c] = self.work / f"{stem}.exr"
            rows[technique, n, c] = self.call(
                stem, ["render", *view, "--technique", technique, "--samples", str(n),
                       "--aggregates", str(c), "--frames", str(self.frames), "--warmup", "1",
                       "--exr", str(images[technique, n, c]),
                       "--png", str(self.work / f"{stem}.png")])
        reference = self.work / f"{name}-reference.exr"
        split = self.call(f"{name}-reference",
                          ["reference", *view, "--spp", str(self.spp), "--no-validation",
                           "--exr", str(reference)])
        out = {"scene": name, "splitHalfMseTm": split["splitHalfMseTm"], "runs": []}
        for key in RUNS:
            technique, n, c = key
            row = rows[key]
            stem = f"{name}-{technique}-{n}-{c}"
            same = images["ssaa", n if technique == "agaa" else 8, 1]
            run = {"technique": technique, "samples": n, "aggregates": c}
            for field in ("shadingEventsPerPixel", "shadingEventsPerCoveredPixel",
                          "maxEventsPerPixel", "bytesPerPixel", "bytesPerAggregate",
                          "predictedBytes", "memoryBytes", "driverBytes", "peakBytes", "counters",
                          "tiers"):
                run[field] = row.get(field)
            run["apiMessages"] = len(row["apiMessages"])
            run["againstSsaa"] = self.call(
                f"{stem}-vs-ssaa", ["compare", str(same), str(images[key]), "--difference",
                                    str(self.work / f"{stem}-difference.png")])
            run["againstReference"] = self.call(
                f"{stem}-vs-reference", ["compare", str(reference), str(images[key])])
            out["runs"].append(run)
            out["device"], out["driver"] = row["device"], row["driver"]
        if misses(out):
            out["causes"] = self.causes(name, source, camera)
        if self.times: # all turns at once: ratios are of one run
            out["times"] = self.runs.kept(f"{name}-times", lambda: self.interleaved(name, view))
        return out

    def causes(self, name, source, camera):
        """The bounds against many samples again, with one effect left out of all images."""
        rows = []
        for effect in ("specular", "shadows"):
            view = view_options(source, camera, self.size) + ["--without", effect]
            stem = f"{name}-without-{effect}"
            reference = self.work / f"{stem}-reference.exr"
            self.call(f"{stem}-reference", ["reference", *view, "--spp", str(self.spp),
                                            "--no-validation", "--exr", str(reference)])
            row = {"without": effect}
            for technique, n, c in [("ssaa", 4, 1), ("agaa", 8, 2), ("ssaa", 8, 1),
                                    ("agaa", 32, 2), ("agaa", 32, 4)]:
                key = f"{technique}-{n}-{c}"
                image = self.work / f"{stem}-{key}.exr"
                self.call(f"{stem}-{key}",
                          ["render", *view, "--technique", technique, "--samples", str(n),
                           "--aggregates", str(c), "--exr", str(image), "--no-validation"])
                row[key] = self.call(f"{stem}-{key}-vs-reference",
                                     ["compare", str(reference), str(image)])["mseTm"]
            rows.append(row)
        return rows

    def interleaved(self, name, view):
        """Frame and pass times of ssaa and agaa at n = 8, in the order A B B A, without counters."""
        frames = {"ssaa": [], "agaa": []}
        passes = {"ssaa": {}, "agaa": {}}
        for turn, technique in enumerate(["ssaa", "agaa", "agaa", "ssaa"]):
            row = self.told(f"{name}-time-{turn}",
                            ["render", *view, "--technique", technique, "--samples", "8",
                             "--aggregates", "2", "--frames", str(self.frames), "--warmup", "2",
                             "--no-counters", "--no-validation"])
            frames[technique].append(row["frameMs"])
            for item in row["passes"]:
                if item["ms"]:
                    passes[technique].setdefault(item["name"], []).append(item["ms"]["median"])
        return {t: {"median": statistics.mean(f["median"] for f in frames[t]),
                    "p95": max(f["p95"] for f in frames[t]),
                    "passes": {n: statistics.mean(v) for n, v in passes[t].items()}}
                for t in frames}


def misses(scene):
    """Whether agaa errs more against many samples than ssaa of fewer samples does, by more than those err."""
    gap = 10 * scene["splitHalfMseTm"]
    error = {k: find(scene, *k)["againstReference"]["mseTm"]
             for k in [("agaa", 8, 2), ("ssaa", 4, 1), ("agaa", 32, 2), ("ssaa", 8, 1)]}
    return error["agaa", 8, 2] > error["ssaa", 4, 1] + gap or error["agaa", 32, 2] > error["ssaa", 8, 1] + gap


def find(scene, technique, n, c):
    return next(r for r in scene["runs"]
                if (r["technique"], r["samples"], r["aggregates"]) == (technique, n, c))


def cause_table(data):
    scenes = [s for s in data["scenes"] if "causes" in s]
    if not scenes:
        return []
    lines = ["\n## Scenes where aggregates err more than fewer samples\n",
             "The same errors with one effect left out of every image, the reference included: where "
             "the order is right again, that effect is the cause.\n",
             "| scene | without | ssaa n=4 | agaa n=8 c=2 | ssaa n=8 | agaa n=32 c=2 | "
             "agaa n=32 c=4 |", "|---|---|---|---|---|---|---|"]
    keys = ["ssaa-4-1", "agaa-8-2", "ssaa-8-1", "agaa-32-2", "agaa-32-4"]
    for s in scenes:
        full = {k: find(s, k.split("-")[0], *map(int, k.split("-")[1:]))["againstReference"]["mseTm"]
                for k in keys}
        for row in [{"without": "nothing", **full}] + s["causes"]:
            lines.append(f"| {s['scene']} | {row['without']} | " +
                         " | ".join(f"{row[k]:.2e}" for k in keys) + " |")
    return lines


def time_table(data):
    lines = ["\n## Time\n",
             f"Milliseconds. In the order A B B A, {data['frames']} frames each: the mean of the two medians, and in "
             "brackets the larger 95th percentile. Ratios within this table mean something; on a software rasteriser "
             "absolute times do not.\n",
             "| scene | ssaa n=8 | agaa n=8 c=2 | ssaa / agaa | agaa passes | ssaa passes |",
             "|---|---|---|---|---|---|"]

    def passes(run):
        return ", ".join(f"{name} {ms:.0f}" for name, ms in run["passes"].items() if ms >= 0.5)
    for s in data["scenes"]:
        a, b = s["times"]["ssaa"], s["times"]["agaa"]
        lines.append(f"| {s['scene']} | {a['median']:.0f} ({a['p95']:.0f}) | "
                     f"{b['median']:.0f} ({b['p95']:.0f}) | {a['median'] / b['median']:.2f} | "
                     f"{passes(b)} | {passes(a)} |")
    return lines


def markdown(data):
    lines = [f"# Figures\n\nGenerated by `tools/figures.py` on {data['device']} ({data['driver']}), "
             f"{data['size']}, {data['frames']} frames a run, with the scenes' own lights or else 17.\n",
             "## Error against `ssaa` at the same n\n",
             "`mseTm` as a share of `single`'s (against `ssaa` n=8).\n",
             "| scene | single mseTm | n=8 c=1 | c=2 | c=3 | c=4 | events/px c=2 | per covered px | "
             "most in a pixel |", "|---|---|---|---|---|---|---|---|---|"]
    for s in data["scenes"]:
        base = find(s, "single", 1, 1)["againstSsaa"]["mseTm"]
        share = [find(s, "agaa", 8, c)["againstSsaa"]["mseTm"] / base for c in (1, 2, 3, 4)]
        two = find(s, "agaa", 8, 2)
        lines.append(f"| {s['scene']} | {base:.2e} | " + " | ".join(f"{v:.4f}" for v in share) +
                     f" | {two['shadingEventsPerPixel']:.2f} | "
                     f"{two['shadingEventsPerCoveredPixel']:.2f} | {two['maxEventsPerPixel']} |")
    lines += ["\n## Error against " + str(data["spp"]) + " samples per pixel (`mseTm`)\n",
              "| scene | split-half | single | ssaa n=4 | agaa n=8 c=2 | ssaa n=8 | agaa n=32 c=2 | "
              "ssaa n=32 |", "|---|---|---|---|---|---|---|---|"]
    for s in data["scenes"]:
        keys = [("single", 1, 1), ("ssaa", 4, 1), ("agaa", 8, 2), ("ssaa", 8, 1), ("agaa", 32, 2),
                ("ssaa", 32, 1)]
        lines.append(f"| {s['scene']} | {s['splitHalfMseTm']:.1e} | " + " | ".join(
            f"{find(s, *k)['againstReference']['mseTm']:.2e}" for k in keys) + " |")
    lines += cause_table(data)
    if "times" in data["scenes"][0]:
        lines += time_table(data)
    lines += [f"\n## Memory of the tier that runs (bytes per pixel, {data['scenes'][0]['scene']})\n",
              "| run | payload | per aggregate | driver | peak |", "|---|---|---|---|---|"]
    width, height = map(int, data["size"].split("x"))
    for key in RUNS:
        r = find(data["scenes"][0], *key)
        px = width * height
        lines.append(f"| {key[0]} n={key[1]} c={key[2]} | {r['bytesPerPixel']:.1f} | "
                     f"{r['bytesPerAggregate']:.0f} | {r['driverBytes'] / px:.1f} | "
                     f"{r['peakBytes'] / px:.1f} |")
    bad = sum(r["apiMessages"] for s in data["scenes"] for r in s["runs"])
    lines.append(f"\nMessages of validation and synchronisation validation in all runs: {bad}.")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--harness", default=HARNESS, type=pathlib.Path)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--frames", default=5, type=int)
    parser.add_argument("--spp", default=512, type=int)
    parser.add_argument("--times", action="store_true", help="also run times: an idle machine")
    parser.add_argument("scenes", nargs="*", help="names; default: all")
    arguments = parser.parse_args()
    bench = Bench(arguments)
    data = {"size": arguments.size, "spp": arguments.spp, "frames": arguments.frames,
            "scenes": [bench.scene(*scene) for scene in find_scenes("figures", arguments.scenes)]}
    data["device"], data["driver"] = data["scenes"][0]["device"], data["scenes"][0]["driver"]
    (arguments.out / "figures.json").write_text(json.dumps(data, indent=1))
    (arguments.out / "figures.md").write_text(markdown(data))
    print(arguments.out / "figures.md")


if __name__ == "__main__":
    main()
