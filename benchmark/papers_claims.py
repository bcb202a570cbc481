"""Shared by the sections of docs/papers.md: what they measure, and the rules of the verdicts.

A claim is a tuple: its place in the paper, the claim, and a function of the results that returns what we found and the
verdict. The results are those of `papers.py measure`:

    size           "WxH" in pixels
    device         name of the device
    bytesPerPixel  {plan: bytes per pixel of the counted resources}
    scenes         [{"scene": name, group: {row: numbers}}]
    note           a sentence for the page, if there is one

Numbers of a row are "mseTm", a mean square of tone-mapped colours in [0, 1], and "events", the shading events of the
frame. Some rows also have "byEvents", the pixels with 1, 2, 3 to 4, 5 to 8, 9 to 16 and more events, "shaded", the
pixels that show geometry, and "visible", the samples that do.
"""
import math
import statistics
import typing

HOLDS, PART, FAILS, UNMEASURED = "holds", "holds in part", "does not hold here", "cannot be measured here"
TIMES = "software rasterisers' times say nothing of a GPU's"


class Group(typing.NamedTuple):
    """Rows that are compared with the same reference image of each scene."""
    options: list  # of all rows and of the reference
    reference: str  # key in REFERENCES of a section
    rows: dict  # {name: options}
    counted: tuple = ()  # names of the rows whose pixels by events are kept


class Plan(typing.NamedTuple):
    """A plan, and how the names of the resources begin whose bytes count."""
    options: list
    counted: tuple


def of_scenes(data, group, row, key="mseTm"):
    """One number for each scene."""
    return [scene[group][row][key] for scene in data["scenes"]]


def ratios(data, group, row, base, key="mseTm"):
    """The row's number by the base's, for each scene."""
    return [a / b for a, b in zip(of_scenes(data, group, row, key), of_scenes(data, group, base, key))]


def total_ratio(data, group, row, base, key="events"):
    """The row's sum over all scenes by the base's."""
    return sum(of_scenes(data, group, row, key)) / sum(of_scenes(data, group, base, key))


# ---- verdicts ----------------------------------------------------------------------------------

def verdict_of_share(count, total):
    """A claim about each scene holds if all scenes agree, and in part if more than half do."""
    return HOLDS if count == total else PART if 2 * count > total else FAILS


def verdict_at_most(ours, paper):
    """A number that the paper calls low holds up to 5 % above it, and in part up to 25 % above it."""
    return HOLDS if ours <= 1.05 * paper else PART if ours <= 1.25 * paper else FAILS


def verdict_of_saving(ours, paper):
    """Percent of memory saved hold down to 2 below the paper's, and in part if anything is saved."""
    return HOLDS if ours >= paper - 2 else PART if ours > 0 else FAILS


def verdict_of_decibels(ours, paper):
    """Decibels hold down to 1 below the paper's, and in part down to 6 below them, which is twice its error."""
    return HOLDS if ours >= paper - 1 else PART if ours >= paper - 6 else FAILS


# ---- claims ------------------------------------------------------------------------------------

def errors_claim(group, row, base, what, limit=1):
    """The row's error is below the base's, or below the limit times it."""
    def found(data):
        values = ratios(data, group, row, base)
        count = sum(value < limit for value in values)
        return (f"{what}: median {statistics.median(values):.2f}, below {limit} in {count} of {len(values)} scenes",
                verdict_of_share(count, len(values)))
    return found


def same_claim(group, row, base, what):
    """The row's error differs from the base's by less than 0.1 %."""
    def found(data):
        values = ratios(data, group, row, base)
        count = sum(abs(value - 1) < 0.001 for value in values)
        return (f"{what}: median {statistics.median(values):.3f}, the same in {count} of {len(values)} scenes",
                verdict_of_share(count, len(values)))
    return found


def steps_claim(group, rows, what):
    """The error falls with each step from row to row."""
    def found(data):
        steps = [ratios(data, group, after, before) for before, after in zip(rows, rows[1:])]
        count = sum(all(value < 1 for value in scene) for scene in zip(*steps))
        medians = ", ".join(f"{statistics.median(values):.2f}" for values in steps)
        return (f"{what}: medians {medians}; all below 1 in {count} of {len(data['scenes'])} scenes",
                verdict_of_share(count, len(data["scenes"])))
    return found


def scene_claim(name, group, row, base, what, limit=1):
    """In one scene, the row's error is below the base's times the limit; above 1 a claim of less holds in part."""
    def found(data):
        scene = next((s for s in data["scenes"] if s["scene"] == name), None)
        if not scene:
            return f"{name} was not measured", UNMEASURED
        ratio = scene[group][row]["mseTm"] / scene[group][base]["mseTm"]
        return f"{what} in {name}: {ratio:.2f}", HOLDS if ratio < limit else PART if ratio < 1 else FAILS
    return found


def share_claim(group, row, base, at_most, name):
    """The row has at most this share of the base's shading events."""
    def found(data):
        share = total_ratio(data, group, row, base)
        return (f"{100 * share:.0f} % of the events of {name} over all scenes",
                HOLDS if share <= at_most else FAILS)
    return found


def decibels(mse):
    """Decibels of a peak of 255 with colours in [0, 1], as the paper on adaptive supersampling has them."""
    return 10 * math.log10(255**2 / max(mse, 1e-12))


def not_measured(reason):
    return lambda data: (reason, UNMEASURED)
