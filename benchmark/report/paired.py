"""Ratios of two rows' times, turn by turn: what a device's speed does between turns cancels."""

import statistics
from math import comb


def bounds(values, wanted=0.95):
    """Two of the values between which the median lies with the confidence wanted, whatever their distribution, by the
    binomial distribution of how many lie below it; the outermost two where they are too few."""
    values, n = sorted(values), len(values)
    outside = 0  # how many on either side are left out
    while 2 * (outside + 1) + 1 < n and 1 - 2 * sum(comb(n, k) for k in range(outside + 2)) / 2**n >= wanted:
        outside += 1
    return values[outside], values[n - 1 - outside]


def frames(row):
    return row["frameMs"].get("turns")


def shading(row):
    """With the classification of pixels, which may be in the same pass; without the clustering of aggregates. None
    where passes are not timed."""
    stages = ("shading", "definition") if row["technique"] == "simple_complex" else ("shading",)
    passes = [each["ms"] for each in row["passes"] if each["stage"] in stages]
    if not passes or any(not ms or "turns" not in ms for ms in passes):
        return None
    return [sum(turn) for turn in zip(*(ms["turns"] for ms in passes))]


def ratios(a, b, times=frames):
    """Of each turn; empty where there is none to speak of. Heavier rows have passes of fewer turns."""
    pairs = zip(times(a) or [], times(b) or []) if a and b else []
    return [one / other for one, other in pairs if other > 0]


def shown(values):
    if not values:
        return "not measured"
    low, high = bounds(values)
    return f"{statistics.median(values):.2f} ({low:.2f} to {high:.2f})"
