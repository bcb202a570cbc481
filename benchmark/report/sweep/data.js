"use strict";
// Reads the results. Any member may be missing, which must not break the page.

const results = JSON.parse(document.getElementById("results").textContent);
const paperFigures = JSON.parse(document.getElementById("papers-figures").textContent);
const MISSING = "–";
const SOFTWARE = /llvmpipe|lavapipe|softpipe|swiftshader|swrast/i;

const dicts = (value) => Array.isArray(value) ? value.filter((item) => item && typeof item === "object") : [];
const finite = (value) => typeof value === "number" && Number.isFinite(value) ? value : null;
const field = (value, ...keys) => keys.reduce((at, key) => at && typeof at === "object" ? at[key] : undefined, value);
const backendsOf = () => dicts(results.backends);
const allScenesOf = (backend) => dicts(field(backend, "scenes"));
// A plain scene appears in the table of effects only.
const scenesOf = (backend) => allScenesOf(backend).filter((scene) => !scene.plain);
const rowsOf = (scene) => dicts(field(scene, "rows"));
const costOf = (row) => finite(row.shadingCost) ?? 1;
const rowsAt = (scene, cost) => rowsOf(scene).filter((row) => costOf(row) === cost);
const frameMs = (row) => finite(field(row, "frameMs", "median"));
// The confidence bounds of the median; nothing if the results lack them.
function boundsText(times) {
    const [low, high, confidence] = ["low", "high", "confidence"].map((key) => finite(times?.[key]));
    return low === null || high === null || confidence === null ? null
        : `${msText(low)} to ${msText(high)} ms (${Math.floor(confidence * 100)} % of ${times.frames} frames)`;
}
const samplesOf = (row) => finite(row.n) ?? 0;
const techniqueOf = (row) => String(row.technique ?? "unnamed");
const unique = (values) => [...new Set(values)];

function label(row) {
    const words = [techniqueOf(row)];
    if (row.n > 1)
        words.push("n=" + row.n);
    if (row.preset)
        words.push(row.preset);
    else if (row.c > 0)
        words.push((row.technique === "sbaa" ? "S=" : "c=") + row.c);
    if (row.alike)
        words.push("(" + tiersOf(row) + ")");
    return words.join(" ");
}

function tiersOf(row) {
    const tiers = row.tiers && typeof row.tiers === "object" ? Object.values(row.tiers) : [];
    return tiers.filter((tier) => tier).join(", ");
}

// Two rows of one scene that differ in their tiers only have the tiers in their names.
for (const scene of backendsOf().flatMap(scenesOf)) {
    const seen = new Map();
    for (const row of rowsOf(scene)) {
        const name = label(row) + "/" + costOf(row);
        const first = seen.get(name);
        if (first)
            first.alike = row.alike = true;
        else
            seen.set(name, row);
    }
}

// The metrics: the key of an error, and the row's field for what it is measured against.
const METRICS = {
    "mseTm": {name: "mseTm against the reference", against: "errorReference", key: "mseTm"},
    "mseTm-ssaa": {name: "mseTm against ssaa at the same n", against: "errorSameSamples", key: "mseTm"},
    "flip": {name: "FLIP against the reference", against: "errorReference", key: "flip"},
    "flip-ssaa": {name: "FLIP against ssaa at the same n", against: "errorSameSamples", key: "flip"},
    "flipP95": {name: "FLIP, 95th percentile, against the reference", against: "errorReference", key: "flipP95"},
    "relMse": {name: "relMSE against the reference, linear", against: "errorReference", key: "relMse"},
};
const errorOf = (row, metric) => finite(field(row, metric.against, metric.key));
// Only the common reference allows a comparison of techniques with different n.
const referenceMetric = (metric) => METRICS[metric.key];

// The reference's own error is known as mseTm only; with other metrics every gap counts.
function smallestGap(scene, metric) {
    const own = finite(field(scene, "reference", "splitHalfMseTm"));
    return metric.key === "mseTm" && metric.against === "errorReference" && own !== null ? 10 * own : 0;
}

// Returns the ratio of two rows' errors; 1 if the reference cannot distinguish them.
function errorRatio(scene, metric, a, b) {
    return a !== null && b !== null && Math.abs(a - b) < smallestGap(scene, metric) ? 1 : ratio(a, b);
}

// Returns such a ratio of "biasSquared" or "variance" over shifts.
function temporalRatio(row, other, key) {
    const [a, b, own] = [field(row, "temporal", key), field(other, "temporal", key), field(row, "temporal", "referenceMseTm")]
        .map(finite);
    return a !== null && b !== null && own !== null && Math.abs(a - b) < 10 * own ? 1 : ratio(a, b);
}

function significant(value, digits = 3) {
    if (finite(value) === null)
        return MISSING;
    const size = Math.abs(value);
    if (size !== 0 && (size < 1e-3 || size >= 1e6))
        return value.toExponential(digits - 1);
    return size >= 10 ** digits ? String(Math.round(value)) : String(Number(value.toPrecision(digits)));
}
// Errors of a table share one notation, so that their orders of magnitude line up.
const errorText = (value, metric) => finite(value) === null ? MISSING
    : metric.key.startsWith("flip") ? value.toFixed(4) : value.toExponential(2);
function psnrText(error) {
    const [psnr, peak] = ["psnr", "psnrPeak"].map((key) => finite(error?.[key]));
    return psnr === null || peak === null ? null : `PSNR ${psnr.toFixed(1)} dB at a peak of ${significant(peak)}`;
}
const msText = (value) => finite(value) === null ? MISSING : value.toFixed(value < 10 ? 2 : 1);
const ratioText = (value) => finite(value) === null ? MISSING : value.toFixed(2) + "×";
const percent = (value) => Math.round(100 * value) + " %";
function spanText(values, text = ratioText) {
    const ends = unique([text(Math.min(...values)), text(Math.max(...values))]);
    return values.length ? ends.join(" to ") : MISSING;
}
const ratio = (a, b) => finite(a) === null || finite(b) === null || b === 0 ? null : a / b;
