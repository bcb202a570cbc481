"""Adaptive Supersampling for Deferred Anti-Aliasing (Holländer et al., JCGT 2013): what is measured, and claims."""
import statistics

from papers_claims import (FAILS, HOLDS, PART, TIMES, UNMEASURED, Group, decibels, errors_claim, not_measured, of_scenes,
                           ratios, total_ratio, verdict_at_most, verdict_of_decibels, verdict_of_share)

TITLE = "Adaptive Supersampling for Deferred Anti-Aliasing (Holländer et al., JCGT 2013)"
TEXT = ("Errors are against `ssaa`, which shades all samples of the same ordered grid. \"Printed rules\" are the paper's "
        "metric, order of samples and equal weights: `--printed-metric --in-order --equal-weights`, with our constants, "
        "because the paper does not print its own, which a user adapts to the scene. Verdicts are those of the printed rules. "
        "The decibels of the paper's table follow from its errors with a peak of 255, and so do ours. We take its colours to "
        "be in [0, 1], as our tone-mapped ones are, because in [0, 255] its errors would be one step in 20,000 values; a peak "
        "of 1 gives 48.13 dB less. Percentages are of the samples that show geometry. \"Roughly half\" is at most 60 %, and "
        "\"drastically\" at least 1.5 times. The printed metric knows no lights, so one verdict is of our defaults: with "
        "`--compare-light --adaptive-gloss-weight 0` they compare the light of samples, without shadows, in place of a weight "
        "of glossy normals.")

PRINTED = ["--technique", "adaptive", "--printed-metric", "--in-order", "--equal-weights"]
IDS = ["--technique", "adaptive", "--tier", "generation=ids"]
SIDES = (2, 3, 4)
AT_3 = {  # further rows of the 3x3 grid
    "geometry": [*PRINTED, "--metrics", "geometry"], "shading": [*PRINTED, "--metrics", "shading"],
    "tile maximum": [*PRINTED, "--tile-maximum"],
    "light": ["--technique", "adaptive", "--compare-light", "--adaptive-gloss-weight", 0],
    "ids": IDS, "ids sample footprints": [*IDS, "--sample-footprints"],
    "single": ["--technique", "single"], "fxaa": ["--technique", "fxaa"]}


def grid(m):
    rows = {"paper": PRINTED, "default": ["--technique", "adaptive"], **(AT_3 if m == 3 else {})}
    return Group(["--samples", m * m], f"grid {m}x{m}", rows, ("paper", "default"))


REFERENCES = {f"grid {m}x{m}": ["render", "--technique", "ssaa", "--tier", "visibility=ordered-grid"] for m in SIDES}
REFERENCES["textures"] = ["reference", "--technique", "ssaa", "--samples", 8, "--spp", 512, "--footprint", "sample"]
GROUPS = {f"grid {m}x{m}": grid(m) for m in SIDES}
GROUPS["textures"] = Group([], "textures", {row: [*AT_3[row], "--samples", 9] for row in ("ids", "ids sample footprints")})


def mean_decibels(data, m, row):
    return statistics.mean(map(decibels, of_scenes(data, f"grid {m}x{m}", row)))


def mean_share(data, m, row):
    """Mean over the scenes of the samples that are shaded, in percent."""
    return 100 * statistics.mean(ratio(scene[f"grid {m}x{m}"][row]) for scene in data["scenes"])


def ratio(row):
    return row["events"] / row["visible"]


def decibels_claim(m, paper):
    def found(data):
        ours, default = (mean_decibels(data, m, row) for row in ("paper", "default"))
        errors = of_scenes(data, f"grid {m}x{m}", "paper")
        return (f"printed rules: mean error {statistics.mean(errors):.1e}, mean {ours:.1f} dB, worst scene "
                f"{decibels(max(errors)):.1f} dB; our defaults: mean {default:.1f} dB",
                verdict_of_decibels(ours, paper))
    return found


def samples_claim(m, paper):
    def found(data):
        ours, default = (mean_share(data, m, row) for row in ("paper", "default"))
        return f"printed rules: {ours:.0f} %; our defaults: {default:.0f} %", verdict_at_most(ours, paper)
    return found


