#!/usr/bin/env python3
"""Measures claims of the papers, and prints docs/papers.md: the paper's number beside ours, with a verdict for each claim.

    benchmark/papers.py measure [--out FOLDER]     OUT/papers.json
    benchmark/papers.py page RESULTS.json          the page, on standard output

Each section of the page has a module: papers_agaa.py, papers_dcaa.py, papers_sgbc.py and papers_adaptive.py. Errors are mseTm of docs/sweep.md.
An interrupted run continues with the results in OUT/work.
"""
import argparse
import json
import pathlib
import sys

import papers_adaptive
import papers_agaa
import papers_dcaa
import papers_sgbc
from markdown_table import table
from runs import HARNESS, Runs, find_scenes, view_options, write_json

SECTIONS = [papers_agaa, papers_dcaa, papers_sgbc, papers_adaptive]
DEVICE = ["--backend", "vk", "--no-validation"]
FRAME = [*DEVICE, "--frames", 1, "--warmup", 0]


def from_sections(name):
    """A dictionary that each section has a part of."""
    return {key: value for section in SECTIONS for key, value in getattr(section, name, {}).items()}


GROUPS, REFERENCES, PLANS = (from_sections(name) for name in ("GROUPS", "REFERENCES", "PLANS"))


class Scene:
    """Measures the groups of one scene."""

    def __init__(self, runs, scene, size):
        self.runs, self.name = runs, scene[0]
        self.view = view_options(scene[1], scene[2], size)
        self.image = runs.work / "row.exr"

    def reference(self, group):
        """The image that the group's rows are compared with. It is rendered once."""
        command, *more = REFERENCES[group.reference]
        image = self.runs.work / f"{self.name}-{group.reference.replace(' ', '-')}.exr"
        frame = FRAME if command == "render" else DEVICE
        self.runs.kept(f"{image.stem}-reference",
                       lambda: bool(self.runs.call(command, *self.view, *group.options, *frame, *more, "--exr", image)))
        return image

    def row(self, group, options, counted):
        """Error and counters of one row; "byEvents" are pixels with 1, 2, 3 to 4, 5 to 8, 9 to 16 and more events."""
        done = self.runs.call("render", *self.view, *group.options, *FRAME, *options, "--exr", self.image)
        counters = done["counters"]
        found = {"mseTm": self.runs.call("compare", self.reference(group), self.image)["mseTm"],
                 "events": counters["shadingEvents"], "device": done["device"]}
        if counted:
            found |= {"byEvents": counters["pixelsByEvents"], "shaded": counters["shadedPixels"], "visible": counters["visible"]}
        return found

    def measure(self):
        found = {"scene": self.name}
        for name, group in GROUPS.items():
            found[name] = {row: self.runs.kept(f"{self.name}-{name}-{row}".replace(" ", "-"),
                                               lambda: self.row(group, options, row in group.counted))
                           for row, options in group.rows.items()}
            print(f"{self.name}, {name}", flush=True)
        return found


def plan_bytes(runs, plan):
    """Bytes per pixel of the resources of a plan that its paper counts."""
    resources = runs.call("plan", *plan.options, "--size", "1280x720")["resources"]
    return sum(r["bytes"] for r in resources if r["name"].startswith(plan.counted)) / (1280 * 720)


def take_device(scenes):
    """Removes the name of the device from all rows, and returns it. The device must be the same."""
    devices = {row.pop("device") for scene in scenes for group in scene.values() if isinstance(group, dict)
               for row in group.values()}
    if len(devices) != 1:
        sys.exit(f"papers: the rows are of several devices: {', '.join(sorted(devices))}")
    return devices.pop()


def measure(arguments):
    runs = Runs("papers", arguments.harness, arguments.out, {"size": arguments.size})
    scenes = [Scene(runs, scene, arguments.size).measure() for scene in find_scenes("papers", arguments.scene)]
    data = {"size": arguments.size, "device": take_device(scenes),
            "bytesPerPixel": {name: plan_bytes(runs, plan) for name, plan in PLANS.items()}, "scenes": scenes}
    write_json(arguments.out / "papers.json", data)
    print(f"Wrote {arguments.out / 'papers.json'}")


RULES = ("Verdicts follow from the numbers. A claim about all scenes holds if all of them agree, and in part if more than half "
         "do. Bytes and numbers of samples hold up to 5 % above the paper's, and in part up to 25 % above. A saving "
         "of memory holds down to 2 percentage points below the paper's, and in part if there is one. An error is close or "
         "similar to another if it is at most 1.25 times it, and the same if it differs by less than 0.1 %. Decibels hold "
         "down to 1 below the paper's, and in part down to 6 below. Times cannot be measured here, because those of software "
         "rasterisers say nothing of a GPU's.")


def page(data):
    lines = ["# Claims of the papers", "",
             "Written by `benchmark/papers.py` from `docs/results/lavapipe/papers.json`, which it measured on "
             f"{data['device']}: the scenes {', '.join(s['scene'] for s in data['scenes'])}, {data['size']}. Errors are "
             "mean squares after tone mapping. The papers' own scenes are not at hand."
             + (f" {data['note']}" if "note" in data else ""), "", RULES]
    for section in SECTIONS:
        lines += ["", f"## {section.TITLE}", "", section.TEXT, ""]
        lines += table(["place", "claim", "ours", "verdict"],
                       [[place, claim, *found(data)] for place, claim, found in section.CLAIMS])
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(dest="command", required=True)
    measuring = commands.add_parser("measure", help="renders the scenes and writes OUT/papers.json")
    measuring.add_argument("--harness", default=HARNESS, type=pathlib.Path, help="the program agaa-harness")
    measuring.add_argument("--out", default=pathlib.Path("papers"), type=pathlib.Path, help="folder of the results")
    measuring.add_argument("--size", default="320x180", help="WxH")
    measuring.add_argument("--scene", action="append", help="only this scene; repeatable")
    printing = commands.add_parser("page", help="prints the page")
    printing.add_argument("results", type=pathlib.Path)
    arguments = parser.parse_args()
    if arguments.command == "measure":
        measure(arguments)
        return
    try:
        text = page(json.loads(arguments.results.read_text()))
    except (OSError, KeyError, ValueError, IndexError, ZeroDivisionError) as problem:
        sys.exit(f"papers: {arguments.results}: no results of `papers.py measure`: {problem!r}")
    print(text, end="")


if __name__ == "__main__":
    main()
