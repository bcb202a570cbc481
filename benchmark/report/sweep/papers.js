// Our ratios beside the papers', and the reasons for which they cannot be compared.

// Bytes per pixel with the layouts that reproduce the figures of the papers.
const paperBytes = {
    agaa: (n, c) => 16 * c + 6 * n + n * Math.ceil(Math.log2(c)) / 8,
    ssaa: (n) => 16 * n,
    sbaa: (n, s) => 9 * n + 14 * s,
};
// The classification of pixels counts as shading, because it may be in the same pass.
const shadingMs = (row) => {
    const {shading, definition = 0} = row ? stagesOf(row) : {};
    return shading === undefined ? null : row.technique === "simple_complex" ? definition + shading : shading;
};
const decidingMs = (row) => {
    const {shading, definition = 0} = row ? stagesOf(row) : {};
    return shading === undefined ? null : definition + shading;
};
const stageShare = (row, stages) => {
    const times = row ? stagesOf(row) : {};
    const all = Object.values(times).reduce((sum, ms) => sum + ms, 0);
    return all > 0 ? stages.reduce((sum, stage) => sum + (times[stage] ?? 0), 0) / all : null;
};
const geometryShare = (row) => stageShare(row, ["prepass", "generation"]);
const eventsOf = (row) => finite(row?.eventsPerCoveredPixel) ?? finite(row?.eventsPerPixel);

function pairAt(rows, n) {
    const theirs = find(rows, "simple_complex", n), ours = find(rows, "agaa", n, 2);
    const shading = ratio(shadingMs(theirs), shadingMs(ours));
    const events = ratio(eventsOf(theirs), eventsOf(ours));
    return {theirs, ours, shading, events, efficiency: ratio(shading, events),
        withGrouping: ratio(decidingMs(theirs), decidingMs(ours)), eventShare: ratio(eventsOf(ours), eventsOf(theirs)),
        frame: ratio(theirs && frameMs(theirs), ours && frameMs(ours))};
}

function timeReasons(backend, scene, n, cost, ofPasses) {
    const reasons = [];
    const figures = paperFigures.agaa.scenes[scene.name];
    reasons.push(figures ? `our scene stands in for the paper's ${figures.paper}` : "scene not in the paper");
    if (SOFTWARE.test(`${backend.device} ${backend.driver}`))
        reasons.push("software rasteriser, the paper's a GTX 980");
    else
        reasons.push("another device than the paper's GTX 980");
    if (results.size && results.size !== "1280x720")
        reasons.push(`${results.size}, the paper 1280x720`);
    if (n > 8)
        reasons.push("above n = 8 the paper leaves out what emulating access to depth planes costs");
    if (cost !== 1)
        reasons.push(`lighting ${cost}×`);
    if (ofPasses && backend.passTimes === "cpu-finish")
        reasons.push("times of passes by waiting on the processor");
    return "no: " + reasons.join("; ");
}

function ratioRows(backend, scene, rows, cost) {
    const out = [], paper = paperFigures.agaa;
    const add = (what, ours, theirs, comparable) => {
        if (ours !== null)
            out.push([what, typeof ours === "string" ? ours : ratioText(ours),
                typeof theirs === "number" ? ratioText(theirs) : theirs ?? MISSING, comparable]);
    };
    for (const n of [8, 32]) {
        const pair = pairAt(rows, n), figures = paper.scenes[scene.name]?.[n];
        const range = (key, text = ratioText) => spanText(Object.values(paper.scenes).map((entry) => entry[n][key]), text);
        const at = `, n = ${n}`;
        add("shading time, simple_complex / agaa c=2" + at, pair.shading, figures?.shading ?? range("shading"),
            timeReasons(backend, scene, n, cost, true));
        add("the same with agaa's clustering" + at, pair.withGrouping, null, "no: the paper has it in no sum");
        add("frame time, simple_complex / agaa c=2" + at, pair.frame, figures?.frame ?? range("frame"),
            timeReasons(backend, scene, n, cost, false));
        const geometry = geometryShare(pair.ours);
        add("prepass and generation of agaa's passes, c=2" + at, geometry === null ? null : percent(geometry),
            figures ? percent(figures.geometry) : range("geometry", percent), timeReasons(backend, scene, n, cost, true));
        const known = n === 8;
        add("shading events, simple_complex / agaa c=2" + at, pair.events,
            known ? paper.events.simpleComplex / paper.events.agaa2 : null,
            known ? "partly: a count, of another scene and view" : "no: the paper has counts at n = 8 only");
        add("shading time's ratio by events' ratio" + at, pair.efficiency, known ? paper.efficiency : null,
            known ? timeReasons(backend, scene, n, cost, true) : "no: the paper has counts at n = 8 only");
    }
    const events = (s) => ratio(eventsOf(find(rows, "agaa", 8, 2)), eventsOf(find(rows, "sbaa", 8, s)));
    for (const s of [2, 6])
        add(`shading events, agaa c=2 / sbaa S=${s}, n = 8`, events(s), paper.events.agaa2 / paper.events["sbaa" + s],
            "partly: a count, of another scene and view");
    for (const n of [4, 8, 16, 32]) {
        const ours = finite(find(rows, "agaa", n, 2)?.bytesPerPixel);
        const beside = (row) => ratio(ours, finite(row?.bytesPerPixel));
        const why = "partly: no device in it; ours as allocated, in the layout and by the tiers of this run";
        add(`memory, agaa c=2 / ssaa, n = ${n}`, beside(find(rows, "ssaa", n)), paperBytes.agaa(n, 2) / paperBytes.ssaa(n), why);
        add(`memory, agaa c=2 / sbaa S=2, n = ${n}`, beside(find(rows, "sbaa", n, 2)),
            paperBytes.agaa(n, 2) / paperBytes.sbaa(n, 2), why);
    }
    for (const n of [8, 32]) {
        for (const s of [2, 4])
            errorRatios(scene, rows, n, s, add);
    }
    relativesRatios(scene, rows, add);
    return out;
}

