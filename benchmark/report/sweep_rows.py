"""Rows of a sweep: how documents name and find them, and the numbers that they are compared by."""


def name(row):
    text = row["technique"].replace("_", "\\_")
    if row["n"] > 1:
        text += f" n={row['n']}"
    if row["preset"]:
        text += f" {row['preset']}"
    elif row["c"]:
        text += f" {'S' if row['technique'] == 'sbaa' else 'c'}={row['c']}"
    return text + {"gbuffer": " from a G-buffer", "ids": " by id", "fragments": " by fragments",
                   "material-lists": " with its materials"}.get(way(row), "")


def way(row):
    """How a row comes by materials: "gbuffer", "ids", "fragments", "material-lists", or None, by the usual way."""
    tier = (row["tiers"] or {}).get("generation")
    return tier if tier in ("gbuffer", "ids", "fragments", "material-lists") else None


def frame(row):
    return row["frameMs"]["median"]


def error(row):
    return row["errorReference"]["mseTm"]


def rows_of(scene, cost=1):
    return [row for row in scene["rows"] if row["shadingCost"] == cost]


def find(scene, technique, n, c=0, cost=1, by=None):
    """The row, or None. by: as way() tells; no row of a preset."""
    for row in rows_of(scene, cost):
        if (row["technique"], row["n"], row["c"], way(row)) == (technique, n, c, by) and not row["preset"]:
            return row
    return None


def builds(scenes):
    return ", ".join(sorted({scene.get("build") or "one without a name" for scene in scenes}))


def ratio(a, b):
    """None where there is none to speak of."""
    return a / b if a is not None and b else None


def shown(value):
    return "not measured" if value is None else f"{value:.2f}"


def mean(values):
    return sum(values) / len(values)


def span(values):
    values = [value for value in values if value is not None]
    return f"{min(values):.2f} to {max(values):.2f}" if values else "not measured"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return lines + ["| " + " | ".join(str(value) for value in row) + " |" for row in rows] + [""]
