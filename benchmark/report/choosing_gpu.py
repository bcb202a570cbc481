"""Frames of a GPU (benchmark/gpu_run.py) beside those of a sweep, and which claims hold on which device."""

from gpu_frames import gpu_frames
from markdown_table import escaped, fixed, paragraph
from sweep_rows import frame, rows_of

RIVAL = ("ssaa", 8, 0, "", "", "")
SIMPLE = ("simple_complex", 8, 0, "", "", "")
TWO_PASSES = ("agaa", 8, 2, "", "post-depth-atomics", "")
FROM_GBUFFER = ("agaa", 8, 2, "", "gbuffer", "")
BY_ID = ("agaa", 8, 2, "", "ids", "")
ACCURATE = ("agaa", 8, 0, "accurate", "ids", "")
SBAA = ("sbaa", 8, 2, "", "post-depth-atomics", "")
DCAA = ("dcaa", 64, 4, "", "lists", "")
DCAA_COMPUTE = ("dcaa", 64, 4, "", "lists", "compute")
# Technique, n, c or S, preset, tier of generation, and way; and the row's name here.
ROWS = {
    ("single", 1, 0, "", "", ""): "single",
    RIVAL: "ssaa n=8",
    SIMPLE: "simple_complex n=8",
    ("msaa", 8, 0, "", "", ""): "msaa n=8",
    SBAA: "sbaa n=8 S=2",
    TWO_PASSES: "agaa n=8 c=2",
    FROM_GBUFFER: "agaa n=8 c=2 from a G-buffer",
    BY_ID: "agaa n=8 c=2 by id",
    ACCURATE: "agaa n=8 accurate by id",
    DCAA: "dcaa n=64 S=4",
    DCAA_COMPUTE: "dcaa n=64 S=4, triangles by compute passes",
}
MARGIN = 0.97  # frames of more than this share of another count as a tie
# A claim: two rows, and the largest ratio of their frames that it allows.
CLAIMS = [
    ("`agaa` c=2 by id is faster than `ssaa` n=8", BY_ID, RIVAL, MARGIN),
    ("`agaa` c=2 by id is faster than `simple_complex` n=8", BY_ID, SIMPLE, MARGIN),
    ("`agaa` c=2 by id is faster than from a G-buffer", BY_ID, FROM_GBUFFER, MARGIN),
    ("`agaa` accurate by id is faster than `ssaa` n=8", ACCURATE, RIVAL, MARGIN),
    ("`simple_complex` n=8 is faster than `ssaa` n=8", SIMPLE, RIVAL, MARGIN),
    ("`agaa` c=2 with two geometry passes is faster than `sbaa` S=2", TWO_PASSES, SBAA, MARGIN),
    ("`dcaa` takes at most 1.5 times as long as `ssaa` n=8", DCAA, RIVAL, 1.5),
    ("`dcaa`, triangles by compute passes, takes at most 1.5 times as long as `ssaa` n=8", DCAA_COMPUTE, RIVAL, 1.5),
]


def sweep_frames(scenes):
    """Milliseconds by scene and row. Presets choose c themselves."""
    return {scene["name"]: {(row["technique"], row["n"], 0 if row["preset"] else row["c"], row["preset"],
                             (row["tiers"] or {}).get("generation", ""), ""): frame(row) for row in rows_of(scene)}
            for scene in scenes}


def by_scene(frames):
    """Milliseconds by scene and row."""
    found = {}
    for each in frames:
        key = (each["technique"], each["n"], each["c"], each["preset"], each["tier"], each["way"])
        found.setdefault(each["scene"], {})[key] = each["ms"]
    return found


def held(frames, scenes, claim):
    """In how many of how many scenes the claim holds on a device, or a dash."""
    _, first, second, limit = claim
    ratios = [frames[scene][first] / frames[scene][second] for scene in scenes
              if first in frames[scene] and second in frames[scene]]
    return f"{sum(each <= limit for each in ratios)} of {len(ratios)}" if ratios else "–"


def lines(measured, backend, size, gpus):
    """backend: its results in the sweep. gpus: the contents of their passes.json."""
    here = sweep_frames(measured)
    device = escaped(backend["device"])
    text = []
    for gpu in filter(None, (gpu_frames(passes, backend["backend"]) for passes in gpus)):
        there = by_scene(gpu["frames"])
        scenes = [scene for scene in there if RIVAL in there[scene] and RIVAL in here.get(scene, {})]
        if not scenes:
            continue
        text += [f"### Beside {escaped(gpu['device'])}, {gpu['size']}", "",
                 f"Frames by those of `ssaa` n=8 of the same scene and device, the GPU's first, then those of {device}, {size}. "
                 "The GPU's are sums of the passes; its build was not recorded.", ""]
        by_row = [[escaped(label), *(" / ".join(
            fixed(frames[scene][row] / frames[scene][RIVAL]) if row in frames[scene] else "–" for frames in (there, here))
            for scene in scenes)] for row, label in ROWS.items()]
        text += paragraph(["row", *scenes], by_row, "lr")
        text += [f"In how many scenes a claim holds, of those in the table in which its rows were measured. “Faster” is by more than "
                 f"{100 * (1 - MARGIN):.0f} %.", ""]
        text += paragraph(["claim", escaped(gpu["device"]), device],
                          [[claim[0], *(held(frames, scenes, claim) for frames in (there, here))] for claim in CLAIMS], "lr")
    return text
