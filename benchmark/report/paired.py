"""Ratios of two rows' times, turn by turn: changes of a device's speed between turns cancel."""

import statistics
from math import comb

from markdown_table import MISSING


def bounds(values, wanted=0.95):
    """Two of the values between which the median lies with the wanted confidence, whatever their distribution.

    The number of values below the median has a binomial distribution. If there are too few values, the outermost two
    are returned.
    """
    values, n = sorted(values), len(values)
    outside = 0  # the number of values left out on either side
    while 2 * (outside + 1) + 1 < n and 1 - 2 * sum(comb(n, k) for k in range(outside + 2)) / 2**n >= wanted:
        outside += 1
    return values[outside], values[n - 1 - outside]


def frames(row):
    return row["frameMs"].get("turns")


def shading(row):
    """Times of shading in each turn, or None without pass times. They include the classification of pixels, which may be
    in the same pass, but not the clustering of aggregates."""
    stages = ("shading", "definition") if row["technique"] == "simple_complex" else ("shading",)
    passes = [each["ms"] for each in row["passes"] if each["stage"] in stages]
    if not passes or any(not ms or "turns" not in ms for ms in passes):
        return None
    return [sum(turn) for turn in zip(*(ms["turns"] for ms in passes))]


def ratios(a, b, times=frames):
    """The ratio of each turn that both rows have; empty if there is none. Heavier rows have pass times of fewer turns."""
    pairs = zip(times(a) or [], times(b) or []) if a and b else []
    return [one / other for one, other in pairs if other > 0]


def shown(values):
    if not values:
        return MISSING
    low, high = bounds(values)
    return f"{statistics.median(values):.2f} ({low:.2f} to {high:.2f})"
