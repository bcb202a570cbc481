#!/usr/bin/env python3
"""Runs `agaa-harness sweep` over the built-in scenes and the shared ones, on both backends, and prints the time.

Each scene is a process of its own, because drivers keep memory: below OUT/scenes. Their results and images are merged into
OUT. A run that is broken off goes on where it stopped when it is started again with the same --out. Nothing else should
run meanwhile: times are measured.
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import time

from runs import HARNESS, ROOT, find_scenes, require_harness

# Scenes that are hard come first, so that a run that is broken off has them.
FIRST = ["bamboo", "foliage", "furball", "metal", "sh3d_foliage"]
# Has emission and normal maps, too: effects where they are called for and where they are not.
PLAIN = "city"


def scenes(wanted):
    return sorted(find_scenes("full_sweep", wanted), key=lambda scene: (scene[0] not in FIRST, scene[0]))


def merge(folders, out):
    """Scenes of several sweeps with the same options into one, with their images."""
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
    (out / "results.json").write_text(json.dumps(merged, indent=1) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--harness", default=HARNESS, type=pathlib.Path)
    parser.add_argument("--out", default="sweep", type=pathlib.Path)
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--backend", action="append", choices=["vk", "gl"], help="repeatable; none: both")
    parser.add_argument("--scene", action="append", help="only these; repeatable")
    parser.add_argument("--rounds", help="frames of each row; none: the usual number, 101 suits a GPU")
    parser.add_argument("--row", action="append", help="only these, as of agaa-harness sweep; repeatable")
    parser.add_argument("--no-ablation", action="store_true", help="not what each effect costs and removes")
    parser.add_argument("--jpeg", help="images as JPEG of this quality, 1 to 100, not as PNG")
    arguments = parser.parse_args()
    require_harness("full_sweep", arguments.harness)
    common = [arguments.harness, "sweep", "--size", arguments.size]
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
