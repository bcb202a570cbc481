#!/usr/bin/env python3
"""Measures what AGAA_CONFIG_HDR_RESOLVE changes in the error of tone-mapped images.

The reference has the same weights, so that for grey light it is the mean of tone-mapped samples. Each row is rendered with
and without weights. OUT/hdr_resolve.json and OUT/hdr_resolve.md have the errors (mseTm, docs/sweep.md).
"""
from command_line import tool_parser
from markdown_table import paragraph
from runs import Runs, find_scenes, view_options, write_results

EXPOSURE = 1  # that of the sample engine's tone mapping
WEIGHTS = ["--hdr-resolve", "--exposure", EXPOSURE]
ROWS = {"ssaa 8": ["--technique", "ssaa", "--samples", 8],
        "msaa 8": ["--technique", "msaa", "--samples", 8],
        "agaa 8, 2 aggregates, G-buffer": ["--technique", "agaa", "--samples", 8, "--tier", "generation=gbuffer"],
        "agaa 64, fragments": ["--technique", "agaa", "--samples", 64, "--tier", "generation=fragments"],
        "adaptive 8": ["--technique", "adaptive", "--samples", 8]}


def measure(runs, scene, size, spp):
    name, source, camera = scene
    options = [*view_options(source, camera, size), "--backend", "vk", "--no-validation"]
    reference, image = runs.work / f"{name}.exr", runs.work / "row.exr"

    def render_reference():
        runs.call("reference", *options, *WEIGHTS, "--spp", spp, "--exr", reference)
        return True

    def error(row, weights):
        done = runs.call("render", *options, *ROWS[row], *weights, "--frames", 1, "--exr", image)
        return {"device": done["device"], "mseTm": runs.call("compare", reference, image)["mseTm"]}

    runs.kept(f"{name}-reference", render_reference)
    found = {"scene": name, "errors": {}}
    for index, row in enumerate(ROWS):
        linear = runs.kept(f"{name}-{index}-linear", lambda: error(row, []))
        weighted = runs.kept(f"{name}-{index}-weighted", lambda: error(row, WEIGHTS))
        found["device"] = linear["device"]
        found["errors"][row] = {"linear": linear["mseTm"], "weighted": weighted["mseTm"]}
    return found


def cell(error):
    return f"{error['linear']:.2e} / {error['weighted']:.2e} ({error['weighted'] / error['linear']:.2f})"


def document(scenes, size):
    lines = ["# Resolve for high dynamic range", "",
             "Written by `benchmark/hdr_resolve.py`: errors of tone-mapped images (`mseTm`) without weights / with weights "
             f"(`AGAA_CONFIG_HDR_RESOLVE`, exposure {EXPOSURE}), and their ratio, against a reference with weights, at {size}, "
             f"on {scenes[0]['device']}.", ""]
    rows = [[scene["scene"], *(cell(scene["errors"][row]) for row in ROWS)] for scene in scenes]
    return "\n".join(lines + paragraph(["scene", *ROWS], rows, "lr")).rstrip() + "\n"


def main():
    parser = tool_parser(__doc__, out="hdr-resolve", size="320x180", scenes=True)
    parser.add_argument("--spp", default=64, type=int, help="samples per pixel of the references")
    arguments = parser.parse_args()
    runs = Runs("hdr_resolve", arguments.harness, arguments.out, {"size": arguments.size, "spp": arguments.spp})
    scenes = []
    for scene in find_scenes("hdr_resolve", arguments.scene):
        scenes.append(measure(runs, scene, arguments.size, arguments.spp))
        print(scene[0], "done", flush=True)
    write_results(arguments.out, "hdr_resolve", {"size": arguments.size, "spp": arguments.spp, "scenes": scenes},
                  document(scenes, arguments.size))
    print(f"Wrote {arguments.out / 'hdr_resolve.md'}")


if __name__ == "__main__":
    main()
