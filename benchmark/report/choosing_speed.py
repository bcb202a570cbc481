"""Ratios of simple_complex to agaa c=2: events, shading, frames, and the shading cost from which agaa wins."""

import math

from markdown_table import fixed, span
from sweep_rows import find, frame, ratio

DENSE = ["bamboo", "foliage", "furball", "metal", "sh3d_foliage"]
PAPER_EFFICIENCY = 0.64  # 2.84 of 4.42
PAPER_SOURCE = "from AGAA's table 1 and the slides' counts, Old City"


def shading(row, grouping=False):
    """The time of shading, or None without pass times. grouping: include the clustering of aggregates.

    The classification of pixels always counts, because it may be in the same pass.
    """
    times = row["stageMs"] or {}
    if not times.get("shading"):
        return None
    return times["shading"] + (times.get("definition", 0) if grouping or row["technique"] == "simple_complex" else 0)


def ratios(scene, n, by=None, cost=1):
    """Ratios of simple_complex to agaa c=2 for events, shading time and frame, or None."""
    a = find(scene, "simple_complex", n, cost=cost)
    b = find(scene, "agaa", n, 2, cost=cost, by=by)
    if a is None or b is None:
        return None
    events = ratio(a["eventsPerCoveredPixel"], b["eventsPerCoveredPixel"])
    times = ratio(shading(a), shading(b))
    return {"events": events, "shading": times, "efficiency": ratio(times, events), "frame": ratio(frame(a), frame(b)),
            "grouping": ratio(shading(a, True), shading(b, True))}


def win_cost(scene, n, by=None):
    """The largest measured shading cost of both, and the cost from which agaa's frame is shorter, or None.

    The second follows from the lines through the frames at the smallest and the largest cost. It is 0 if agaa's frame
    is shorter up to the largest cost, and infinite if it never is.
    """
    def rows(cost):
        return find(scene, "simple_complex", n, 0, cost), find(scene, "agaa", n, 2, cost, by)
    costs = [cost for cost in (1, 4, 16) if None not in rows(cost)]
    if len(costs) < 2 or costs[0] != 1:
        return None

    def line(one, heavy):
        slope = (frame(heavy) - frame(one)) / (costs[-1] - 1)
        return frame(one) - slope, slope
    a, b = map(line, rows(1), rows(costs[-1]))
    behind, gain = b[0] - a[0], a[1] - b[1]
    if gain <= 0:
        return costs[-1], 0.0 if behind < costs[-1] * gain else math.inf
    return costs[-1], max(behind / gain, 0.0)


def cost_text(scene, n, by=None):
    found = win_cost(scene, n, by)
    if found is None:
        return "not measured"
    largest, value = found
    return "any" if value <= 1 else f"{value:.1f}" if value <= largest else f"beyond {largest}"


def speed_rows(scenes):
    out = []
    for scene in scenes:
        for n in (8, 32):
            two, one, ids = (ratios(scene, n, by) for by in (None, "gbuffer", "ids"))
            if two is None:
                continue
            out.append([scene["name"] + (" (dense)" if scene["name"] in DENSE else ""), n,
                        fixed(two["events"]), fixed(two["shading"]), fixed(two["efficiency"]), fixed(two["grouping"]),
                        fixed(two["frame"]),
                        fixed(one and one["frame"]), fixed(ids and ids["frame"]), cost_text(scene, n),
                        cost_text(scene, n, "gbuffer"), cost_text(scene, n, "ids")])
    return out


def speed_sentences(scenes):
    lines = []
    for n in (8, 32):
        two = {s["name"]: r for s in scenes if (r := ratios(s, n))}
        one = {s["name"]: r for s in scenes if (r := ratios(s, n, "gbuffer"))}
        ids = {s["name"]: r for s in scenes if (r := ratios(s, n, "ids"))}
        if not two:
            continue
        dense = [two[s] for s in DENSE if s in two]
        lines.append(
            f"* At n={n}, simple\\_complex / agaa c=2: shading {span([r['shading'] for r in two.values()])}, "
            f"on the dense scenes {span([r['shading'] for r in dense])}; that is "
            f"{span([r['efficiency'] for r in two.values()])} of the ratio of their shading events "
            f"({PAPER_SOURCE}: {PAPER_EFFICIENCY}). Whole frame: {span([r['frame'] for r in two.values()])} with two "
            f"geometry passes, {span([r['frame'] for r in one.values()])} from a G-buffer, "
            f"{span([r['frame'] for r in ids.values()])} by id.")
    return lines
