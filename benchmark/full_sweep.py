#!/usr/bin/env python3
"""Runs agaa-sweep over the built-in scenes and the shared ones, on both backends, and prints the time.

Each scene has its own process, because drivers keep memory, and its own folder below OUT/scenes. Results and images of
all scenes are merged into OUT. An interrupted run continues when it is started again with the same --out. Times are
measured: nothing else should run meanwhile.
"""
import json
import shutil
import subprocess
import sys
import time

from command_line import tool_parser
from runs import ROOT, find_scenes, require_harness, write_json

# Hard scenes come first, so that an interrupted run has them.
FIRST = ["bamboo", "foliage", "furball", "metal", "sh3d_foliage"]
# --core: each technique, the settings that hosts choose among, and heavier shading.
CORE = ["single-1", "fxaa-1", "smaa-1", "taa-1", "msaa-8", "ssaa-4", "simple_complex-4", "ssaa-8", "visibility-8",
        "simple_complex-8", "ssaa-32", "visibility-32", "simple_complex-32", "sbaa-8-2", "agaa-4-2", "agaa-8-2", "agaa-32-2",
        "agaa-8-2-gbuffer", "agaa-8-2-ids", "agaa-32-2-gbuffer", "agaa-32-2-ids", "agaa-8-fast-gbuffer", "agaa-8-fast-ids",
        "agaa-8-balanced-gbuffer", "agaa-8-balanced-ids", "agaa-8-accurate-ids", "agaa-32-accurate-gbuffer",
        "agaa-32-accurate-ids", "dcaa-64-4", "dcaa-64-exact", "sgbc-32-4", "sgbc-64-4", "agaa-64-2-fragments", "adaptive-8-device", "adaptive-9"]
CORE += [f"{row}-cost{cost}{tier}" for cost in (4, 16) for row, tier in (("ssaa-8", ""), ("visibility-8", ""), ("agaa-8-2", "-ids"))]
# This scene has all effects, emission and normal maps included, so that each is measured with and without need for it.
PLAIN = "city"


def scenes(wanted):
    return sorted(find_scenes("full_sweep", wanted), key=lambda scene: (scene[0] not in FIRST, scene[0]))


def merge(folders, out):
    """Merges the scenes and images of sweeps with the same options into one folder."""
    merged = None
    (out / "images").mkdir(parents=True, exist_ok=True)
    for folder in folders:
        results = json.loads((folder / "results.json").read_text())
        for image in (folder / "images").iterdir():
            shutil.copyfile(image, out / "images" / image.name)
        if merged is None:
            merged = results
            continue
        for backend, more in zip(merged["backends"], results["backends"], strict=True):
            backend["scenes"] += more["scenes"]
    write_json(out / "results.json", merged)


def main():
    parser = tool_parser(__doc__, out="sweep", size="640x360", scenes=True, backends=True)
    parser.add_argument("--rounds", help="frames of each row; 101 suits a GPU")
    parser.add_argument("--row", action="append", help="only this row of agaa-sweep; repeatable")
    parser.add_argument("--core", action="store_true",
                        help="the rows of regular use, at 320x180 in three turns with JPEG images and without effects")
    parser.add_argument("--no-ablation", action="store_true", help="do not measure what each effect costs and removes")
    parser.add_argument("--jpeg", help="images as JPEG of this quality, 1 to 100, not as PNG")
    arguments = parser.parse_args()
    sweep = arguments.harness.with_name("agaa-sweep")
    require_harness("full_sweep", sweep)
    if arguments.core:
        if arguments.row:
            parser.error("--core has rows of its own; leave --row out.")
        arguments.row, arguments.no_ablation = CORE, True
        isGiven = any(word.startswith("--size") for word in sys.argv)
        arguments.size = arguments.size if isGiven else "320x180"
        arguments.rounds, arguments.jpeg = arguments.rounds or "3", arguments.jpeg or "85"
    common = [sweep, "--size", arguments.size]
    for backend in arguments.backend or ["vk", "gl"]:
        common += ["--backend", backend]
    for option in ("rounds", "jpeg"):
        if value := getattr(arguments, option):
            common += [f"--{option}", value]
    for row in arguments.row or []:
        common += ["--row", row]
    common += ["--no-ablation"] if arguments.no_ablation else []
    begin = time.monotonic()
    folders = []
    for name, source, camera in scenes(arguments.scene):
        folders.append(arguments.out / "scenes" / name)
        own = ["--out", folders[-1], "--scene", f"{source}@{camera}" if camera else source]
        own += ["--plain", PLAIN] if name == PLAIN and not arguments.no_ablation else []
        if code := subprocess.run(common + own).returncode:
            sys.exit(code)
        merge(folders, arguments.out)
    subprocess.run([sys.executable, ROOT / "benchmark/report/sweep_report.py", arguments.out / "results.json",
                    arguments.out / "report.html"], check=True)
    print(f"full_sweep: {(time.monotonic() - begin) / 60:.0f} minutes")


if __name__ == "__main__":
    main()
