#!/usr/bin/env python3
"""Compares OpenGL with Vulkan over scenes and techniques: images, and with --times frames and passes.

Writes OUT/backends.json and OUT/backends.md. Resumable: what OUT/work holds is not made again.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import time

from figures import BUILTIN, SHARED, shared_scenes

CONFIGURATIONS = ([("single", 1, 1)] + [("ssaa", n, 1) for n in (4, 8, 16, 32)] +
                  [("agaa", n, c) for n in (4, 8, 16, 32) for c in (1, 2, 3, 4)])
TIMED = [("ssaa", 8, 1), ("agaa", 8, 2), ("agaa", 32, 2)]


class Comparison:
    def __init__(self, arguments):
        self.harness = arguments.harness
        self.size = arguments.size
        self.work = arguments.out / "work"
        self.work.mkdir(parents=True, exist_ok=True)

    def call(self, kept, arguments):
        if kept and kept.exists():
            return json.loads(kept.read_text())
        result = subprocess.run([self.harness, *arguments, "--json"], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)
        if result.returncode != 0:
            last = result.stderr.strip().splitlines()[-1:] or ["no message"]
            sys.exit(f"backends: {' '.join(arguments)}: exit status {result.returncode}: {last[0]}")
        if kept:
            kept.write_text(result.stdout)
        return json.loads(result.stdout)

    def render(self, backend, view, configuration, *more):
        technique, n, c = configuration
        return self.call(None, ["render", "--backend", backend, *view, "--technique", technique,
                                "--samples", str(n), "--aggregates", str(c), "--no-counters", *more])

    def images(self, name, view, configuration):
        """Differences of the two images, and what the APIs said."""
        stem = "-".join(map(str, (name, *configuration)))
        kept = self.work / f"{stem}.json"
        if kept.exists():
            return json.loads(kept.read_text())
        messages = 0
        for backend in ("vk", "gl"):
            row = self.render(backend, view, configuration, "--no-timestamps", "--exr",
                              str(self.work / f"{backend}.exr"))
            messages += len(row["apiMessages"])
        row = self.call(None, ["compare", str(self.work / "vk.exr"), str(self.work / "gl.exr")])
        row["apiMessages"] = messages
        kept.write_text(json.dumps(row))
        return row

    def times(self, name, view, configuration, frames):
        """A B B A runs: medians of frames and passes, and the ratio of the frames."""
        stem = "-".join(map(str, (name, *configuration)))
        kept = self.work / f"{stem}-times.json"
        if kept.exists():
            return json.loads(kept.read_text())
        runs = {"vk": [], "gl": []}
        for backend in ("vk", "gl", "gl", "vk"):
            runs[backend].append(self.render(backend, view, configuration, "--no-validation",
                                             "--warmup", "2", "--frames", str(frames)))
        out = {}
        for backend, rows in runs.items():
            out[backend] = {
                "frameMs": statistics.median(row["frameMs"]["median"] for row in rows),
                "timeSource": rows[0]["timeSource"],
                "passes": {p["name"]: statistics.median(
                    row["passes"][i]["ms"]["median"] for row in rows)
                    for i, p in enumerate(rows[0]["passes"])}}
        out["ratio"] = out["gl"]["frameMs"] / out["vk"]["frameMs"]
        kept.write_text(json.dumps(out))
        return out


def image_table(results):
    lines = ["| scene | technique | n | c | mean difference /255 | pixels above 4/255, % | largest, linear | "
             "PSNR, dB |", "|---|---|---|---|---|---|---|---|"]
    for r in results:
        psnr = "equal" if r["psnr"] is None else f"{r['psnr']:.1f}"
        lines.append(f"| {r['scene']} | {r['technique']} | {r['samples']} | {r['aggregates']} | "
                     f"{255 * r['meanAbsTm']:.4f} | {100 * r['above4of255']:.4f} | {r['maxAbs']:.3g} | "
                     f"{psnr} |")
    return lines


def time_table(results):
    lines = ["| scene | technique | n | c | Vulkan frame | OpenGL frame | ratio | Vulkan passes | "
             "OpenGL passes |", "|---|---|---|---|---|---|---|---|---|"]
    for r in results:
        passes = {b: ", ".join(f"{name} {ms:.0f}" for name, ms in r[b]["passes"].items())
                  for b in ("vk", "gl")}
        lines.append(f"| {r['scene']} | {r['technique']} | {r['samples']} | {r['aggregates']} | "
                     f"{r['vk']['frameMs']:.0f} | {r['gl']['frameMs']:.0f} | {r['ratio']:.2f} | "
                     f"{passes['vk']} | {passes['gl']} |")
    return lines


def write(out, devices, size, images, times):
    (out / "backends.json").write_text(json.dumps(
        {"devices": devices, "size": size, "images": images, "times": times}, indent=1) + "\n")
    worst = max(images, key=lambda r: r["meanAbsTm"])
    most = max(images, key=lambda r: r["above4of255"])
    lines = ["# OpenGL beside Vulkan", "",
             f"Generated by `tools/backends.py` on {devices['vk']} (Vulkan) and {devices['gl']} (OpenGL), "
             f"{size}.", "",
             f"Largest mean difference {255 * worst['meanAbsTm']:.4f}/255 ({worst['scene']}, "
             f"{worst['technique']} n={worst['samples']} c={worst['aggregates']}); most pixels above 4/255 "
             f"{100 * most['above4of255']:.4f} % ({most['scene']}, {most['technique']} "
             f"n={most['samples']} c={most['aggregates']}); "
             f"{sum(r['apiMessages'] for r in images)} validation or debug messages in {len(images)} "
             "pairs of runs.", "", "## Images", "", *image_table(images)]
    if times:
        lines += ["", "## Times", "",
                  f"Milliseconds, medians of A B B A runs; frames without times of passes. Passes on Vulkan by "
                  f"{times[0]['vk']['timeSource']}, on OpenGL by {times[0]['gl']['timeSource']}.", "",
                  *time_table(times)]
    (out / "backends.md").write_text("\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--harness", default="build/bin/agaa-harness")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--times", type=int, default=0, metavar="FRAMES",
                        help="also time this many frames a run; on an idle machine")
    arguments = parser.parse_args()
    comparison = Comparison(arguments)
    scenes = [(name, name, None) for name in BUILTIN] + shared_scenes()
    images, times, devices = [], [], {}
    for backend in ("vk", "gl"):
        caps = comparison.call(None, ["caps", "--backend", backend])
        devices[backend] = f"{caps['device']}, {caps['driver']}"
    begin, done, total = time.monotonic(), 0, len(scenes) * len(CONFIGURATIONS)
    for name, source, camera in scenes:
        view = ["--scene", source, "--size", arguments.size]
        view += ["--camera=" + camera] if camera else []
        for configuration in CONFIGURATIONS:
            row = {"scene": name}
            row.update(zip(("technique", "samples", "aggregates"), configuration))
            images.append(dict(row, **comparison.images(name, view, configuration)))
            done += 1
            if arguments.times and configuration in TIMED:
                times.append(dict(row, **comparison.times(name, view, configuration, arguments.times)))
        left = (time.monotonic() - begin) / done * (total - done)
        print(f"{name}: {done} of {total}, {left:.0f} s left", flush=True)
        write(arguments.out, devices, arguments.size, images, times)
    print(f"Wrote {arguments.out / 'backends.md'}")


if __name__ == "__main__":
    main()
