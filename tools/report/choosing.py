#!/usr/bin/env python3
"""Writes docs/choosing.md: which technique, n and c for which scene and budget, from sweeps' results alone.

usage: choosing.py RESULTS.json [MORE.json ...] OUT.md

docs/sweep.md describes RESULTS.json. Where the most accurate row is asked for, errors that differ by less than
ten times the reference's own count as equal, and the fastest of them is named.
"""

import argparse
import json
import math
import statistics
import sys
from collections import Counter
from pathlib import Path

QUALITIES = [4, 10, 30]  # times less error than single has
BUDGETS = [2, 3, 4]      # times single's frame
MEMORY = [65, 130, 260]  # bytes per pixel: 8 a sample, and a little for lists of tiles
LOSS_SAMPLES = (4, 8, 16, 32)
DENSE = ["bamboo", "foliage", "furball", "metal", "sh3d_foliage"]
PAPER_EFFICIENCY = 0.64  # 2.84 of 4.42
PAPER_SOURCE = "from AGAA's table 1 and the slides' counts, Old City"


def name(row):
    text = row["technique"].replace("_", "\\_")
    if row["n"] > 1:
        text += f" n={row['n']}"
    if row["preset"]:
        text += f" {row['preset']}"
    elif row["c"]:
        text += f" {'S' if row['technique'] == 'sbaa' else 'c'}={row['c']}"
    return text + {"gbuffer": " from a G-buffer", "ids": " by id"}.get(way(row), "")


def way(row):
    """How an aggregating row comes by materials: "gbuffer", "ids", or None, by two passes."""
    tier = (row["tiers"] or {}).get("generation")
    return tier if tier in ("gbuffer", "ids") else None


def frame(row):
    return row["frameMs"]["median"]


def error(row):
    return row["errorReference"]["mseTm"]


def rows_of(scene, cost=1):
    return [row for row in scene["rows"] if row["shadingCost"] == cost]


def find(scene, technique, n, c=0, cost=1, by=None):
    """The row, or None. by: as way() tells; no row of a preset."""
    for row in rows_of(scene, cost):
        if (row["technique"], row["n"], row["c"], way(row)) == (technique, n, c, by) and not row["preset"]:
            return row
    return None


def fastest(rows):
    return min(rows, key=frame, default=None)


def most_accurate(scene, rows):
    """Of those that the reference cannot tell from the best, the fastest."""
    if not rows:
        return None
    least = min(error(row) for row in rows)
    margin = 10 * scene["reference"]["splitHalfMseTm"]
    return fastest([row for row in rows if error(row) <= least + margin])


def ratio(a, b):
    """None where there is none to speak of."""
    return a / b if a is not None and b else None


def shown(value):
    return "not measured" if value is None else f"{value:.2f}"


def cell(row, scene):
    if row is None:
        return "none"
    single = find(scene, "single", 1)
    share = ratio(error(row), error(single))
    return f"{name(row)} ({shown(ratio(frame(row), frame(single)))}x, {share:.3g}, {row['bytesPerPixel']:.0f} B)"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return lines + ["| " + " | ".join(str(value) for value in row) + " |" for row in rows] + [""]


def for_quality(scene, times):
    limit = error(find(scene, "single", 1)) / times
    return fastest([row for row in rows_of(scene) if error(row) <= limit])


def for_time(scene, times):
    limit = times * frame(find(scene, "single", 1))
    return most_accurate(scene, [row for row in rows_of(scene) if frame(row) <= limit])


def for_memory(scene, limit):
    return most_accurate(scene, [row for row in rows_of(scene) if row["bytesPerPixel"] <= limit])


# What is asked for, how it is asked, and the row that answers it.
QUESTIONS = [("The fastest for an error", "error 1/{} of single's", QUALITIES, for_quality),
             ("The most accurate in a time", "within {}x single's frame", BUDGETS, for_time),
             ("The most accurate in memory", "within {} B a pixel", MEMORY, for_memory)]


def by_scene(scenes, asked, limits, pick):
    return table(["scene"] + [asked.format(limit) for limit in limits],
                 [[s["name"]] + [cell(pick(s, limit), s) for limit in limits] for s in scenes])


