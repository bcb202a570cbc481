#!/usr/bin/env python3
"""Writes the page of a sweep: one file that needs no other and no network.

usage: sweep_report.py RESULTS.json OUT.html

docs/sweep.md describes RESULTS.json; its images are read relative to it.
"""

import argparse
import base64
import json
import math
import sys
from pathlib import Path

from gpu_frames import gpu_frames
from sweep_images import take_images

HERE = Path(__file__).resolve().parent
CHART_JS = ["/usr/share/javascript/chart.js/chart.min.js",
            "/usr/share/nodejs/chart.js/dist/chart.min.js",
            "/usr/share/nodejs/chart.js/dist/chart.umd.js"]
SLIDER = HERE / "vendor" / "img-comparison-slider-8.0.7.min.js"
# Later files use names of earlier ones, so that the order matters.
SCRIPTS = ["data.js", "maths.js", "dom.js", "charts.js", "pareto.js", "bars.js", "tables.js",
           "papers.js", "onepass.js", "claims.js", "best.js", "compare.js", "motion.js", "gpu.js", "main.js"]


def find_chart_js(chosen):
    for path in [chosen] if chosen else CHART_JS:
        if Path(path).is_file():
            return Path(path).read_text(encoding="utf-8")
    raise FileNotFoundError(
        f"Chart.js is not at {chosen}." if chosen else
        "Chart.js is missing: install Debian's package libjs-chart.js, as scripts/install-deps "
        "does, or name its chart.min.js by --chart-js.")


def finite(value):
    """The value with None for NaN and infinities, which browsers refuse in JSON."""
    if isinstance(value, dict):
        return {key: finite(item) for key, item in value.items()}
    if isinstance(value, list):
        return [finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def as_script(value):
    """JSON in which no text can end the script element."""
    return json.dumps(value, ensure_ascii=False, allow_nan=False,
                      separators=(",", ":")).replace("<", "\\u003c")


def library(source):
    # Without this line, the developer tools of a browser would request a missing source map.
    return "\n".join(line for line in source.splitlines()
                     if not line.startswith("//# sourceMappingURL"))


def read_motions(folder):
    """The results of benchmark/motion.py in a folder, and animated images as base64 texts or None."""
    if folder is None:
        return {"views": []}
    motions = finite(json.loads((folder / "motion.json").read_text(encoding="utf-8")))
    for view in motions["views"]:
        for row in view.get("rows", []):
            row.pop("errors", None)
        path = folder / f"{view['backend']}-{view['name']}-{view['motion']}.webp"
        view["image"] = base64.b64encode(path.read_bytes()).decode("ascii") if path.is_file() else None
    return motions


def page(results, folder, chart_js, most_bytes, names=(), motions=None, gpus=()):
    def read(name):
        return (HERE / name).read_text(encoding="utf-8")

    results = finite(results)
    images, left_out = take_images(results, folder, most_bytes, names)
    results["imagesLeftOut"] = left_out
    motions = motions or {"views": []}
    for view in motions["views"]:
        if view["image"]:
            images.append(view["image"])
            view["image"] = len(images) - 1
    slider = f"/*!\n{read('vendor/img-comparison-slider.LICENSE')}*/\n" + SLIDER.read_text("utf-8")
    parts = {
        "STYLE": read("vendor/img-comparison-slider-8.0.7.css") + read("sweep/sweep.css"),
        "RESULTS": as_script(results),
        "MOTIONS": as_script(motions),
        "GPUS": as_script(finite(list(gpus))),
        "PAPERS": as_script(json.loads(read("sweep/papers.json"))),
        "IMAGES": "\n".join(f'<script type="text/plain" id="image-{i}">{text}</script>'
                            for i, text in enumerate(images)),
        "LIBRARIES": "\n".join(f"<script>\n{library(source)}\n</script>"
                               for source in (chart_js, slider)),
        "SCRIPT": "\n".join(read(f"sweep/{name}") for name in SCRIPTS),
    }
    # Splitting, unlike repeated replacement, never searches one part for the marks of another.
    pieces = read("sweep/page.html").split("@@")
    return "".join(parts[piece] if i % 2 else piece for i, piece in enumerate(pieces))


def main(arguments):
    parser = argparse.ArgumentParser(description="Writes the page of a sweep.")
    parser.add_argument("results", type=Path, help="the sweep's results.json")
    parser.add_argument("out", type=Path, help="the page to write")
    parser.add_argument("--also", action="append", default=[], type=Path, metavar="FILE",
                        help="results of another backend; its images are beside those of the first; repeatable")
    parser.add_argument("--chart-js", metavar="FILE", help="Chart.js, if not where Debian has it")
    parser.add_argument("--image-mib", type=float, default=48, metavar="MIB",
                        help="most room for images in the page (default: 48)")
    parser.add_argument("--image", action="append", default=[], metavar="NAME",
                        help="only this image of each scene, such as reference or agaa-8-2; repeatable")
    parser.add_argument("--motion", type=Path, metavar="FOLDER",
                        help="results of benchmark/motion.py, and of motion_images.py if they are there")
    parser.add_argument("--gpu", action="append", default=[], type=Path, metavar="FILE",
                        help="passes.json of benchmark/gpu_run.py, whose frames stand beside the sweep's; repeatable")
    options = parser.parse_args(arguments)
    try:
        chart_js = find_chart_js(options.chart_js)
    except OSError as error:
        print(error, file=sys.stderr)
        return 1
    try:
        results = json.loads(options.results.read_text(encoding="utf-8"))
        if not isinstance(results, dict):
            raise ValueError("it holds no JSON object")
        if results.get("schema", 3) not in (2, 3):
            raise ValueError(f"its schema is {results['schema']}; this page shows schemas 2 and 3")
        for path in options.also:
            results["backends"] += json.loads(path.read_text(encoding="utf-8"))["backends"]
    except (OSError, KeyError, TypeError, ValueError) as error:
        print(f"Could not read {', '.join(map(str, [options.results, *options.also]))}: {error}", file=sys.stderr)
        return 1
    try:
        motions = read_motions(options.motion)
    except (OSError, KeyError, TypeError, AttributeError, ValueError) as error:
        print(f"Could not read {options.motion}, which is to be a folder of benchmark/motion.py: {error}", file=sys.stderr)
        return 1
    try:
        passes = [json.loads(path.read_text(encoding="utf-8")) for path in options.gpu]
        gpus = [gpu for each in passes for gpu in (gpu_frames(each, "vk"), gpu_frames(each, "gl")) if gpu]
        if len(gpus) < len(passes):
            raise ValueError("it has no rows")
    except (OSError, KeyError, IndexError, TypeError, AttributeError, ValueError) as error:
        print(f"Could not read {', '.join(map(str, options.gpu))}: passes.json of benchmark/gpu_run.py is wanted: {error}",
              file=sys.stderr)
        return 1
    try:
        options.out.parent.mkdir(parents=True, exist_ok=True)
        options.out.write_text(page(results, options.results.parent, chart_js,
                                    int(options.image_mib * (1 << 20)), options.image, motions, gpus), encoding="utf-8")
    except OSError as error:
        print(f"Could not write {options.out}: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
