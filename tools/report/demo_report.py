#!/usr/bin/env python3
"""Writes the page of a demo run: DIR/index.html beside the PNG files it shows.

usage: demo_report.py --out DIR DIR/demo.json
"""

import argparse
import json
import math
import re
import sys
from html import escape
from pathlib import Path
from urllib.parse import quote

MISSING = "–"
STAGES = ["prepass", "shadowmap", "definition", "generation", "shading", "post", "other"]
SOFTWARE = re.compile(r"llvmpipe|lavapipe|softpipe|swiftshader|swrast", re.IGNORECASE)

# Heading of the runs table and what a reader needs to know of it.
READING = [
    ("n", "visibility samples a pixel."),
    ("c", "aggregates a pixel: how many times at most the lighting of a pixel is computed when "
          "its samples are grouped. – where a technique does not group them."),
    ("mseTm", "mean squared error against the scene's reference after x/(1+x), then ^(1/2.2). "
              "Lower is better."),
    ("÷ single", "that error divided by the error of the run with one sample a pixel: 0.10 means "
                 "a tenth of its error is left."),
    ("FLIP", "mean visible difference against the reference, 0 to 1, as seen when flipping "
             "between the two images (Andersson et al. 2020). Lower is better."),
    ("events/px", "shading events a pixel: how often the lighting was really computed."),
    ("bytes/px", "memory of the technique's buffers a pixel."),
    ("frame ms", "median time of a frame and, behind it, the 95th percentile."),
    ("passes", "median time of each pass, drawn to one scale within a scene."),
]


def number(value):
    """The value as a float, or None where it is missing or no number."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return None
    return None if math.isnan(value) else float(value)


def fixed(value, digits):
    value = number(value)
    if value is None:
        return MISSING
    if math.isinf(value):
        return "∞" if value > 0 else "−∞"
    return f"{value:.{digits}f}"


def compact(value, digits=3):
    """Three significant digits; whole numbers in full."""
    value = number(value)
    if value is None:
        return MISSING
    if math.isinf(value):
        return fixed(value, 0)
    if value == int(value) and abs(value) < 1e15:
        return str(int(value))
    return f"{value:.{digits}g}" if abs(value) < 1000 else f"{value:.0f}"


def scientific(value):
    """One notation for all errors of a table, so that their orders of magnitude line up."""
    value = number(value)
    if value is None or math.isinf(value):
        return fixed(value, 0)
    mantissa, exponent = f"{value:.2e}".split("e")
    return f"{mantissa}e{int(exponent)}"


def binary_size(value):
    value = number(value)
    return MISSING if value is None or math.isinf(value) else f"{value / (1 << 20):.1f} MiB"


def text(value):
    """Anything a person may read, escaped; a dash where there is nothing."""
    if value is None or value == "":
        return MISSING
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return compact(value, 6)
    if isinstance(value, (dict, list)):
        return escape(json.dumps(value, ensure_ascii=False))
    return escape(str(value))


def items(parent, key):
    """The dicts of a list that may be missing."""
    value = parent.get(key) if isinstance(parent, dict) else None
    return [item for item in value if isinstance(item, dict)] if isinstance(value, list) else []


def field(parent, *keys):
    for key in keys:
        parent = parent.get(key) if isinstance(parent, dict) else None
    return parent


def label_of(run):
    return str(run.get("label") or run.get("technique") or "run")


def image_url(folder, name):
    """The relative link to an image, or None where the file is not there."""
    if not isinstance(name, str) or not name:
        return None
    try:
        inside = (folder / name).resolve().relative_to(folder.resolve())
    except ValueError:
        return None
    return quote(inside.as_posix()) if (folder / name).is_file() else None


def parse_size(value):
    match = re.fullmatch(r"(\d+)x(\d+)", str(value or ""))
    return (int(match[1]), int(match[2])) if match else None


def viewer(scene, folder):
    shown = [(run, image_url(folder, run.get("png"))) for run in items(scene, "runs")]
    shown = [(run, url) for run, url in shown if url]
    if not shown:
        return '<p class="absent">No images were kept of this scene.</p>'

    techniques = [run.get("technique") for run, _ in shown]
    left = techniques.index("single") if "single" in techniques else 0
    right = techniques.index("agaa") if "agaa" in techniques else len(shown) - 1

    def options(selected):
        out = []
        for i, (run, url) in enumerate(shown):
            difference = image_url(folder, run.get("difference"))
            out.append(
                f'<option value="{i}" data-png="{escape(url)}"'
                + (f' data-difference="{escape(difference)}"' if difference else "")
                + (" selected" if i == selected else "")
                + f">{escape(label_of(run))}</option>")
        return "".join(out)

    size = parse_size(scene.get("size"))
    attributes = f' width="{size[0]}" height="{size[1]}"' if size else ""
    data_width = f' data-width="{size[0]}"' if size else ""
    name = text(scene.get("name"))
    zooms = "".join(
        f'<button type="button" data-zoom="{zoom}" aria-pressed="{pressed}">{shown_as}</button>'
        for zoom, pressed, shown_as in [("fit", "true", "Fit"), ("1", "false", "1×"),
                                        ("2", "false", "2×"), ("4", "false", "4×")])

    def image(side, index):
        run, url = shown[index]
        return (f'<img class="{side}" src="{escape(url)}" alt="{escape(label_of(run))}"'
                f'{attributes} draggable="false">')

    return f"""<div class="viewer">
