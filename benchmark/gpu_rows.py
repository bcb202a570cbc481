"""The rows of a run on a GPU: all techniques, tiers and n, and other ways to do the same."""
import dataclasses

ACCUMULATING = ("post-depth-atomics", "per-sample", "gbuffer")


@dataclasses.dataclass(frozen=True)
class Row:
    technique: str
    samples: int
    aggregates: int = 0  # c or S; 0: none
    tier: str = ""       # of generation; "": AUTO
    preset: str = ""
    way: str = ""        # words for more; "": the default
    more: tuple = ()     # options of the way

    @property
    def options(self):
        chosen = ["--preset", self.preset] if self.preset else ["--technique", self.technique]
        return [*chosen, "--samples", self.samples, *(["--aggregates", self.aggregates] if self.aggregates else []),
                *(["--tier", f"generation={self.tier}"] if self.tier else []), *self.more]

    @property
    def name(self):
        parts = (self.preset or self.technique, self.samples, self.aggregates, self.tier, self.way.replace(" ", "-"))
        return "-".join(str(part) for part in parts if part)


def rows():
    """All rows. Those that answer the first questions come first, because time on a GPU may end."""
    found = [Row("single", 1), Row("ssaa", 8), Row("simple_complex", 8), Row("msaa", 8), Row("agaa", 8, 2, "ids"),
             Row("agaa", 8, preset="accurate", tier="ids"), Row("agaa", 8, 2, "gbuffer"), Row("dcaa", 64, 4, "lists"),
             Row("agaa", 64, 4, "fragments"), Row("fxaa", 1)]
    found += [Row("agaa", 8, 2, tier) for tier in ACCUMULATING] + [Row("sbaa", 8, 2, tier) for tier in ACCUMULATING]
    found += [Row("adaptive", 8, tier=tier) for tier in ("gbuffer", "ids")]
    found += [Row("dcaa", 64, 4, tier) for tier in ("material-lists", "interlock", "raster-order")]
    found += [dataclasses.replace(row, way=way, more=("--expand", expand))
              for way, expand in (("vertex pulling", "pulling"), ("compute", "compute"))
              for row in (Row("dcaa", 64, 4, "lists"), Row("dcaa", 64, 4, "material-lists"), Row("agaa", 64, 4, "fragments"))]
    for n in (8, 32):
        found += [dataclasses.replace(row, way=f"lanes {lanes}", more=("--lanes", lanes))
                  for row in (Row("agaa", n, preset="accurate", tier="ids"), Row("agaa", n, 2, "gbuffer"),
                              Row("agaa", n, 2, "post-depth-atomics"), Row("sbaa", n, 2, "post-depth-atomics"))
                  for lanes in ("pixel", "shared", "subgroup")]
        found += [dataclasses.replace(Row("adaptive", n, tier="gbuffer"), way=f"lanes {lanes}", more=("--lanes", lanes))
                  for lanes in ("pixel", "shared", "subgroup")]
    found += [dataclasses.replace(row, way=f"lanes {lanes}", more=("--lanes", lanes))
              for row in (Row("dcaa", 64, 4, "lists"), Row("agaa", 64, 4, "fragments"))
              for lanes in ("pixel", "shared")]
    for n in (16, 32, 4):
        found += [Row(technique, n) for technique in ("ssaa", "simple_complex", "msaa")]
        found += [Row("agaa", n, 2, "ids"), Row("agaa", n, preset="accurate", tier="ids"), Row("agaa", n, 2, "gbuffer"),
                  Row("adaptive", n, tier="ids")]
    found += [Row("agaa", 8, preset=preset, tier="ids") for preset in ("fast", "balanced", "paper")]
    found += [Row("agaa", 8, c, "ids") for c in (1, 3, 4)] + [Row("dcaa", 64, s, "lists") for s in (1, 2, 8)]
    found += [Row("dcaa", n, 4, "lists") for n in (32, 128)] + [Row("agaa", n, 4, "fragments") for n in (32, 128)]
    return list(dict.fromkeys(found))
