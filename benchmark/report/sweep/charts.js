// Shared by all charts: colours that colour-blind readers can distinguish, and drawing.

// This is Okabe and Ito's palette, adjusted where it is too pale or too dark for the page.
const STYLES = {
    agaa: {light: "#d55e00", dark: "#ff8126", point: "circle"},
    simple_complex: {light: "#0072b2", dark: "#4d9fe0", point: "rect"},
    sbaa: {light: "#008a65", dark: "#1fbd92", point: "triangle"},
    ssaa: {light: "#3b4047", dark: "#d5d9de", point: "rectRot"},
    msaa: {light: "#4aa3d8", dark: "#9bdcff", point: "crossRot"},
    fxaa: {light: "#b85f92", dark: "#e39cc5", point: "star"},
    single: {light: "#c98a00", dark: "#f3c04b", point: "rectRounded"},
    smaa: {light: "#9c3d77", dark: "#f0a8d4", point: "cross"},
    taa: {light: "#8c7a00", dark: "#f0e442", point: "rectRounded"},
    visibility: {light: "#006a8e", dark: "#7cc4e8", point: "circle"},
    adaptive: {light: "#6a4fb3", dark: "#b7a1f0", point: "triangle"},
    dcaa: {light: "#a12c1e", dark: "#ff9d8f", point: "rectRot"},
};
const SPARE = [{light: "#5b6b2f", dark: "#c5d68c", point: "cross"}, {light: "#4a5560", dark: "#a9b4bf", point: "dash"}];
const STAGE_COLOURS = {
    prepass: ["#8a939e", "#7b848f"], shadowmap: ["#6b4f3a", "#a98a73"], definition: ["#008a65", "#1fbd92"],
    generation: ["#0072b2", "#4d9fe0"], shading: ["#d98200", "#f0a636"], post: ["#b85f92", "#e39cc5"],
    other: ["#c3c8ce", "#4c545d"],
};
const darkScheme = matchMedia("(prefers-color-scheme: dark)");
const tone = (pair) => darkScheme.matches ? pair[1] : pair[0];

function styleOf(technique) {
    const names = unique(backendsOf().flatMap(scenesOf).flatMap(rowsOf).map(techniqueOf))
        .filter((name) => !STYLES[name]).sort();
    const style = STYLES[technique] ?? SPARE[Math.max(0, names.indexOf(technique)) % SPARE.length];
    return {color: tone([style.light, style.dark]), point: style.point};
}

// All charts have techniques in this order; unknown ones come last.
const ORDER = ["single", "fxaa", "smaa", "taa", "msaa", "visibility", "ssaa", "simple_complex", "adaptive", "sbaa", "agaa", "dcaa"];
function inOrder(techniques) {
    const place = (name) => ORDER.includes(name) ? ORDER.indexOf(name) : ORDER.length;
    return unique(techniques).sort((a, b) => place(a) - place(b) || a.localeCompare(b));
}
function sortedRows(rows) {
    const names = inOrder(rows.map(techniqueOf));
    return [...rows].sort((a, b) => names.indexOf(techniqueOf(a)) - names.indexOf(techniqueOf(b))
        || samplesOf(a) - samplesOf(b) || (a.c ?? 0) - (b.c ?? 0));
}

const styleVariable = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const charts = new Map();

function clearChart(id) {
    charts.get(id)?.destroy();
    charts.delete(id);
}

// height: pixels; null: the height of the style.
function drawChart(id, words, config, height = null) {
    clearChart(id);
    Chart.defaults.color = styleVariable("--quiet");
    Chart.defaults.borderColor = styleVariable("--line");
    Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
    Chart.defaults.animation = false;
    Object.assign(Chart.defaults.plugins.tooltip, {backgroundColor: "rgba(16, 18, 21, 0.95)", borderWidth: 1,
        borderColor: styleVariable("--quiet")});
    const canvas = element("canvas");
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", words);
    const box = byId(id);
    box.style.height = height === null ? "" : height + "px";
    box.replaceChildren(canvas);
    config.options = {responsive: true, maintainAspectRatio: false, ...config.options};
    charts.set(id, new Chart(canvas, config));
}

function noChart(id, words) {
    clearChart(id);
    byId(id).style.height = "auto";
    fill(id, absent(words));
}

// Powers of ten are far apart; labels at 2 and 5 between them make values readable.
function logAxis(title, text, values) {
    return {
        type: "logarithmic", title: {display: true, text: title},
        // The edges have room for whole points, but no empty decades.
        min: Math.min(...values) / 1.3, max: Math.max(...values) * 1.3,
        ticks: {
            maxRotation: 0,
            callback(value, index, ticks) {
                const mantissa = Number(value.toExponential(6).split("e")[0]);
                const decades = Math.log10(ticks[ticks.length - 1].value / ticks[0].value);
                return mantissa === 1 || (decades < 2.5 && (mantissa === 2 || mantissa === 5)) ? text(value) : null;
            },
        },
    };
}