def how_often(scenes):
    """Which rows answer each question, and on how many scenes."""
    lines = []
    for _, asked, limits, pick in QUESTIONS:
        for limit in limits:
            rows = [pick(scene, limit) for scene in scenes]
            picks = Counter("none" if row is None else name(row) for row in rows).most_common()
            lines.append([asked.format(limit), ", ".join(f"{text} ({times})" for text, times in picks)])
    return table(["budget", "what to take (on how many scenes)"], lines)


def shading(row, grouping=False):
    """None where passes have no times. grouping: with the clustering of aggregates. The classification of pixels always
    counts: it may be in the same pass."""
    times = row["stageMs"] or {}
    if not times.get("shading"):
        return None
    return times["shading"] + (times.get("definition", 0) if grouping or row["technique"] == "simple_complex" else 0)


def ratios(scene, n, by=None, cost=1):
    """simple_complex by agaa c=2: of events, shading time and frame; or None."""
    a = find(scene, "simple_complex", n, cost=cost)
    b = find(scene, "agaa", n, 2, cost=cost, by=by)
    if a is None or b is None:
        return None
    events = ratio(a["eventsPerCoveredPixel"], b["eventsPerCoveredPixel"])
    times = ratio(shading(a), shading(b))
    return {"events": events, "shading": times, "efficiency": ratio(times, events), "frame": ratio(frame(a), frame(b)),
            "grouping": ratio(shading(a, True), shading(b, True))}


def win_cost(scene, n, by=None):
    """The largest shading cost that both were measured at, and that from which agaa's frame is the shorter, by the
    lines through the least and the largest: 0 where it is up to the largest, infinite where it never is; None where
    they were not measured."""
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
                        shown(two["events"]), shown(two["shading"]), shown(two["efficiency"]), shown(two["grouping"]),
                        shown(two["frame"]),
                        shown(one and one["frame"]), shown(ids and ids["frame"]), cost_text(scene, n),
                        cost_text(scene, n, "gbuffer"), cost_text(scene, n, "ids")])
    return out


def merge_rows(scenes):
    out = []
    for scene in scenes:
        rows = [find(scene, "agaa", 8, 2), find(scene, "sbaa", 8, 2), find(scene, "sbaa", 8, 4)]
        if None in rows:
            continue
        agaa, two, four = (row["errorSameSamples"]["mseTm"] for row in rows)
        out.append([scene["name"], f"{agaa:.2e}", f"{two:.2e}", f"{four:.2e}", shown(ratio(agaa, two)),
                    "yes" if agaa <= 0.75 * two else "no", "yes" if agaa <= four else "no"])
    return out


def loss_rows(scenes):
    """Scene, and of each n the mean of FLIP and its 95th percentile, of simple_complex against ssaa."""
    out = []
    for scene in scenes:
        errors = [(find(scene, "simple_complex", n) or {}).get("errorSameSamples") for n in LOSS_SAMPLES]
        if any(errors):
            out.append([scene["name"]] + [f"{error['flip']:.4f}, {error['flipP95']:.4f}" if error else "not measured"
                                          for error in errors])
    return out


def count(rows, column, wanted="yes"):
    return sum(row[column] == wanted for row in rows)


def span(values):
    values = [value for value in values if value is not None]
    return f"{min(values):.2f} to {max(values):.2f}" if values else "not measured"


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


PRESETS = [("paper", 8, None)]
PRESETS += [(preset, 8, by) for preset in ("fast", "balanced", "accurate") for by in ("gbuffer", "ids")]
PRESETS += [("accurate", 32, by) for by in ("gbuffer", "ids")]


def preset_row(scene, preset, n, by):
    for row in rows_of(scene):
        if (row["preset"], row["n"], way(row)) == (preset, n, by):
            return row
    return None


def merge_share(scene, row):
    """What aggregation costs, by the error of single."""
    return ratio(row["errorSameSamples"]["mseTm"], error(find(scene, "single", 1)))


def beside_ssaa(scene, row):
    """How far from the reference, by how far ssaa of the same n is; 1 where the reference cannot tell them apart."""
    other = error(find(scene, "ssaa", row["n"]))
    return 1.0 if abs(error(row) - other) < 10 * scene["reference"]["splitHalfMseTm"] else ratio(error(row), other)


def mean(values):
    return sum(values) / len(values)


