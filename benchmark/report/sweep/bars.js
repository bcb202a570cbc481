// Bars by row: the stages of a frame's time, and errors over time.

const BAR_HEIGHT = 24;

// tip: returns the words for a bar of a dataset; without it, the bar's number is shown.
function drawBars(id, words, rows, datasets, title, {plugins = [], tip = null} = {}) {
    drawChart(id, words, {
        type: "bar",
        data: {labels: rows.map(label), datasets},
        plugins,
        options: {
            indexAxis: "y",
            interaction: {mode: "index", axis: "y", intersect: false},
            scales: {
                x: {stacked: true, beginAtZero: true, title: {display: true, text: title}, ticks: {maxRotation: 0}},
                y: {stacked: true, grid: {display: false}, ticks: {autoSkip: false, font: {size: 11}}},
            },
            plugins: {
                legend: {display: datasets.length > 1, position: "top", labels: {boxWidth: 12, boxHeight: 12}},
                tooltip: {
                    filter: (item) => item.raw > 0,
                    callbacks: {label: (item) => tip?.(rows[item.dataIndex], item.dataset.label)
                        ?? `${item.dataset.label} ${significant(item.raw)}`},
                },
            },
            datasets: {bar: {categoryPercentage: 0.9, barPercentage: 0.85}},
        },
    }, 90 + BAR_HEIGHT * rows.length);
}

// Lists the passes of a stage.
function passesText(row, stage) {
    const passes = dicts(row.passes).filter((pass) => pass.stage === stage && finite(field(pass, "ms", "median")) !== null);
    return passes.length ? passes.map(({name, ms}) => `${name} ${msText(ms.median)} ms (p95 ${msText(ms.p95)})`) : null;
}

function showStages(backend, rows) {
    const times = {device: "Times of passes are the device's own.",
        "cpu-finish": "Times of passes are the processor's, waiting for each pass to end: they add up to more than a frame."};
    byId("stage-note").textContent = times[backend.passTimes] ?? "";
    const measured = sortedRows(rows).filter((row) => Object.keys(stagesOf(row)).length);
    const select = byId("stage-n");
    const sizes = unique(measured.map(samplesOf)).sort((a, b) => a - b);
    // Rows of one n fit on a screen; all rows of a sweep do not.
    setOptions(select, [{value: "all", text: "all"}, ...sizes.filter((n) => n > 1)
        .map((n) => ({value: String(n), text: "n = " + n}))], measured.length > 20 ? "8" : "all");
    const shown = measured.filter((row) => select.value === "all" || samplesOf(row) <= 1
        || String(samplesOf(row)) === select.value);
    if (!shown.length) {
        noChart("stages", backend.passTimes === "none" ? "This backend has no times of passes."
            : "No row has times of its passes.");
        return;
    }
    const used = STAGES.filter((stage) => shown.some((row) => stagesOf(row)[stage]));
    drawBars("stages", "Time of each stage by row", shown, used.map((stage) => ({
        label: stage, data: shown.map((row) => stagesOf(row)[stage] ?? 0),
        backgroundColor: tone(STAGE_COLOURS[stage]),
    })), "ms, medians of passes", {tip: passesText});
}

// The line at 1 marks the flicker of the reference.
const steadyLine = {
    id: "steadyLine",
    afterDatasetsDraw(chart) {
        const x = chart.scales.x.getPixelForValue(1);
        const {top, bottom, right} = chart.chartArea;
        if (x > right)
            return;
        chart.ctx.save();
        chart.ctx.strokeStyle = styleVariable("--text");
        chart.ctx.setLineDash([4, 3]);
        chart.ctx.beginPath();
        chart.ctx.moveTo(x, top);
        chart.ctx.lineTo(x, bottom);
        chart.ctx.stroke();
        chart.ctx.restore();
    },
};

// kind: field of a row. The charts are drawn into the boxes with these ids.
function showOverTime(rows, kind, errorId, flickerId, words) {
    const measured = sortedRows(rows).filter((row) => finite(field(row, kind, "biasSquared")) !== null
        || finite(field(row, kind, "variance")) !== null);
    if (measured.length) {
        const bars = (key) => measured.map((row) => finite(row[kind][key]) ?? 0);
        drawBars(errorId, `Bias and variance ${words} by row`, measured, [
            {label: "bias²", data: bars("biasSquared"), backgroundColor: tone(STAGE_COLOURS.generation)},
            {label: "variance", data: bars("variance"), backgroundColor: tone(STAGE_COLOURS.shading)},
        ], "mean squared error after tone mapping");
    } else {
        noChart(errorId, `This sweep has not measured images ${words}.`);
    }
    const flickering = measured.filter((row) => finite(row[kind].flicker) !== null);
    if (flickering.length) {
        drawBars(flickerId, `Flicker ${words} by row`, flickering, [{label: "flicker",
            data: flickering.map((row) => row[kind].flicker),
            backgroundColor: flickering.map((row) => styleOf(techniqueOf(row)).color)}],
        "standard deviation over time by the reference's", {plugins: [steadyLine]});
    } else {
        noChart(flickerId, `This sweep has not measured flicker ${words}.`);
    }
}

function showTemporal(rows) {
    const noise = ["temporal", "path"].flatMap((kind) => rows.map((row) => finite(field(row, kind, "referenceMseTm"))))
        .filter((value) => value !== null);
    byId("temporal-note").textContent = noise.length
        ? `References over time have fewer samples than the still one: they add up to ${Math.max(...noise).toExponential(1)} `
            + "to bias² or variance, and gaps below ten times that are none." : "";
    showOverTime(rows, "temporal", "temporal", "flicker", "over sub-pixel shifts");
    showOverTime(rows, "path", "path", "path-flicker", "along a camera path");
}
