#!/usr/bin/env python3
"""Makes the picture and the table of the README.

    tools/comparison_picture.py docs/images/comparison.png     renders one detail of a scene with three techniques
    tools/comparison_picture.py --table SWEEP.json PASSES.json prints the table, from the results of a sweep
                                                               (agaa-harness sweep) and from benchmark/passes.py

The picture needs a built agaa-harness. The table needs the two files only.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "benchmark"))
from command_line import tool_parser
from markdown_table import row as table_row
from png_rows import ImageError, beside, crop, read_png, write_png

SCENE, SIZE = "bamboo", "480x270"
CROP = 356, 52, 112, 92  # x, y, width, height in pixels
SCALE, GAP = 3, 6        # texels of the picture
COLUMNS = [              # of the picture: heading, technique, n, c
    ("no anti-aliasing: `single`", "single", 1, 0),
    ("supersampling: `ssaa`, n = 8", "ssaa", 8, 0),
    ("`agaa`, n = 8, c = 2", "agaa", 8, 2),
]


# The table: heading, technique, n, c or S, tier, preset
SCENES = "bamboo", "metal"
PASSES_SCENE = "bamboo"
ROWS = [
    ("`single`, one sample", "single", 1, 0, "", ""),
    ("MSAA: `msaa`", "msaa", 8, 0, "", ""),
    ("supersampling: `ssaa`", "ssaa", 8, 0, "", ""),
    ("one event: `visibility`", "visibility", 8, 0, "", ""),
    ("`adaptive`, n = 9", "adaptive", 9, 0, "gbuffer", ""),
    ("`sbaa`, S = 2", "sbaa", 8, 2, "", ""),
    ("`agaa`, c = 2", "agaa", 8, 2, "", ""),
    ("`agaa`, c = 2, by id", "agaa", 8, 2, "ids", ""),
    ("`agaa`, preset accurate, by id", "agaa", 8, 4, "ids", "accurate"),
    ("`dcaa`, n = 64, S = 4", "dcaa", 64, 4, "", ""),
]


class Error(Exception):
    """One sentence for the user."""


# ---- the picture and its table -------------------------------------------------------------------

def render(harness, technique, samples, aggregates, path):
    command = [harness, "render", "--scene", SCENE, "--size", SIZE, "--technique", technique, "--samples", str(samples),
               "--png", path, "--no-counters", "--no-timestamps"]
    if aggregates:
        command += ["--aggregates", str(aggregates)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise Error(f"agaa-harness failed: {done.stderr.strip()}")
    return read_png(path)


def picture(harness, out):
    panels = []
    with tempfile.TemporaryDirectory() as folder:
        for _, *settings in COLUMNS:
            rows = render(harness, *settings, pathlib.Path(folder) / "image.png")
            panels.append(crop(rows, *CROP))
    out.parent.mkdir(parents=True, exist_ok=True)
    write_png(out, beside(panels, SCALE, GAP), SCALE)


def tier_of(row):
    """The generation tier if a row requests one, otherwise ""."""
    tier = row["tiers"].get("generation")
    return tier if tier in ("gbuffer", "ids") else ""


def both(values, form):
    return " / ".join(form(value) for value in values)


def table(sweep, passes):
    """Markdown: error, memory, events and times of ROWS in SCENES, as measured on the first device of each file.

    Errors are squared after tone mapping, against the sweep's reference, in shares of the error of `single`.
    """
    backend = sweep["backends"][0]
    by_name = {scene["name"]: scene for scene in backend["scenes"] if not scene["plain"]}
    scenes = [by_name[name] for name in SCENES]

    def swept(scene, technique, samples, aggregates, tier, preset):
        def is_wanted(row):
            return ((row["technique"], row["n"], row["c"], row["shadingCost"], row["preset"])
                    == (technique, samples, aggregates, 1, preset) and tier_of(row) == tier)
        return next(filter(is_wanted, scene["rows"]))

    gpu = next(row for row in passes["rows"] if (row["scene"], row["backend"]) == (PASSES_SCENE, "vk"))

    def timed(technique, samples, aggregates, tier, preset):
        """Milliseconds of all passes on Vulkan, or "–" where they were not measured."""
        for row in passes["rows"]:
            # Rows of presets have 0 aggregates: the preset sets the number.
            if ((row["technique"], row["samples"], row["scene"], row["size"], row["backend"], row.get("way", ""))
                    == (technique, samples, PASSES_SCENE, gpu["size"], "vk", "")
                    and row["aggregates"] == (0 if preset else aggregates)
                    and (tier_of(row), row.get("preset", "")) == (tier, preset)):
                return f"{sum(one['ms']['median'] for one in row['passes'] if one['ms']):.2f}"
        return "–"

    lines = [["8 samples per pixel", "error", "bytes per pixel", "shading events per covered pixel",
              "frame, CPU, ms", "passes, GPU, ms"],
             ["---"] * 6]
    for heading, *settings in ROWS:
        rows = [swept(scene, *settings) for scene in scenes]
        singles = [swept(scene, "single", 1, 0, "", "") for scene in scenes]
        errors = [row["errorReference"]["mseTm"] / single["errorReference"]["mseTm"]
                  for row, single in zip(rows, singles)]
        lines.append([heading, both(errors, lambda x: f"{100 * x:.3g} %"),
                      " / ".join(sorted({f"{row['bytesPerPixel']:.0f}" for row in rows})),
                      both([row["eventsPerCoveredPixel"] for row in rows], "{:.1f}".format),
                      both([row["frameMs"]["median"] for row in rows], "{:.0f}".format), timed(*settings)])
    first, second = (f"`{name}`" for name in SCENES)
    samples = {scene["reference"]["spp"] for scene in scenes}
    text = (f"Pairs are the scenes {first} / {second} at {sweep['size']}, and the GPU renders "
            f"`{PASSES_SCENE}` at {gpu['size']} on Vulkan. The error is the mean square after tone mapping against "
            f"{max(samples)} samples per pixel; `single` has 100 %. CPU: {backend['device']}, Mesa's software rasteriser. GPU: "
            f"{gpu['device']}, sums of the medians of pass times; “–” was not measured.")
    return "".join(table_row(line) + "\n" for line in lines) + "\n" + textwrap.fill(text, 118) + "\n"


def main():
    parser = tool_parser(__doc__)
    parser.add_argument("--table", type=pathlib.Path, nargs=2, metavar=("SWEEP.json", "PASSES.json"))
    parser.add_argument("out", type=pathlib.Path, nargs="?", metavar="OUT.png")
    arguments = parser.parse_args()
    if bool(arguments.table) == bool(arguments.out):
        parser.error("give either OUT.png or --table SWEEP.json PASSES.json")
    if arguments.table:
        print(table(*(json.loads(path.read_text()) for path in arguments.table)), end="")
    elif not arguments.harness.exists():
        raise Error(f"{arguments.harness} does not exist; run scripts/build first.")
    else:
        picture(arguments.harness, arguments.out)


if __name__ == "__main__":
    try:
        main()
    except (Error, ImageError) as error:
        print(error, file=sys.stderr)
        sys.exit(1)
