#!/usr/bin/env python3
"""Runs `agaa-harness sweep` over the built-in scenes and the shared ones, on both backends, and prints the time.

A run that is broken off goes on where it stopped when it is started again with the same --out. Nothing else should
run meanwhile: times are measured.
"""
import argparse
import pathlib
import subprocess
import sys
import time

from runs import HARNESS, find_scenes, require_harness

# What is hard comes first, so that a run that is broken off has it.
FIRST = ["bamboo", "foliage", "furball", "metal", "sh3d_foliage"]
# Has emission and normal maps, too: effects where they are called for and where they are not.
PLAIN = "city"


def scenes():
    every = sorted(find_scenes("full_sweep"), key=lambda scene: (scene[0] not in FIRST, scene[0]))
    return [f"{source}@{camera}" if camera else source for _, source, camera in every]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--harness", default=HARNESS, type=pathlib.Path)
    parser.add_argument("--out", default="sweep", type=pathlib.Path)
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--backend", action="append", choices=["vk", "gl"], help="repeatable; none: both")
    parser.add_argument("--rounds", help="frames of each row; none: the usual number, 101 suits a GPU")
    parser.add_argument("--row", action="append", help="only these, as of agaa-harness sweep; repeatable")
    parser.add_argument("--no-ablation", action="store_true", help="not what each effect costs and removes")
    parser.add_argument("--jpeg", help="images as JPEG of this quality, 1 to 100, not as PNG")
    arguments = parser.parse_args()
    require_harness("full_sweep", arguments.harness)
    command = [arguments.harness, "sweep", "--size", arguments.size, "--out", arguments.out]
    for backend in arguments.backend or ["vk", "gl"]:
        command += ["--backend", backend]
    if arguments.rounds:
        command += ["--rounds", arguments.rounds]
    if arguments.jpeg:
        command += ["--jpeg", arguments.jpeg]
    for row in arguments.row or []:
        command += ["--row", row]
    for scene in scenes():
        command += ["--scene", scene]
    command += ["--no-ablation"] if arguments.no_ablation else ["--plain", PLAIN]
    begin = time.monotonic()
    result = subprocess.run(command)
    print(f"full_sweep: {(time.monotonic() - begin) / 60:.0f} minutes")
    sys.exit(result.returncode)


if __name__ == "__main__":
    main()
