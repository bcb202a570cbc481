#!/usr/bin/env python3
"""Renders the motions of benchmark/motion.py as short animated images (WebP), for the page of a sweep.

Each image has four views beside each other, of the middle of the frame: the reference, single, taa and agaa. It needs
Python's PIL with WebP (Debian: python3-pil). OUT/BACKEND-SCENE-MOTION.webp are the images.
"""
import sys
import tempfile
from pathlib import Path

from command_line import tool_parser
from motion import ROWS, chosen
from runs import ask_json, find_scenes, view_options

SHOWN = ["single", "taa", "agaa 8"]
PANEL = (240, 134)
FRAME_MS = 80


def require_pil():
    try:
        from PIL import Image, ImageDraw, features
    except ImportError:
        sys.exit("motion_images: Python's PIL is missing; install Debian's package python3-pil, and run it with /usr/bin/python3.")
    if not features.check("webp_anim"):
        sys.exit("motion_images: this PIL cannot write animated WebP images.")
    return Image, ImageDraw


def panel(image_class, path):
    image = image_class.open(path).convert("RGB")
    left, top = (image.width - PANEL[0]) // 2, (image.height - PANEL[1]) // 2
    return image.crop((left, top, left + PANEL[0], top + PANEL[1]))


def compose(folders, frame, pil):
    """One frame: the panels of the folders, by name, in two columns, with their names."""
    image_class, draw_class = pil
    grid = image_class.new("RGB", (2 * PANEL[0] + 2, 2 * PANEL[1] + 2))
    for place, (name, folder) in enumerate(folders.items()):
        x, y = (place % 2) * (PANEL[0] + 2), (place // 2) * (PANEL[1] + 2)
        grid.paste(panel(image_class, folder / f"{frame:03}.png"), (x, y))
        draw_class.Draw(grid).text((x + 4, y + 2), name, fill="white", stroke_width=1, stroke_fill="black")
    return grid


def animate(arguments, pil, name, source, camera, motion, backend, first):
    """Renders frames up to `first` + --frames, whose beginning shows no history yet, and writes the last --frames."""
    last = first + arguments.frames
    with tempfile.TemporaryDirectory() as folder:
        rows = [word for row in SHOWN for word in ("--row", ROWS[row])]
        ask_json(arguments.harness, "motion", "--backend", backend, *view_options(source, camera, arguments.size), "--motion", motion,
                 "--frames", str(last), "--spp", str(arguments.spp), "--images", folder, *rows)
        folders = {"reference": Path(folder) / "reference", **{row: Path(folder) / f"row{i}" for i, row in enumerate(SHOWN)}}
        frames = [compose(folders, frame, pil) for frame in range(first, last)]
    path = arguments.out / f"{backend}-{name}-{motion}.webp"
    frames[0].save(path, save_all=True, append_images=frames[1:], duration=FRAME_MS, loop=0, quality=arguments.quality, method=6)
    print(f"{path}: {path.stat().st_size / 1024:.0f} KiB", flush=True)


def main():
    parser = tool_parser(__doc__, out="motion", size="320x180", scenes=True, backends=True, frames=16)
    parser.add_argument("--motion", action="append", help="only this motion; repeatable")
    parser.add_argument("--spp", default=16, type=int, help="samples per pixel of the reference")
    parser.add_argument("--quality", default=60, type=int, help="of WebP, 1 to 100")
    arguments = parser.parse_args()
    pil = require_pil()
    arguments.out.mkdir(parents=True, exist_ok=True)
    known = {name: (source, camera) for name, source, camera in find_scenes("motion_images")}
    for scene, motion in chosen(arguments.scene, arguments.motion):
        source, camera = known.get(scene, (scene, ""))
        for backend in arguments.backend or ["vk"]:
            animate(arguments, pil, scene, source, camera, motion, backend, 12)


if __name__ == "__main__":
    main()
