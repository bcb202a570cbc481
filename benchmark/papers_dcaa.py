"""Decoupled Coverage Anti-Aliasing (Wang et al., I3D 2016): what is measured, and claims."""
import statistics

from papers_agaa import PHONG, sbaa
from papers_claims import (FAILS, HOLDS, PART, TIMES, Group, Plan, errors_claim, not_measured, of_scenes, ratios,
                           scene_claim, steps_claim, verdict_at_most, verdict_of_share)

SPP = 512  # of the paper's ground truth
TITLE = "Decoupled Coverage Anti-Aliasing (Wang et al., I3D 2016)"
TEXT = (f"64 coverage samples and S = 4, where a claim names nothing else. Errors are against {SPP} samples per pixel, "
        "each of which is shaded, with Blinn-Phong; the paper does not say of which values its errors are. \"Our rule\" is "
        "the default of `dcaa`: it merges from front to back, and counts the samples that surfaces show. \"Printed rule\" "
        "is algorithm 1 as printed, in the order of the draws: `--merge paper --draw-order`. `msaa` and `sbaa` have n = 8. "
        "The tier is `lists`, because software rasterisers have no fragment shader interlock: fragments are kept, in plans "
        "8 per pixel, until a pass merges them. Memory holds if surfaces and lists together keep to the paper's number, and "
        "in part if the surfaces do. Ratios of BAMBOO hold up to 5 % above the paper's, and in part below 1. \"Most\" is "
        "more than half, and a significant error more than 5 %. A sweet spot gains more over half its surfaces than twice "
        "its surfaces gain over it. \"Close\" holds in part if the error is nearer to the one than to that of 8x MSAA.")


def dcaa(s, *more):
    # With room for 48 fragments per pixel, scenes are drawn once. Images do not depend on it.
    return ["--technique", "dcaa", "--samples", 64, "--aggregates", s, "--fragments-per-pixel", 48, *more]


# ---- measured ----------------------------------------------------------------------------------

SURFACES = (1, 2, 4, 8)
REFERENCES = {"fine": ["reference", "--spp", SPP]}
GROUPS = {
    "dcaa": Group(PHONG, "fine", {
        **{f"dcaa {s}": dcaa(s) for s in SURFACES},
        "dcaa 4 paper": dcaa(4, "--merge", "paper", "--draw-order"),
        "dcaa 4 no second merge": dcaa(4, "--merge", "none", "--draw-order"),
        "dcaa 4 paper reverse": dcaa(4, "--merge", "paper", "--reverse-order"), "dcaa 4 color": dcaa(4, "--merge", "color"),
        "dcaa 4 prepass": dcaa(4, "--depth-prepass"), "dcaa exact": dcaa(4, "--exact"),
        "dcaa 4 packed": dcaa(4, "--layout", "dcaa28"),
        "msaa 8": ["--technique", "msaa", "--samples", 8], "sbaa 4": [*sbaa(4), "--samples", 8],
        "ssaa 8": ["--technique", "ssaa", "--samples", 8]}, ("dcaa 4", "dcaa 8", "dcaa exact")),
}

PACKED = ["--technique", "dcaa", "--samples", 64, "--aggregates", 4, "--layout", "dcaa28"]
PLANS = {"dcaa surfaces": Plan(PACKED, ("surfaces",)), "dcaa": Plan(PACKED, ("surfaces", "fragments"))}


# ---- claims ------------------------------------------------------------------------------------

def memory_claim(paper, least=None):
    """Bytes per pixel of four surfaces, with and without the lists. paper: the bytes that they must not exceed."""
    def found(data):
        surfaces, both = (data["bytesPerPixel"][name] for name in ("dcaa surfaces", "dcaa"))
        share = f", {100 * surfaces / least:.0f} and {100 * both / least:.0f} % of {least}" if least else ""
        return (f"surfaces {surfaces:.0f} bytes, with lists of fragments {both:.0f}{share}",
                HOLDS if both <= 1.05 * paper else PART if surfaces <= 1.05 * paper else FAILS)
    return found


def gigabytes_claim(data):
    bytes_ = 2 * data["bytesPerPixel"]["ssaa n=32"]
    ours = bytes_ * 1920 * 1080 / 2**30
    return (f"{ours:.1f} GB: twice the {bytes_ / 2:.0f} bytes per pixel of n = 32, the most that `ssaa` has",
            verdict_at_most(ours, 2))


def close_claim(data):
    """The error is nearer to the lower one if it is the smaller multiple of it."""
    ours, msaa = ratios(data, "dcaa", "dcaa 4", "dcaa exact"), ratios(data, "dcaa", "msaa 8", "dcaa 4")
    close, nearer = sum(a <= 1.25 for a in ours), sum(a < b for a, b in zip(ours, msaa))
    verdict = HOLDS if close == len(ours) else PART if 2 * nearer > len(ours) else FAILS
    return (f"our rule: error by that of 64 samples without merging: median {statistics.median(ours):.2f}, at most 1.25 in "
            f"{close} of {len(ours)} scenes; nearer to it than to 8x MSAA's in {nearer}", verdict)


def shown(data, row, bins):
    """Shares of the pixels that show geometry in these bins of shading events, which are surfaces that show."""
    rows = [scene["dcaa"][row] for scene in data["scenes"]]
    shares = [sum(found["byEvents"][bins]) / found["shaded"] for found in rows]
    return shares, ", ".join(f"{s['scene']} {100 * share:.0f} %" for s, share in zip(data["scenes"], shares))


def one_surface_claim(data):
    shares, text = shown(data, "dcaa 4", slice(0, 1))
    return f"pixels that show one surface: {text}", verdict_of_share(sum(share > 0.5 for share in shares), len(shares))


