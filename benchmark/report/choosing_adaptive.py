"""Compares adaptive with ssaa, simple_complex and agaa at the same n: error, flicker, events and frame times."""

from collections import Counter

import paired
from markdown_table import escaped, fixed, paragraph
from sweep_rows import error, find, frame, ratio, rows_of

COSTS = (1, 4, 16)
SAMPLES = 8


def adaptive(scene, cost=1):
    return next((row for row in rows_of(scene, cost) if (row["technique"], row["n"]) == ("adaptive", SAMPLES)), None)


def accurate(scene, cost=1):
    return next((row for row in rows_of(scene, cost)
                 if (row["technique"], row["preset"], row["n"]) == ("agaa", "accurate", SAMPLES)), None)


# The techniques that it is compared with.
RIVALS = [("`ssaa`", lambda scene, cost=1: find(scene, "ssaa", SAMPLES, 0, cost)),
          ("`simple_complex`", lambda scene, cost=1: find(scene, "simple_complex", SAMPLES, 0, cost)),
          ("`agaa` c=2 by id", lambda scene, cost=1: find(scene, "agaa", SAMPLES, 2, cost, "ids")),
          ("`agaa` accurate", accurate)]
ALL = [("`adaptive`", adaptive), *RIVALS]


def figures(scenes, figure, columns):
    """A table of figure(row) as a multiple of that of ssaa with the same n, and an empty line."""
    rows = []
    for scene in scenes:
        whole = find(scene, "ssaa", SAMPLES)
        rows.append([escaped(scene["name"])] + [fixed(ratio(figure(row), figure(whole)) if (row := pick(scene)) else None)
                                                for _, pick in columns])
    return paragraph(["scene"] + [title for title, _ in columns], rows)


def quickest(scene, cost):
    """The fastest of ssaa and the rows that the eye cannot distinguish from it: their error against ssaa of the same n is
    at most a tenth of the error of ssaa against the reference."""
    limit = 0.1 * error(find(scene, "ssaa", SAMPLES))
    picks = [(title, row) for title, pick in ALL if (row := pick(scene, cost))
             and (row["technique"] == "ssaa" or (row["errorSameSamples"] and row["errorSameSamples"]["mseTm"] <= limit))]
    return min(picks, key=lambda each: frame(each[1]))[0] if picks else "none"


def times(scenes):
    columns = [(f"{title}, cost {cost}", pick, cost) for cost in COSTS for title, pick in RIVALS
               if any(pick(scene, cost) for scene in scenes)]
    rows = [[escaped(scene["name"])] + [paired.shown(paired.ratios(pick(scene, cost), adaptive(scene, cost)))
                                        for _, pick, cost in columns] for scene in scenes]
    return paragraph(["scene"] + [title for title, *_ in columns], rows)


def wins(scenes):
    rows = []
    for cost in COSTS:
        measured = [scene for scene in scenes if adaptive(scene, cost)]
        picks = Counter(quickest(scene, cost) for scene in measured).most_common()
        rows.append([str(cost), ", ".join(f"{title} ({count})" for title, count in picks)])
    return paragraph(["lighting, times", "quickest (on how many scenes)"], rows)


def lines(measured):
    """The chapter about the scenes that have the rows; no lines if none has."""
    scenes = [scene for scene in measured if adaptive(scene) and find(scene, "ssaa", SAMPLES)]
    if not scenes:
        return []
    out = [f"### adaptive at n={SAMPLES}", "",
           "Quickest: of the techniques whose error against `ssaa` of the same n is at most a tenth of the error of `ssaa` against "
           "the reference. With cheap lighting, techniques that shade less win only if their other passes cost less.", ""]
    out += wins(scenes)
    out += ["Frame times by that of `adaptive`, turn by turn; above 1, `adaptive` is quicker. Cost: lighting is evaluated so many "
            "times.", ""] + times(scenes)
    out += ["Shading events by those of `ssaa`:", ""] + figures(scenes, lambda row: row["eventsPerCoveredPixel"], ALL[:1] + ALL[2:])
    out += ["Error against the reference by that of `ssaa`:", ""] + figures(scenes, error, ALL[:1] + ALL[2:])
    if all(adaptive(scene).get("temporal") for scene in scenes):
        for key, title in (("variance", "Variance"), ("biasSquared", "Squared bias")):
            out += [f"{title} while the camera moves by parts of a pixel, by that of `ssaa`:", ""]
            out += figures(scenes, lambda row, key=key: (row.get("temporal") or {}).get(key), ALL[:1] + ALL[2:])
    return out
