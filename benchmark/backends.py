#!/usr/bin/env python3
"""Compares OpenGL with Vulkan over scenes and techniques: images, and with --times frames and passes.

Writes OUT/backends.json and OUT/backends.md. An interrupted run continues with the results in OUT/work.
"""
import statistics
import time
import typing

from command_line import tool_parser
from markdown_table import table
from runs import Runs, find_scenes, view_options, write_results


class Configuration(typing.NamedTuple):
    technique: str
    samples: int
    aggregates: int = 1
    tier: str = "auto"  # of generation
    preset: str = ""    # sets the aggregates; "": none

    def options(self):
        technique = (["--preset", self.preset] if self.preset else
                     ["--technique", self.technique, "--aggregates", self.aggregates])
        tier = [] if self.tier == "auto" else ["--tier", f"generation={self.tier}"]
        return [*technique, "--samples", self.samples, *tier]

    def variant(self):
        """The preset and the tier; empty for the defaults."""
        return " ".join(filter(None, [self.preset, "" if self.tier == "auto" else self.tier]))


CONFIGURATIONS = [Configuration(*row) for row in [
    ("single", 1), ("fxaa", 1), ("smaa", 1), ("taa", 1), ("msaa", 8), *(("ssaa", n) for n in (4, 8, 16, 32)),
    ("visibility", 8), ("simple_complex", 8), ("simple_complex", 32), ("sbaa", 8, 2), ("sbaa", 32, 6),
    ("agaa", 4, 2), ("agaa", 8, 1), ("agaa", 8, 2), ("agaa", 8, 4), ("agaa", 16, 2), ("agaa", 32, 2), ("agaa", 32, 4),
    *(("agaa", n, 2, tier) for tier in ("gbuffer", "ids") for n in (8, 32)),
    *(("agaa", 8, c, tier, preset) for tier in ("gbuffer", "ids")
      for c, preset in ((1, "fast"), (4, "balanced"), (4, "accurate")))]]
TIMED = [Configuration(*row) for row in [("ssaa", 8), ("agaa", 8, 2), ("agaa", 32, 2), ("agaa", 8, 2, "ids")]]


class Comparison:
    def __init__(self, arguments):
        self.runs = Runs("backends", arguments.harness, arguments.out,
                         {"size": arguments.size, "times": arguments.times,
                          "configurations": [list(row) for row in CONFIGURATIONS]})

    def render(self, backend, view, configuration, *more):
        return self.runs.call("render", "--backend", backend, *view, *configuration.options(), "--no-counters", *more)

    def images(self, view, configuration):
        """Differences of the two images, and the number of messages of both APIs."""
        messages, files = 0, {backend: self.runs.work / f"{backend}.exr" for backend in ("vk", "gl")}
        for backend, file in files.items():
            row = self.render(backend, view, configuration, "--no-timestamps", "--exr", file)
            messages += len(row["apiMessages"])
        row = self.runs.call("compare", *files.values())
        row["apiMessages"] = messages
        return row

    def times(self, view, configuration, frames):
        """Medians of frames and passes, and the ratio of the frames. The order is Vulkan, OpenGL, OpenGL, Vulkan."""
        runs = {"vk": [], "gl": []}
        for backend in ("vk", "gl", "gl", "vk"):
            runs[backend].append(self.render(backend, view, configuration, "--no-validation",
                                             "--warmup", 2, "--frames", frames))
        out = {}
        for backend, rows in runs.items():
            out[backend] = {
                "frameMs": statistics.median(row["frameMs"]["median"] for row in rows),
                "timeSource": rows[0]["timeSource"],
                "passes": {p["name"]: statistics.median(
                    row["passes"][i]["ms"]["median"] for row in rows)
                    for i, p in enumerate(rows[0]["passes"])}}
        out["ratio"] = out["gl"]["frameMs"] / out["vk"]["frameMs"]
        return out


def variant(row):
    return Configuration(*(row[field] for field in Configuration._fields)).variant()


