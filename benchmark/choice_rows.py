"""The rows of a sweep that agaaChooseSettings chooses among."""
import dataclasses

from runs import ROOT

SWEEP = ROOT / "docs/results/lavapipe/sweep/results.json"

# The stages of passes that draw the scene; all other stages shade.
GEOMETRY = ("prepass", "definition", "generation")

# These need structs that hosts chain to AgaaConfig.
PRESETS_LEFT_OUT = {"paper", "lean", "exact", "device"}
# A still image does not show its errors in motion, and it needs motion vectors.
TECHNIQUES_LEFT_OUT = {"taa"}
TIERS_LEFT_OUT = {"material-lists"}


@dataclasses.dataclass(frozen=True)
class Candidate:
    technique: str
    samples: int
    aggregates: int  # 0: none
    preset: str      # "": none
    tier: str        # of generation; "": AUTO

    @property
    def name(self):
        parts = [self.technique, str(self.samples), self.preset or (str(self.aggregates) if self.aggregates else ""), self.tier]
        return "-".join(part for part in parts if part)


def candidate(row):
    return Candidate(row["technique"], row["n"], row["c"], row["preset"], row["tiers"].get("generation", ""))


def scenes(results):
    """The scenes of a sweep without the plain variants."""
    return [scene for scene in results["backends"][0]["scenes"] if not scene["plain"]]


def is_for_hosts(row):
    return (row["preset"] not in PRESETS_LEFT_OUT and row["technique"] not in TECHNIQUES_LEFT_OUT
            and row["tiers"].get("generation") not in TIERS_LEFT_OUT)


def candidates(results):
    """The candidates that every scene has, in the order of the sweep."""
    found = None
    for scene in scenes(results):
        here = [candidate(row) for row in scene["rows"] if row["shadingCost"] == 1 and is_for_hosts(row)]
        found = here if found is None else [row for row in found if row in here]
    return list(dict.fromkeys(found))
