"""Frames of a GPU (benchmark/gpu_run.py) beside those of a sweep, and which claims hold on which device."""

from gpu_frames import gpu_frames
from markdown_table import escaped, fixed, paragraph
from sweep_rows import frame, rows_of

RIVAL = ("ssaa", 8, 0, "", "")
# Technique, n, c or S, preset, tier of generation; and the row's name here.
ROWS = {
    ("single", 1, 0, "", ""): "single",
    RIVAL: "ssaa n=8",
    ("simple_complex", 8, 0, "", ""): "simple_complex n=8",
    ("msaa", 8, 0, "", ""): "msaa n=8",
    ("sbaa", 8, 2, "", "post-depth-atomics"): "sbaa n=8 S=2",
    ("agaa", 8, 2, "", "post-depth-atomics"): "agaa n=8 c=2",
    ("agaa", 8, 2, "", "gbuffer"): "agaa n=8 c=2 from a G-buffer",
    ("agaa", 8, 2, "", "ids"): "agaa n=8 c=2 by id",
    ("agaa", 8, 0, "accurate", "ids"): "agaa n=8 accurate by id",
    ("dcaa", 64, 4, "", "lists"): "dcaa n=64 S=4",
}
BY_ID = ("agaa", 8, 2, "", "ids")
# A claim: two rows, and the largest ratio of their frames that it allows.
CLAIMS = [
    ("`agaa` c=2 by id is faster than `ssaa` n=8", BY_ID, RIVAL, 1),
    ("`agaa` c=2 by id is faster than `simple_complex` n=8", BY_ID, ("simple_complex", 8, 0, "", ""), 1),
    ("`agaa` c=2 by id is faster than from a G-buffer", BY_ID, ("agaa", 8, 2, "", "gbuffer"), 1),
    ("`agaa` accurate by id is faster than `ssaa` n=8", ("agaa", 8, 0, "accurate", "ids"), RIVAL, 1),
    ("`simple_complex` n=8 is faster than `ssaa` n=8", ("simple_complex", 8, 0, "", ""), RIVAL, 1),
    ("`agaa` c=2 with two geometry passes is faster than `sbaa` S=2", ("agaa", 8, 2, "", "post-depth-atomics"),
     ("sbaa", 8, 2, "", "post-depth-atomics"), 1),
    ("`dcaa` takes at most 1.5 times as long as `ssaa` n=8", ("dcaa", 64, 4, "", "lists"), RIVAL, 1.5),
]


def sweep_frames(scenes):
    """Milliseconds by scene and row. Presets choose c themselves."""
    return {scene["name"]: {(row["technique"], row["n"], 0 if row["preset"] else row["c"], row["preset"],
                             (row["tiers"] or {}).get("generation", "")): frame(row) for row in rows_of(scene)}
            for scene in scenes}


def by_scene(frames):
    """Milliseconds by scene and row."""
    found = {}
    for each in frames:
        key = (each["technique"], each["n"], each["c"], each["preset"], each["tier"])
        found.setdefault(each["scene"], {})[key] = each["ms"]
    return found


def held(frames, scenes, claim):
    """“In how many of how many scenes” the claim holds on a device, or a dash."""
    _, first, second, limit = claim
    ratios = [frames[scene][first] / frames[scene][second] for scene in scenes
              if first in frames[scene] and second in frames[scene]]
    return f"{sum(each <= limit for each in ratios)} of {len(ratios)}" if ratios else "–"


def lines(measured, device, size, gpus):
    """gpus: the contents of their passes.json."""
    here = sweep_frames(measured)
    text = []
    for passes in gpus:
        gpu = gpu_frames(passes)
        there = by_scene(gpu["frames"])
        scenes = [scene for scene in there if RIVAL in there[scene] and RIVAL in here.get(scene, {})]
        if not scenes:
            continue
        text += [f"### Beside {escaped(gpu['device'])}, {gpu['size']}", "",
                 f"Frames by those of `ssaa` n=8 of the same scene and device, the GPU's first, then those of {escaped(device)}, "
                 f"{size}. The GPU's are sums of the passes.", ""]
        by_row = [[escaped(label), *(" / ".join(
            fixed(frames[scene][row] / frames[scene][RIVAL]) if row in frames[scene] else "–" for frames in (there, here))
            for scene in scenes)] for row, label in ROWS.items()]
        text += paragraph(["row", *scenes], by_row, "lr")
        text += ["In how many of these scenes a claim holds:", ""]
        text += paragraph(["claim", escaped(gpu["device"]), escaped(device)],
                          [[claim[0], *(held(frames, scenes, claim) for frames in (there, here))] for claim in CLAIMS], "lr")
    return text
