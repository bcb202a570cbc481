"""Rows of a sweep: their names in documents, how to find them, and the numbers by which they are compared."""

from markdown_table import escaped


def name(row):
    text = escaped(row["technique"])
    if row["n"] > 1:
        text += f" n={row['n']}"
    if row["preset"]:
        text += f" {row['preset']}"
    elif row["c"]:
        text += f" {'S' if row['technique'] == 'sbaa' else 'c'}={row['c']}"
    return text + {"gbuffer": " from a G-buffer", "ids": " by id", "fragments": " by fragments",
                   "material-lists": " with its materials"}.get(materials(row), "")


def materials(row):
    """The source of a row's materials: "gbuffer", "ids", "fragments", "material-lists", or None for the default one."""
    tier = (row["tiers"] or {}).get("generation")
    return tier if tier in ("gbuffer", "ids", "fragments", "material-lists") else None


def frame(row):
    return row["frameMs"]["median"]


def error(row):
    return row["errorReference"]["mseTm"]


def rows_of(scene, cost=1):
    return [row for row in scene["rows"] if row["shadingCost"] == cost]


def find(scene, technique, n, c=0, cost=1, by=None):
    """The row without a preset, or None. by: the source of its materials, as materials() returns it."""
    for row in rows_of(scene, cost):
        if (row["technique"], row["n"], row["c"], materials(row)) == (technique, n, c, by) and not row["preset"]:
            return row
    return None


def builds(scenes):
    found = {scene.get("build") or "one without a name" for scene in scenes}
    found |= {row["build"] for scene in scenes for row in scene["rows"] if row.get("build")}
    return ", ".join(sorted(found))


def ratio(a, b):
    """a / b, or None if a is None or b is None or 0."""
    return a / b if a is not None and b else None


def mean(values):
    return sum(values) / len(values)