// The figures are from Wang et al. 2016 (DCAA), table 1, and Holländer et al. 2013, table 1.
function relativesRatios(scene, rows, add) {
    const mse = (row) => finite(field(row, "errorReference", "mse"));
    const {mse: theirs} = paperFigures.dcaa, byMsaa = ({sbaa4, msaa8}) => sbaa4 / msaa8;
    const all = Object.values(theirs).map(byMsaa);
    add("MSE against the reference, sbaa S=4 / msaa, n = 8", ratio(mse(find(rows, "sbaa", 8, 4)), mse(find(rows, "msaa", 8))),
        theirs[scene.name] ? byMsaa(theirs[scene.name]) : `${Math.min(...all).toFixed(2)} to ${Math.max(...all).toFixed(2)}×`,
        "partly: Wang et al., 512 samples a pixel too, other scenes, 1920x1080; their colours end at 1, ours are linear light");
    const frame = (technique) => frameMs(find(rows, technique, 1) ?? {});
    add("frame time, fxaa / single", ratio(frame("fxaa"), frame("single")),
        paperFigures.adaptive.fxaaMs / paperFigures.adaptive.singleMs, "no: Holländer et al., GTX 480, 1024x768, another scene");
}

function errorRatios(scene, rows, n, s, add) {
    const ours = find(rows, "agaa", n, 2), theirs = find(rows, "sbaa", n, s);
    const claim = s === 4 ? "about 1" : null;
    const why = (s === 4 ? "partly: the paper's claim, by looking at images" : "no: the paper has no figure")
        + "; it measures no errors";
    for (const [name, metric] of [["ssaa", METRICS["mseTm-ssaa"]], ["the reference", METRICS.mseTm]]) {
        const a = ours && errorOf(ours, metric), b = theirs && errorOf(theirs, metric);
        let shown = ratio(a, b);
        if (shown !== null && Math.abs(a - b) < smallestGap(scene, metric))
            shown = `${ratioText(shown)} (${noDifference})`;
        add(`mseTm against ${name}, agaa c=2 / sbaa S=${s}, n = ${n}`, shown, claim, why);
    }
}

function showPapers(backend, scene, rows, cost) {
    byId("papers-note").textContent = `The AGAA paper measured on ${paperFigures.agaa.setup}. Ours are ratios within one `
        + "scene of one run; above 1 agaa is quicker. Few of them can be compared with the paper's, for the reasons given.";
    const wide = [];
    for (const other of scenesOf(backend)) {
        const line = [String(other.name ?? MISSING)];
        for (const n of [8, 32]) {
            const pair = pairAt(rowsAt(other, cost), n), figures = paperFigures.agaa.scenes[other.name]?.[n];
            const cell = (value, theirs) => ({text: ratioText(value), note: theirs ? `paper ${theirs.toFixed(2)}×` : "",
                className: value >= 1 ? "best" : ""});
            line.push(cell(pair.shading, figures?.shading), {text: ratioText(pair.events), note: pair.efficiency === null ? ""
                : `efficiency ${pair.efficiency.toFixed(2)}`}, cell(pair.frame, figures?.frame));
        }
        if (line.slice(1).some((cell) => cell.text !== MISSING))
            wide.push(line);
    }
    fill("papers-scenes", wide.length ? tableOf(`simple_complex / agaa c=2 in all scenes, lighting ${cost}×`,
        ["<scene", "shading, n=8", "events, n=8", "frame, n=8", "shading, n=32", "events, n=32", "frame, n=32"], wide)
        : absent("This sweep has no rows of simple_complex and agaa at n = 8 or 32 to set beside each other."));
    const lines = ratioRows(backend, scene, rows, cost);
    const table = tableOf(`All ratios of ${scene.name ?? "this scene"}`, ["<ratio", "ours", "the paper's", "<comparable?"], lines);
    table.classList.add("words");
    fill("papers", lines.length ? table : absent("This scene has no rows that the papers' figures could stand beside."));
}