def half_claim(data):
    """Roughly half is at most 60 %. Each grid counts."""
    shares = [mean_share(data, m, "paper") for m in SIDES]
    return (", ".join(f"{share:.0f} %" for share in shares) + " of the samples of the three grids",
            verdict_of_share(sum(share <= 60 for share in shares), len(shares)))


def both_metrics_claim(data):
    """The error with both metrics is at most that of the better one alone."""
    alone = zip(ratios(data, "grid 3x3", "paper", "geometry"), ratios(data, "grid 3x3", "paper", "shading"))
    values = [max(pair) for pair in alone]
    count = sum(value <= 1 for value in values)
    return (f"error with both by the lower one of each alone: median {statistics.median(values):.2f}, at most 1 in {count} "
            f"of {len(values)} scenes", verdict_of_share(count, len(values)))


def footprints_claim(data):
    """Counts the scenes that have textures, whose images differ."""
    texts, shares = [], []
    for group, reference in (("grid 3x3", "all samples with textures over a pixel"), ("textures", "512 samples with textures over each")):
        values = [value for value in ratios(data, group, "ids", "ids sample footprints") if value != 1]
        if not values:
            return "the scenes have no textures", UNMEASURED
        shares.append(sum(value < 1 for value in values) / len(values))
        texts.append(f"median {statistics.median(values):.2f} beside {reference}")
    return ("our defaults by id: error by that with filters over one sample: " + ", ".join(texts),
            HOLDS if min(shares) == 1 else PART if max(shares) > 0.5 else FAILS)


def leaks_claim(data):
    """The paper gives no factor: 1.5 counts as drastic, and any increase in part."""
    factor = total_ratio(data, "grid 3x3", "tile maximum", "paper")
    return (f"{factor:.2f} times the shading events with blocks of 8 by 8 pixels",
            HOLDS if factor >= 1.5 else PART if factor > 1 else FAILS)


def light_claim(data):
    """Of our defaults, because the printed metric takes no light."""
    text, verdict = errors_claim("grid 3x3", "light", "default", "our defaults: error with light in place of gloss by that without")(data)
    events = total_ratio(data, "grid 3x3", "light", "default")
    return f"{text}; {100 * events:.0f} % of the shading events", verdict


# Grid, MSE, decibels and percent of samples shaded of the paper's table 1.
TABLE = [(2, "5.0e-5", 91.14, 57.8), (3, "3.08e-5", 93.24, 53.40), (4, "3.79e-5", 92.34, 53.14)]
CLAIMS = [
    *(("table 1", f"{m}x{m}: mean squared error of {mse}, {db} dB", decibels_claim(m, db)) for m, mse, db, _ in TABLE),
    *(("table 1", f"{m}x{m}: {share} % of the samples are shaded", samples_claim(m, share)) for m, _, _, share in TABLE),
    ("5", "the metrics reduce the samples to shade roughly by half", half_claim),
    ("figures 7 and 8", "the result is nearer to 3x3 supersampling than one sample per pixel is",
     errors_claim("grid 3x3", "paper", "single", "printed rules: error by that of `single`")),
    ("figure 8", "it is nearer than one sample per pixel with FXAA is",
     errors_claim("grid 3x3", "paper", "fxaa", "printed rules: error by that of `fxaa`")),
    ("figure 8, 5", "the geometric metric captures small geometry that the shading metric misses",
     errors_claim("grid 3x3", "geometry", "shading", "3x3: error with the geometric metric alone by that of the other")),
    ("3.1", "the two metrics are orthogonal, so that both together find more than each alone", both_metrics_claim),
    ("figure 5, 4.1", "anisotropic filters over the area that a sample represents avoid texture artefacts",
     footprints_claim),
    ("figure 6 (c), 4.2", "the largest count of each block increases the samples drastically", leaks_claim),
    ("6", "proposed as future work, without numbers: metrics that know light sources would improve shading near highlights", light_claim),
    ("4.2", "counts in the depth buffer are roughly 20 % slower than a loop", not_measured(TIMES)),
    ("4.2", "sorting pixels by their counts is three times slower", not_measured(TIMES)),
    ("table 1, 5", "frames take 0.88 to 0.90 of the time of shading all samples, 0.84 to 0.92 with costly shading",
     not_measured(TIMES)),
]
