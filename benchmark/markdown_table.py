"""Markdown tables, and how their cells show numbers and names."""

MISSING = "not measured"


def row(cells):
    return "| " + " | ".join(map(str, cells)) + " |"


def table(head, rows, align="l"):
    """The lines of a table. align: "l" or "r" for each column; the last letter also applies to the columns after it."""
    letters = align + align[-1] * (len(head) - len(align))
    return [row(head), "|" + "".join("---:|" if letter == "r" else "---|" for letter in letters), *map(row, rows)]


def paragraph(head, rows, align="l"):
    """The lines of a table, and an empty line."""
    return [*table(head, rows, align), ""]


def fixed(value, digits=2):
    """The value with so many decimals; None is not measured."""
    return MISSING if value is None else f"{value:.{digits}f}"


def span(values):
    """The smallest and the largest of the values that are not None."""
    values = [value for value in values if value is not None]
    return f"{fixed(min(values))} to {fixed(max(values))}" if values else MISSING


def escaped(name):
    """The name outside code, where an underscore would start emphasis."""
    return name.replace("_", "\\_")