def preset_rows(scenes):
    """Means over the scenes that have all of the same n that any has, and agaa c=2 by two passes to set them beside."""
    out = []
    measured = [each for each in PRESETS if any(preset_row(s, *each) for s in scenes)]
    for preset, n, by in measured:
        whole = [s for s in scenes if find(s, "agaa", n, 2) and find(s, "ssaa", n)
                 and all(preset_row(s, *each) for each in measured if each[1] == n)]
        if not whole:
            continue
        rows, twos = [preset_row(s, preset, n, by) for s in whole], [find(s, "agaa", n, 2) for s in whole]
        shares = [merge_share(s, row) for s, row in zip(whole, rows)]
        beside = [beside_ssaa(s, row) for s, row in zip(whole, rows)]
        worst = max(zip(shares, (s["name"] for s in whole)))
        events, times, sizes = ([of(row) for row in rows] for of in (
            lambda row: row["eventsPerCoveredPixel"], frame, lambda row: row["bytesPerPixel"]))
        out.append([preset, n, {None: "two passes", "gbuffer": "from a G-buffer", "ids": "by id"}[by],
                    f"{mean(shares):.4f}", f"{statistics.median(shares):.4f}", f"{worst[0]:.3f} ({worst[1]})",
                    span(beside), f"{mean(events):.2f}",
                    shown(statistics.geometric_mean(ratio(own, two["eventsPerCoveredPixel"])
                                                    for own, two in zip(events, twos))),
                    shown(statistics.geometric_mean(ratio(own, frame(two)) for own, two in zip(times, twos))), f"{mean(sizes):.0f}"])
    return out


AIM = 0.005  # of single's error, that the most accurate preset may add in the mean


def aim_sentences(scenes, presets):
    """Whether the most accurate preset is what it was meant to be."""
    lines = []
    for preset, n, materials, error_mean, median, largest, *_, events, time, _ in presets:
        if preset != "accurate":
            continue
        met = [f"error at most {AIM}"] if float(error_mean) <= AIM else []
        missed = [] if met else [f"error at most {AIM} (median {median}, largest {largest})"]
        for text, value in (("no more events than c=2", events), ("no longer frame", time)):
            (met if float(value) <= 1 else missed).append(f"{text} ({value})")
        lines.append(f"* `accurate` n={n} {materials} was to have: " + "; ".join(
            f"{', '.join(of)}: {verdict}" for of, verdict in ((met, "it has"), (missed, "it has not")) if of) + ".")
    steady = steady_sentence(scenes)
    return lines + ([steady] if steady else [])


def steady_sentence(scenes):
    """What of bias and variance under parts of a pixel the most accurate preset has more of than the paper's settings."""
    more, within, known = [], 0, 0
    for scene in scenes:
        paper = preset_row(scene, "paper", 8, None)
        for by in ("gbuffer", "ids"):
            row = preset_row(scene, "accurate", 8, by)
            if None in (paper, row) or None in (paper["temporal"], row["temporal"]):
                continue
            for term in ("biasSquared", "variance"):
                a, b = row["temporal"][term], paper["temporal"][term]
                known += 1
                within += abs(a - b) < 10 * row["temporal"]["referenceMseTm"]
                if a > b:
                    more.append(f"{scene['name']} {a / b:.3f}")
    if not known:
        return None
    return (f"* Under shifts by parts of a pixel, bias² and variance of `accurate` n=8 by those of `paper`: "
            f"{'none' if not more else str(len(more))} of {known} above 1{' (' + ', '.join(more) + ')' if more else ''}; "
            f"{within} gaps are below ten times the references' own error, which counts as none.")


