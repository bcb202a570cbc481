"""Least squares with coefficients that are not negative."""


def nonnegative(rows, targets, known=None, iterations=20000, tolerance=1e-9):
    """Coefficients that minimise the sum of squared relative errors of row · coefficients against the targets (> 0).

    Rows are sparse: {column: value}. known: a part of each target that other coefficients explain; none by default.
    Coordinate descent finds the minimum, which is unique.
    """
    known = known or [0.0] * len(rows)
    columns = list(dict.fromkeys(column for row in rows for column in row))
    index = {column: i for i, column in enumerate(columns)}
    count = len(columns)
    products = [[0.0] * count for _ in columns]
    right = [0.0] * count
    for row, target, part in zip(rows, targets, known, strict=True):
        entries = [(index[column], value / target) for column, value in row.items()]
        for i, a in entries:
            right[i] += a * (1 - part / target)
            for j, b in entries:
                products[i][j] += a * b
    scale = [products[i][i] ** 0.5 or 1.0 for i in range(count)]
    neighbours = [[(j, products[i][j] / (scale[i] * scale[j])) for j in range(count) if j != i and products[i][j]]
                  for i in range(count)]
    right = [right[i] / scale[i] for i in range(count)]
    values = [0.0] * count
    for _ in range(iterations):
        change = 0.0
        for i in range(count):
            value = max(0.0, right[i] - sum(weight * values[j] for j, weight in neighbours[i]))
            change = max(change, abs(value - values[i]))
            values[i] = value
        if change <= tolerance * max(values):
            break
    return {column: values[index[column]] / scale[index[column]] for column in columns}
