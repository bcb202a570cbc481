"""The bounds of compiled passes, which benchmark/tests/test_compiled_passes.py checks, and the passes that miss them."""
import fnmatch
import typing

BOUNDS = {"vgprs": 128, "spilled": 0, "scratch": 0, "lds": 16384}  # VGPRs, VGPRs, bytes a lane, bytes a workgroup
SENTENCE = ("A pass must have at most 128 VGPRs, no spilled VGPR, no scratch memory, and at most 16,384 bytes of LDS. The "
            "table has the largest figures of both chips.")


class KnownMiss(typing.NamedTuple):
    """Upper bounds of a pass in place of BOUNDS, on both chips. configurations: a pattern of fnmatch for their names."""
    name: str
    configurations: str
    vgprs: int = BOUNDS["vgprs"]
    spilled: int = 0
    scratch: int = 0
    lds: int = BOUNDS["lds"]

    def matches(self, row):
        return row["pass"] == self.name and fnmatch.fnmatchcase(row["configuration"], self.configurations)

    def bounds(self):
        return {name: getattr(self, name) for name in BOUNDS}


# A row of a pass whose configurations meet BOUNDS must be removed. Figures of rows may only become smaller.
KNOWN_MISSES = [KnownMiss(*row) for row in [
    # pass, configurations, VGPRs, spilled VGPRs, bytes of scratch
    ("aggregate and shade", "balanced fragments n=*", 168),
    ("aggregate and shade", "accurate fragments n=*", 168),
    ("aggregate and shade", "* fragments n=*", 136),
]]


def misses(figures, bounds=BOUNDS):
    """The names of the bounds that the figures of a pass exceed."""
    return [name for name, bound in bounds.items() if getattr(figures, name) > bound]


def failures(rows, chips, known_misses=KNOWN_MISSES):
    """Sentences about passes beyond their bounds, and about rows of known_misses that compiled passes do not need."""
    found = []
    needed = {row: False for row in known_misses}
    met = {row: False for row in known_misses}
    for row in rows:
        known = next((one for one in known_misses if one.matches(row)), None)
        bounds = known.bounds() if known else BOUNDS
        for chip in (chip for chip in chips if chip in row):
            over = [f"{getattr(row[chip], name)} {name} of {bounds[name]}" for name in misses(row[chip], bounds)]
            if over:
                found.append(f"{row['configuration']}, {row['pass']}, {chip}: {', '.join(over)}")
            if known:
                met[known] = True
                needed[known] |= bool(misses(row[chip]))
    found += [f"{row.name}, {row.configurations}: meets all bounds; remove its row of KNOWN_MISSES"
              for row in known_misses if met[row] and not needed[row]]
    return found
