"""Streaming G-buffer compression (Kerzner and Salvi, HPG 2014), as the other papers describe it: what is measured, and claims."""
from papers_agaa import PHONG, agaa, sbaa
from papers_claims import Group, errors_claim

N = 32
TITLE = "Streaming G-buffer compression (Kerzner and Salvi, HPG 2014)"
TEXT = (f"Claims of the AGAA and DCAA papers on their nearest relative. `sgbc` has n = {N} coverage samples, `sbaa` and "
        f"`agaa` n = {N} and two geometry passes. Errors are against 512 samples per pixel, each of which is shaded, with "
        "Blinn-Phong. \"Our rule\" merges the cheapest pair in a full pixel; \"printed rule\" drops the fragment with the samples "
        "that it shows, in the order of the draws: `--merge paper --draw-order`. Its paper uses three surfaces.")


def sgbc(s, *more):
    return ["--technique", "sgbc", "--samples", N, "--aggregates", s, "--fragments-per-pixel", 48, *more]


def relative(options):
    return [*options, "--samples", N]


PRINTED = ["--merge", "paper", "--draw-order"]
GROUPS = {"sgbc": Group(PHONG, "fine", {
    **{f"sgbc {s}": sgbc(s) for s in (2, 3, 4)}, "sgbc 3 paper": sgbc(3, *PRINTED),
    **{f"sbaa {s}": relative(sbaa(s)) for s in (2, 3, 4)}, **{f"agaa {c}": relative(agaa(c)) for c in (2, 3)}})}

CLAIMS = [
    *(("AGAA, 2", f"it improves on SBAA; the paper names no error: it is lower with {s} surfaces",
       errors_claim("sgbc", f"sgbc {s}", f"sbaa {s}", "our rule: error by that of `sbaa`")) for s in (2, 3, 4)),
    ("AGAA, 2", "the same with 3 surfaces",
     errors_claim("sgbc", "sgbc 3 paper", "sbaa 3", "printed rule: error by that of `sbaa`")),
    ("DCAA, 3.3", "to drop fragments in full pixels can lead to light that leaks",
     errors_claim("sgbc", "sgbc 3", "sgbc 3 paper", "error of our rule, which drops none, by that of the printed one")),
    ("AGAA, 3.3", "aggregates need not be similar; the paper names no error: two have a lower one than two surfaces",
     errors_claim("sgbc", "agaa 2", "sgbc 2", "error by that of our rule")),
    ("AGAA, 3.3", "the same with three of both",
     errors_claim("sgbc", "agaa 3", "sgbc 3", "error by that of our rule")),
]