def named(row):
    return " ".join(filter(None, [f"{row['technique']} n={row['samples']} c={row['aggregates']}", variant(row)]))


def first_cells(row):
    return [row["scene"], row["technique"], row["samples"], row["aggregates"], variant(row)]


def image_table(results):
    return table(["scene", "technique", "n", "c", "way", "mean difference /255", "pixels above 4/255, %",
                  "largest, linear", "PSNR, dB"],
                 [[*first_cells(r), f"{255 * r['meanAbsTm']:.4f}", f"{100 * r['above4of255']:.4f}",
                   f"{r['maxAbs']:.3g}", "equal" if r["psnr"] is None else f"{r['psnr']:.1f}"] for r in results])


def time_table(results):
    rows = []
    for r in results:
        passes = [", ".join(f"{name} {ms:.0f}" for name, ms in r[backend]["passes"].items())
                  for backend in ("vk", "gl")]
        rows.append([*first_cells(r), f"{r['vk']['frameMs']:.0f}", f"{r['gl']['frameMs']:.0f}", f"{r['ratio']:.2f}",
                     *passes])
    return table(["scene", "technique", "n", "c", "way", "Vulkan frame", "OpenGL frame", "ratio", "Vulkan passes",
                  "OpenGL passes"], rows)


def write(out, devices, size, images, times):
    worst = max(images, key=lambda r: r["meanAbsTm"])
    most = max(images, key=lambda r: r["above4of255"])
    lines = ["# OpenGL beside Vulkan", "",
             f"Generated by `benchmark/backends.py` on {devices['vk']} (Vulkan) and {devices['gl']} (OpenGL), "
             f"{size}.", "",
             f"Largest mean difference {255 * worst['meanAbsTm']:.4f}/255 ({worst['scene']}, "
             f"{named(worst)}); most pixels above 4/255 {100 * most['above4of255']:.4f} % ({most['scene']}, "
             f"{named(most)}); "
             f"{sum(r['apiMessages'] for r in images)} validation or debug messages in {len(images)} "
             "pairs of runs.", "", "## Images", "", *image_table(images)]
    if times:
        lines += ["", "## Times", "",
                  f"Milliseconds, medians of A B B A runs; frames without times of passes. Passes on Vulkan by "
                  f"{times[0]['vk']['timeSource']}, on OpenGL by {times[0]['gl']['timeSource']}.", "",
                  *time_table(times)]
    data = {"devices": devices, "size": size, "images": images, "times": times}
    write_results(out, "backends", data, "\n".join(lines) + "\n")


def main():
    parser = tool_parser(__doc__, out="", size="640x360")
    parser.add_argument("--times", type=int, default=0, metavar="FRAMES",
                        help="also time this many frames in each run; needs an idle machine")
    arguments = parser.parse_args()
    comparison = Comparison(arguments)
    kept, scenes = comparison.runs.kept, find_scenes("backends")
    images, times, devices = [], [], {}
    for backend in ("vk", "gl"):
        caps = comparison.runs.call("caps", "--backend", backend)
        devices[backend] = f"{caps['device']}, {caps['driver']}"
    begin, done, total = time.monotonic(), 0, len(scenes) * len(CONFIGURATIONS)
    for name, source, camera in scenes:
        view = view_options(source, camera, arguments.size)
        for configuration in CONFIGURATIONS:
            row = {"scene": name}
            row.update(configuration._asdict())
            stem = "-".join(map(str, filter(None, (name, *configuration))))
            images.append(dict(row, **kept(stem, lambda: comparison.images(view, configuration))))
            done += 1
            if arguments.times and configuration in TIMED:
                measured = kept(stem + "-times", lambda: comparison.times(view, configuration, arguments.times))
                times.append(dict(row, **measured))
        left = (time.monotonic() - begin) / done * (total - done)
        print(f"{name}: {done} of {total}, {left:.0f} s left", flush=True)
        write(arguments.out, devices, arguments.size, images, times)
    print(f"Wrote {arguments.out / 'backends.md'}")


if __name__ == "__main__":
    main()
