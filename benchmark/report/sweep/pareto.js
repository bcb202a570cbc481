// Charts of error against time and memory. Each row is a point; a line joins the Pareto front.

function pointTooltip() {
    return {
        filter: (item) => Boolean(item.raw.row),
        callbacks: {
            title: (items) => items.map((item) => label(item.raw.row)),
            label: (item) => {
                const {row} = item.raw;
                const error = (metric) => errorText(errorOf(row, metric), metric);
                return [
                    `technique ${techniqueOf(row)}, n ${row.n ?? MISSING}, ${row.technique === "sbaa" ? "S" : "c"} ${row.c || MISSING}`,
                    tiersOf(row) && `tiers: ${tiersOf(row)}`,
                    `frame ${msText(frameMs(row))} ms (p95 ${msText(field(row, "frameMs", "p95"))})`,
                    boundsText(row.frameMs),
                    `mseTm ${error(METRICS.mseTm)}, FLIP ${error(METRICS.flip)}, in 95 % of pixels below `
                        + error(METRICS.flipP95),
                    psnrText(row.errorReference),
                    row.errorSameSamples && `against ssaa: mseTm ${error(METRICS["mseTm-ssaa"])}`,
                    `${significant(row.bytesPerPixel)} bytes, ${significant(row.eventsPerPixel)} events a pixel`,
                ].filter((line) => line);
            },
        },
        displayColors: false,
    };
}

function drawPareto(id, rows, metric, axis) {
    const points = rows.map((row) => ({x: axis.of(row), y: errorOf(row, metric), row}))
        .filter((point) => point.x > 0 && point.y > 0);
    if (!points.length) {
        noChart(id, "No row has both this error and " + axis.missing + ".");
        return 0;
    }
    // The line extends as far right as the points, because points above it there are beaten.
    const front = paretoFront(points).map(({x, y}) => ({x, y}));
    const furthest = Math.max(...points.map((point) => point.x));
    if (front[front.length - 1].x < furthest)
        front.push({x: furthest, y: front[front.length - 1].y});
    const datasets = inOrder(points.map((point) => techniqueOf(point.row))).map((technique) => {
        const own = points.filter((point) => techniqueOf(point.row) === technique);
        const {color, point} = styleOf(technique);
        // Crosses and stars consist of outlines; filled shapes have a rim of the page's colour.
        const outlined = ["crossRot", "cross", "star", "dash"].includes(point);
        return {
            label: technique, data: own, pointStyle: point, borderColor: outlined ? color : styleVariable("--page"),
            backgroundColor: color, pointBorderWidth: outlined ? 2 : 1, pointHitRadius: 6,
            pointRadius: own.map(({row}) => 3.5 + 1.1 * Math.log2(Math.max(1, samplesOf(row)))),
            pointHoverRadius: own.map(({row}) => 5.5 + 1.1 * Math.log2(Math.max(1, samplesOf(row)))),
        };
    });
    datasets.push({
        label: "Pareto front", data: front, type: "line", showLine: true, stepped: true, pointRadius: 0,
        pointHitRadius: 0, pointHoverRadius: 0, pointStyle: "line", borderDash: [5, 4], borderWidth: 1.5,
        borderColor: styleVariable("--quiet"), backgroundColor: "transparent", order: 9,
    });
    drawChart(id, metric.name + " against " + axis.name + ", a point for each row", {
        type: "scatter", data: {datasets},
        options: {
            interaction: {mode: "nearest", intersect: true},
            scales: {
                x: logAxis(axis.name, (value) => significant(value), points.map(({x}) => x)),
                y: logAxis(metric.name, (value) => metric.key === "flip" ? significant(value)
                    : value.toExponential(0).replace("e-", "e−"), points.map(({y}) => y)),
            },
            plugins: {
                legend: {position: "bottom", labels: {usePointStyle: true, boxHeight: 7, padding: 12}},
                tooltip: pointTooltip(),
            },
        },
    });
    return points.length;
}

function showPareto(scene, rows, metric) {
    const time = {name: "frame time, ms", missing: "a frame time", of: frameMs};
    const bytes = {name: "bytes a pixel", missing: "a size in memory", of: (row) => finite(row.bytesPerPixel)};
    const drawn = drawPareto("pareto-time", rows, metric, time);
    drawPareto("pareto-bytes", rows, metric, bytes);
    const notes = [];
    const gap = smallestGap(scene, metric);
    if (gap)
        notes.push(`Errors closer to each other than ${gap.toExponential(1)} are no difference: ten times the reference's own error.`);
    const none = rows.filter((row) => errorOf(row, metric) === 0).length;
    const unknown = rows.length - none - rows.filter((row) => errorOf(row, metric) > 0).length;
    if (drawn && none)
        notes.push(`${none} of ${rows.length} rows have no error at all, for which this axis has no place.`);
    if (drawn && unknown)
        notes.push(`${unknown} of ${rows.length} rows have no such error` + (metric.against === "errorSameSamples"
            ? ": ssaa is what the others are measured against, and a row without samples has no ssaa beside it." : "."));
    byId("pareto-note").textContent = notes.join(" ");
}
