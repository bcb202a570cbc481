"""Presets in a sweep: their costs and errors, and whether the most accurate one reaches its aims."""

import statistics

from markdown_table import fixed, span
from sweep_rows import error, find, frame, materials, mean, ratio, rows_of

PRESETS = [("paper", 8, None)]
PRESETS += [(preset, 8, by) for preset in ("fast", "balanced", "accurate") for by in ("gbuffer", "ids")]
PRESETS += [("accurate", 32, by) for by in ("gbuffer", "ids")]


def preset_row(scene, preset, n, by):
    for row in rows_of(scene):
        if (row["preset"], row["n"], materials(row)) == (preset, n, by):
            return row
    return None


def merge_share(scene, row):
    """The error that aggregation adds, as a multiple of single's error."""
    return ratio(row["errorSameSamples"]["mseTm"], error(find(scene, "single", 1)))


def beside_ssaa(scene, row):
    """The error as a multiple of that of ssaa with the same n; 1 if the reference cannot distinguish them."""
    other = error(find(scene, "ssaa", row["n"]))
    return 1.0 if abs(error(row) - other) < 10 * scene["reference"]["splitHalfMseTm"] else ratio(error(row), other)


def preset_figures(scenes):
    """Figures of each preset over the scenes that have all presets of its n, and agaa c=2 with two passes to compare
    with."""
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
        out.append({"preset": preset, "n": n,
                    "materials": {None: "two passes", "gbuffer": "from a G-buffer", "ids": "by id"}[by],
                    "error": mean(shares), "median": statistics.median(shares),
                    "largest": f"{worst[0]:.3f} ({worst[1]})", "beside": span(beside), "events": mean(events),
                    "eventsByTwo": statistics.geometric_mean(ratio(own, two["eventsPerCoveredPixel"])
                                                             for own, two in zip(events, twos)),
                    "frameByTwo": statistics.geometric_mean(ratio(own, frame(two)) for own, two in zip(times, twos)),
                    "bytes": mean(sizes)})
    return out


def preset_rows(figures):
    return [[f["preset"], f["n"], f["materials"], f"{f['error']:.4f}", f"{f['median']:.4f}", f["largest"], f["beside"],
             f"{f['events']:.2f}", fixed(f["eventsByTwo"]), fixed(f["frameByTwo"]), f"{f['bytes']:.0f}"] for f in figures]


AIM = 0.005  # the mean error that the most accurate preset may add, as a share of single's error


def aim_sentences(scenes, figures):
    """Sentences about the aims of the most accurate preset."""
    lines = []
    for f in figures:
        if f["preset"] != "accurate":
            continue
        met, missed = [], []
        for is_met, text in ((f["error"] <= AIM, f"error at most {AIM} ({f['error']:.4f}, median {f['median']:.4f})"),
                            (f["eventsByTwo"] <= 1, f"no more events than c=2 ({f['eventsByTwo']:.2f})"),
                            (f["frameByTwo"] <= 1, f"no longer frame ({f['frameByTwo']:.2f})")):
            (met if is_met else missed).append(text)
        lines.append(f"* `accurate` n={f['n']} {f['materials']} was to have: " + "; ".join(
            f"{', '.join(of)}: {verdict}" for of, verdict in ((met, "it has"), (missed, "it has not")) if of) + ".")
    steady = steady_sentence(scenes)
    return lines + ([steady] if steady else [])


def steady_sentence(scenes):
    """Compares bias and variance of the most accurate preset under sub-pixel shifts with those of the paper's settings."""
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
