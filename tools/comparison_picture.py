#!/usr/bin/env python3
"""Renders the picture of the README: one detail of a scene with three techniques, side by side.

    tools/comparison_picture.py docs/images/comparison.png      renders and writes the picture
    tools/comparison_picture.py --table RESULTS.json            prints the table below it, from a sweep's results

The picture needs a built agaa-harness. The table needs nothing but the file.
"""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "benchmark"))
from command_line import tool_parser
from markdown_table import row as table_row

SCENE, SIZE = "bamboo", "480x270"
CROP = 356, 52, 112, 92  # x, y, width, height in pixels
SCALE, GAP = 3, 6        # texels of the picture
COLUMNS = [              # heading, technique, n, c
    ("no anti-aliasing: `single`", "single", 1, 0),
    ("supersampling: `ssaa`, n = 8", "ssaa", 8, 0),
    ("`agaa`, n = 8, c = 2", "agaa", 8, 2),
]


class Error(Exception):
    """One sentence for the user."""


# ---- PNG with 8-bit RGB, which is all that agaa-harness writes ---------------------------------

def paeth(left, up, corner):
    estimate = left + up - corner
    distances = abs(estimate - left), abs(estimate - up), abs(estimate - corner)
    return (left, up, corner)[distances.index(min(distances))]


def unfilter(kind, line, above):
    """Undoes the filter of one scanline in place."""
    for i in range(len(line)):
        left, corner = (line[i - 3], above[i - 3]) if i >= 3 else (0, 0)
        up = above[i]
        line[i] = (line[i] + (0, left, up, (left + up) // 2, paeth(left, up, corner))[kind]) & 255
    return line


def read_png(path):
    """Rows of RGB bytes."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlace = struct.unpack(">IIBBBBB", body)
            if (depth, color, interlace) != (8, 2, 0):
                raise Error(f"{path} is not an 8-bit RGB image.")
        packed += body if kind == b"IDAT" else b""
        at += length + 12
    raw, rows, stride = zlib.decompress(packed), [bytearray(3 * width)], 3 * width + 1
    for y in range(height):
        line = raw[y * stride:(y + 1) * stride]
        rows.append(unfilter(line[0], bytearray(line[1:]), rows[-1]))
    return rows[1:]


def write_png(path, rows, repeats):
    """Writes each row `repeats` times. Repeated rows are stored as differences, which are 0."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    width = len(rows[0]) // 3
    lines = b"".join(b"\0" + row + (b"\2" + bytes(len(row))) * (repeats - 1) for row in rows)
    header = struct.pack(">IIBBBBB", width, len(rows) * repeats, 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines, 9)) +
                     chunk(b"IEND", b""))


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
    x, y, width, height = CROP
    panels = []
    with tempfile.TemporaryDirectory() as folder:
        for _, *settings in COLUMNS:
            rows = render(harness, *settings, pathlib.Path(folder) / "image.png")
            panels.append([row[3 * x:3 * (x + width)] for row in rows[y:y + height]])
    gap = b"\xff" * (3 * GAP)
    lines = []
    for parts in zip(*panels):
        wide = [b"".join(part[i:i + 3] * SCALE for i in range(0, len(part), 3)) for part in parts]
        lines.append(gap.join(bytes(part) for part in wide))
    out.parent.mkdir(parents=True, exist_ok=True)
    write_png(out, lines, SCALE)


def table(results):
    """Markdown: frame times and bytes per pixel of the scene, as measured by a sweep on its first device."""
    backend = results["backends"][0]
    scene = next(scene for scene in backend["scenes"] if scene["name"] == SCENE and not scene["plain"])

    def row(technique, samples, aggregates, tiers=(None, "post-depth-atomics", "per-sample")):
        def is_wanted(row):
            return ((row["technique"], row["n"], row["c"], row["shadingCost"], row["preset"])
                    == (technique, samples, aggregates, 1, "") and row["tiers"].get("generation") in tiers)
        return next(filter(is_wanted, scene["rows"]))

    rows = [row(*settings) for _, *settings in COLUMNS]
    cells = [
        [f"`{SCENE}`, {results['size']}", *(heading for heading, *_ in COLUMNS)],
        ["---"] * (len(COLUMNS) + 1),
        ["frame time", *(f"{row['frameMs']['median']:.0f} ms" for row in rows)],
        ["memory per pixel", *(f"{row['bytesPerPixel']:.0f} bytes" for row in rows)],
        ["shading events per covered pixel", *(f"{row['eventsPerCoveredPixel']:.1f}" for row in rows)],
    ]
    by_id = row("agaa", 8, 2, ("ids",))
    return ("".join(table_row(line) + "\n" for line in cells) +
            f"\nWith materials by id, the same aggregates take {by_id['frameMs']['median']:.0f} ms and "
            f"{by_id['bytesPerPixel']:.0f} bytes per pixel.\n")


def main():
    parser = tool_parser(__doc__)
    parser.add_argument("--table", type=pathlib.Path, metavar="RESULTS.json")
    parser.add_argument("out", type=pathlib.Path, nargs="?", metavar="OUT.png")
    arguments = parser.parse_args()
    if bool(arguments.table) == bool(arguments.out):
        parser.error("give either OUT.png or --table RESULTS.json")
    if arguments.table:
        print(table(json.loads(arguments.table.read_text())), end="")
    elif not arguments.harness.exists():
        raise Error(f"{arguments.harness} does not exist; run scripts/build first.")
    else:
        picture(arguments.harness, arguments.out)


if __name__ == "__main__":
    try:
        main()
    except Error as error:
        print(error, file=sys.stderr)
        sys.exit(1)