def document(sweeps):
    lines = ["# Which technique, which n and c", "",
             "Generated by `tools/report/choosing.py` from the results of `agaa-harness sweep` "
             f"({', '.join(sorted({results['size'] for results in sweeps}))}); docs/sweep.md says how they are "
             "measured. Errors are mean squares after tone "
             "mapping, against the reference. In brackets: frame time and error by those of `single`, bytes a pixel. "
             "A gap of less than ten times the reference's own error counts as none; then the faster row is named. "
             "Times, and what is chosen by them, are of the device named in a heading: `tools/full_sweep.py` measures "
             "yours. “Dense” are " + ", ".join(each.replace("_", "\\_") for each in DENSE) + ".", ""]
    for results, backend in ((results, backend) for results in sweeps for backend in results["backends"]):
        measured = [s for s in backend["scenes"] if not s.get("plain")]
        scenes = [s for s in measured if find(s, "single", 1)]
        if len(scenes) < len(measured):
            lines += ["Left out, without `single`, which others are set beside: " + ", ".join(
                      s["name"].replace("_", "\\_") for s in measured if s not in scenes) + ".", ""]
        if not scenes:
            continue
        speeds, merges = speed_rows(scenes), merge_rows(scenes)
        lines += [f"## {'Vulkan' if backend['backend'] == 'vk' else 'OpenGL'}: {backend['device']}, "
                  f"{backend['driver']}", ""]
        if results.get("rows"):
            lines += ["Of a full sweep's rows only these were measured: " + ", ".join(results["rows"]) + ".", ""]
        lines += speed_sentences(scenes)
        if merges:
            lines += [f"* What merging costs at n=8: agaa c=2 has at most 0.75 of the error of sbaa S=2 on "
                      f"{count(merges, 5)} of {len(merges)} scenes, at most that of sbaa S=4 on "
                      f"{count(merges, 6)}.", ""]
        lines += ["### In short", ""] + how_often(scenes)
        for title, asked, limits, pick in QUESTIONS:
            lines += [f"### {title}", ""] + by_scene(scenes, asked, limits, pick)
        if presets := preset_rows(scenes):
            lines += ["### Presets", "",
                      "Means over the scenes. Error: what aggregation adds, against `ssaa` of the same n, by the "
                      "error of `single`. “Error by ssaa's”, the least and the most over the scenes: the error "
                      "against the reference by that of `ssaa` of the same n. At 1, and where the gap counts as "
                      "none, shading every sample gains nothing; below 1 merged samples are nearer to the truth "
                      "than shaded ones, as where narrow highlights fall between samples. `paper` has the settings "
                      "of the paper's sections. “By c=2”: events and whole frames by those of `agaa` c=2 of the "
                      "same n with two geometry passes, geometric means.", ""]
            lines += table(["preset", "n", "materials", "error", "its median", "its largest", "error by ssaa's",
                            "events a covered pixel",
                            "events by c=2", "frame by c=2", "bytes a pixel"], presets)
            lines += aim_sentences(scenes, presets) + [""]
        lines += ["### simple\\_complex by agaa c=2", "",
                  "Ratios above 1 are for `agaa`. Shading is with the classification of pixels, and without `agaa`'s "
                  "clustering but where that is said. The last three columns: how many times heavier than with the "
                  "scene's own lights shading must be for `agaa` to have the shorter frame, by the lines through "
                  "the frames at 1 and at 16, or 4, times; “any”: it has it with these.", ""]
        lines += table(["scene", "n", "events", "shading", "shading by events", "shading with clustering", "frame, two passes",
                        "frame, from a G-buffer", "frame, by id", "wins from, two passes", "wins from, G-buffer",
                        "wins from, by id"], speeds)
        lines += ["### What merging costs at n=8", "", "Mean squares after tone mapping against `ssaa` n=8.", ""]
        lines += table(["scene", "agaa c=2", "sbaa S=2", "sbaa S=4", "agaa / sbaa S=2", "at most 0.75",
                        "at most sbaa S=4"], merges)
        if losses := loss_rows(scenes):
            lines += ["### What simple\\_complex loses", "",
                      "FLIP against `ssaa` at the same n: its mean, and what 95 % of the pixels lie below; its "
                      "thresholds are set so that these stay below 0.05.", ""]
            lines += table(["scene"] + [f"n={n}" for n in LOSS_SAMPLES], losses)
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description="Writes docs/choosing.md from sweeps' results.")
    parser.add_argument("results", type=Path, nargs="+")
    parser.add_argument("out", type=Path)
    arguments = parser.parse_args()
    try:
        sweeps = [json.loads(results.read_text(encoding="utf-8")) for results in arguments.results]
        arguments.out.write_text(document(sweeps).rstrip() + "\n", encoding="utf-8")
    except (OSError, json.JSONDecodeError) as problem:
        sys.exit(f"choosing: {problem}")
    except (KeyError, TypeError, AttributeError) as problem:
        named = ", ".join(map(str, arguments.results))
        sys.exit(f"choosing: {named}: not of a sweep, or of another schema: {problem!r}")


if __name__ == "__main__":
    main()