<div class="controls">
<label class="pick"><span>Left</span> <select class="left">{options(left)}</select></label>
<label class="pick"><span>Right</span> <select class="right">{options(right)}</select></label>
<div class="zoom" role="group" aria-label="Zoom of {name}">{zooms}</div>
<label><input type="checkbox" class="difference" autocomplete="off"> Right side as difference
image</label>
</div>
<div class="view">
<div class="sides"><span class="side-left"></span><span class="side-right"></span></div>
<div class="frame" tabindex="0" role="region" aria-label="Images of {name}">
<div class="stage"{data_width}>{image("left", left)}{image("right", right)}
<div class="divider" aria-hidden="true"></div></div>
</div>
<input class="split" type="range" min="0" max="100" step="0.1" value="50"
aria-label="Where {name} goes from the left to the right image" autocomplete="off">
</div>
</div>"""


def passes_of(run):
    out = []
    for step in items(run, "passes"):
        ms = number(field(step, "ms", "median"))
        if ms is not None and math.isfinite(ms) and ms >= 0:
            stage = step.get("stage") if step.get("stage") in STAGES else "other"
            out.append((text(step.get("name")), stage, ms))
    return out


def pass_bar(run, longest):
    passes = passes_of(run)
    if not passes or longest <= 0:
        return ""
    words = "; ".join(f"{name} {ms:.2f} ms" for name, _, ms in passes)
    pieces = "".join(
        f'<i class="stage-{stage}" style="width:{100 * ms / longest:.2f}%" '
        f'title="{name}: {ms:.2f} ms"></i>' for name, stage, ms in passes)
    return f'<div class="bar" role="img" aria-label="{words}">{pieces}</div>'


def runs_table(scene):
    runs = items(scene, "runs")
    single = next((run for run in runs if run.get("technique") == "single"), None)
    base = number(field(single, "metrics", "mseTm"))
    longest = max((sum(ms for _, _, ms in passes_of(run)) for run in runs), default=0)

    rows = []
    for run in runs:
        error = number(field(run, "metrics", "mseTm"))
        ratio = error / base if error is not None and base else None
        median = fixed(field(run, "frameMs", "median"), 2)
        bar = pass_bar(run, longest)
        p95 = fixed(field(run, "frameMs", "p95"), 2)
        cells = [
            ("text", "technique", text(run.get("technique"))),
            ("", "n", text(run.get("samples"))),
            ("", "c", text(run.get("aggregates"))),
            ("", "mseTm", scientific(error)),
            ("", "÷ single", fixed(ratio, 3)),
            ("", "FLIP", fixed(field(run, "metrics", "flip"), 4)),
            ("", "events/px", fixed(run.get("shadingEventsPerPixel"), 2)),
            ("", "bytes/px", compact(run.get("bytesPerPixel"))),
            ("wide", "frame ms", median if p95 == MISSING else f"{median} ({p95})"),
            ("passes wide drawn" if bar else "passes wide", "passes", bar or MISSING),
        ]
        body = "".join(
            "<td" + (f' class="{kind}"' if kind else "") + f' data-label="{name}">{value}</td>'
            for kind, name, value in cells)
        rows.append(f'<tr><th scope="row" class="text">{escape(label_of(run))}</th>{body}</tr>')

    heads = '<th scope="col" class="text">run</th><th scope="col" class="text">technique</th>'
    heads += "".join(
        '<th scope="col"' + (' class="passes"' if name == "passes" else "") + f">{name}</th>"
        for name, _ in READING)
    legend = "".join(f'<li><i class="stage-{stage}"></i>{stage}</li>' for stage in STAGES
                     if any(stage == used for run in runs for _, used, _ in passes_of(run)))
    return (f'<div class="scroll"><table class="runs"><caption>Error is measured against the '
            f"scene's reference; – means not measured.</caption>"
            f"<thead><tr>{heads}</tr></thead><tbody>{''.join(rows)}</tbody></table></div>"
            + (f'<ul class="legend" aria-label="Stages of the passes">{legend}</ul>'
               if legend else ""))


def details(scene):
    """What the main table leaves out: the other metrics, memory, counters and each pass."""
    runs = items(scene, "runs")

    def rows_of(section, values):
        keys = []
        for run in runs:
            keys += [key for key in values(run) if key not in keys]
        return [(section, key, [values(run).get(key, MISSING) for run in runs]) for key in keys]

    def as_texts(key):
        return lambda run: {escape(str(name)): text(value) for name, value in
                            (run.get(key) if isinstance(run.get(key), dict) else {}).items()}

    rows = rows_of("metric", as_texts("metrics"))
    rows += rows_of("memory", lambda run: {"driver": binary_size(run.get("driverBytes"))})
    rows += rows_of("counter", as_texts("counters"))
    rows += rows_of("pass, ms", lambda run: {f"{name} [{stage}]": f"{ms:.3f}"
                                             for name, stage, ms in passes_of(run)})
    heads = "".join(f'<th scope="col">{escape(label_of(run))}</th>' for run in runs)
    body = "".join(
        f'<tr><td class="text">{section}</td><th scope="row" class="text">{key}</th>'
        + "".join(f"<td>{value}</td>" for value in values) + "</tr>"
        for section, key, values in rows)
    return (f'<details><summary>All numbers</summary><div class="scroll"><table class="narrow">'
            f'<thead><tr><th class="text"></th><th class="text"></th>{heads}</tr></thead>'
            f"<tbody>{body}</tbody></table></div></details>")


def timings_table(demo):
    timings = items(demo, "timings")
    if not timings:
        return ""
    rows = "".join(f'<tr><th scope="row" class="text">{text(step.get("step"))}</th>'
                   f'<td>{fixed(step.get("seconds"), 1)}</td></tr>' for step in timings)
    seconds = [number(step.get("seconds")) for step in timings]
    total = sum(value for value in seconds if value is not None)
    return (f'<h2 id="timings">How long the demo took</h2><table class="narrow"><thead><tr>'
            f'<th scope="col" class="text">step</th><th scope="col">seconds</th></tr></thead>'
            f'<tbody>{rows}<tr><th scope="row" class="text">all</th><td>{total:.1f}</td></tr>'
            f"</tbody></table>")


def page(demo, folder):
    here = Path(__file__).resolve().parent
    style = (here / "demo_report.css").read_text(encoding="utf-8")
    script = (here / "demo_report.js").read_text(encoding="utf-8")
    title = text(demo.get("title") or "Anti-aliasing demo")
    scenes = items(demo, "scenes")
    commands = demo.get("commands") if isinstance(demo.get("commands"), list) else []

    note = ""
    if SOFTWARE.search(f"{demo.get('device')} {demo.get('driver')}"):
        note = ('<p class="note">These frames were drawn by a software rasteriser. Its '
                "milliseconds say nothing about a graphics card; compare them with each other "
                "only. Error, bytes and shading events do not depend on its speed.</p>")
    toc = "".join(f'<li><a href="#scene-{i}">{text(scene.get("name"))}</a></li>'
                  for i, scene in enumerate(scenes))
    reading = "".join(f"<dt>{name}</dt><dd>{words}</dd>" for name, words in READING)
    sections = "\n".join(
        f'<section class="scene" id="scene-{i}">\n<h2>{text(scene.get("name"))}'
        f'<small>{text(scene.get("size"))}</small></h2>\n{viewer(scene, folder)}\n'
        f"{runs_table(scene)}\n{details(scene)}\n</section>" for i, scene in enumerate(scenes))
    lines = "\n".join(escape(str(command)) for command in commands) or MISSING

    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<link rel="icon" href="data:,">
<style>
{style}</style>
</head>
<body>
<header>
<h1>{title}</h1>
<p class="device">Device: {text(demo.get("device"))} · Driver: {text(demo.get("driver"))}</p>
{note}
<ul class="toc">{toc}</ul>
</header>
<main>
<section class="how">
<h2 id="how">How to read this</h2>
<p>Pick two runs of a scene and drag the slider, or the line in the picture, to wipe between them;
with the slider in focus the arrow keys do the same. 2× and 4× show every pixel as a square: look
at thin structures there. The difference image is the run against the reference, brightened. A good
technique has a low error at few shading events, bytes and milliseconds.</p>
<dl class="reading">{reading}</dl>
</section>
{sections}
<section class="commands">
<h2 id="commands">Command lines</h2>
<pre><code>{lines}</code></pre>
</section>
<section class="timings">
{timings_table(demo)}
</section>
</main>
<script>
{script}</script>
</body>
</html>
"""


def main(arguments):
    parser = argparse.ArgumentParser(description="Writes DIR/index.html of a demo run.")
    parser.add_argument("--out", required=True, metavar="DIR", type=Path,
                        help="folder of the page and of the PNG files it shows")
    parser.add_argument("demo", type=Path, help="the demo run's demo.json")
    options = parser.parse_args(arguments)
    try:
        demo = json.loads(options.demo.read_text(encoding="utf-8"))
        if not isinstance(demo, dict):
            raise ValueError("it holds no JSON object")
    except (OSError, ValueError) as error:
        print(f"Could not read {options.demo}: {error}", file=sys.stderr)
        return 1
    try:
        options.out.mkdir(parents=True, exist_ok=True)
        (options.out / "index.html").write_text(page(demo, options.out), encoding="utf-8")
    except OSError as error:
        print(f"Could not write {options.out / 'index.html'}: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