def more_surfaces_claim(data):
    """Bins of byEvents: 1, 2, 3 to 4, 5 to 8, … events."""
    shares, text = shown(data, "dcaa 8", slice(3, None))
    return (f"pixels that show more than 4 surfaces with S = 8: {text}",
            verdict_of_share(sum(share > 0 for share in shares), len(shares)))


def sweet_spot_claim(data):
    """The error falls by a larger factor from S = 2 to 4 than from S = 4 to 8."""
    before, after = ratios(data, "dcaa", "dcaa 4", "dcaa 2"), ratios(data, "dcaa", "dcaa 8", "dcaa 4")
    count = sum(a < b for a, b in zip(before, after))
    return (f"error of 4 by that of 2: median {statistics.median(before):.2f}, of 8 by that of 4: "
            f"{statistics.median(after):.2f}; 4 gains more in {count} of {len(before)} scenes",
            verdict_of_share(count, len(before)))


def four_events_claim(data):
    count = sum(sum(scene["dcaa"]["dcaa 4"]["byEvents"][3:]) for scene in data["scenes"])
    events, shaded = (sum(of_scenes(data, "dcaa", "dcaa 4", key)) for key in ("events", "shaded"))
    return (f"{count} pixels with more; the mean of those that show geometry is {events / shaded:.2f}",
            HOLDS if count == 0 else FAILS)


def order_claim(data):
    values = ratios(data, "dcaa", "dcaa 4 paper reverse", "dcaa 4 paper")
    return (f"printed rule: error from the last draw to the first by that from the first: {min(values):.2f} to {max(values):.2f}",
            HOLDS if all(value != 1 for value in values) else PART if any(value != 1 for value in values) else FAILS)


def table_claims():
    """The errors of table 1. The paper prints 0.31 to 0.99 for DCAA by 8x MSAA, and 0.21 to 0.96 by SBAA."""
    for rule, row in (("our rule", "dcaa 4"), ("printed rule", "dcaa 4 paper")):
        for base, name, paper in (("msaa 8", "8x MSAA", "0.31 to 0.99"), ("sbaa 4", "SBAA with S = 4", "0.21 to 0.96")):
            yield ("table 1, 5.1", f"in all scenes the error is below that of {name}: {paper} of it",
                   errors_claim("dcaa", row, base, f"{rule}: error by that of `{base.split()[0]}`"))


CLAIMS = [
    *table_claims(),
    ("table 1", "in all scenes 8x MSAA has a lower error than SBAA with S = 4",
     errors_claim("dcaa", "msaa 8", "sbaa 4", "error by that of `sbaa`")),
    *(("table 1", f"BAMBOO: {paper} of the error of {name}",
       scene_claim("bamboo", "dcaa", "dcaa 4", base, "our rule: ratio", 1.05 * paper))
      for base, name, paper in (("msaa 8", "8x MSAA", 0.35), ("sbaa 4", "SBAA with S = 4", 0.21))),
    ("figure 7, 5.1", "quality is similar to that of the ground truth, and close to 64x supersampling", close_claim),
    ("figure 8, 5.2", "more surfaces lower the error",
     steps_claim("dcaa", [f"dcaa {s}" for s in SURFACES],
                 "S = " + ", ".join(map(str, SURFACES)) + ": error by that of the number before")),
    ("figure 8, 5.2", "4 surfaces are a sweet spot", sweet_spot_claim),
    ("figure 9, 5.2", "most of the scene needs one surface per pixel", one_surface_claim),
    ("figure 9, 3.3, 5.2", "complex regions need more than 4 surfaces", more_surfaces_claim),
    ("figure 8, 5.2", "normals of two 16-bit numbers and a depth of 24 bits do not lower the quality significantly",
     errors_claim("dcaa", "dcaa 4 packed", "dcaa 4", "error with the layout \"dcaa28\" by that of \"precise\"", 1.05)),
    ("5.3", "at most 4 shading events per pixel", four_events_claim),
    ("figures 4 and 5, 3.3", "the second merge reduces leaks of the background",
     errors_claim("dcaa", "dcaa 4 paper", "dcaa 4 no second merge",
                  "printed rule: error by that without the second merge")),
    ("5.2", "the method depends on the order of the fragments", order_claim),
    ("5.3", "discards that know materials may lower the error",
     errors_claim("dcaa", "dcaa 4 color", "dcaa 4", "our rule: error with `--merge color` by that without")),
    ("figure 4, 3.3", "never discarding the closest surface avoids aliasing of fine details",
     not_measured("no option of the SDK discards the closest surface")),
    ("figure 10 (d), 5.4", "a z-prepass of 8 samples is not conservative: the background can leak",
     errors_claim("dcaa", "dcaa 4", "dcaa 4 prepass",
                  "our rule: error without our prepass, which fills gaps of the coverage, by that with it")),
    ("figure 6, 4.3", "112 bytes per pixel for four surfaces with 64 samples", memory_claim(112)),
    ("4.3, 6", "less memory than 8x MSAA with 128 bytes per pixel", memory_claim(127, 128)),
    ("4.3, 5.1", "11 % of the memory of 64x supersampling with 1024 bytes per pixel", memory_claim(0.11 * 1024, 1024)),
    ("1", "64x MSAA with deferred shading takes 2 GB at 1920x1080", gigabytes_claim),
    ("table 1", "9.8 to 52.9 ms per frame, and 582 ms for TENTACLES", not_measured(TIMES)),
    ("4.2", "the z-prepass is vital for performance", not_measured(TIMES)),
    ("5.4", "frames are faster by an order of magnitude without conservative rasterisation or interlock",
     not_measured("the software rasterisers have neither")),
]
