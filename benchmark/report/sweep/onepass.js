// The advantage of one geometry pass, and the figures of the presets, over all scenes of the backend.

const ONE_PASS = {gbuffer: "from a G-buffer", ids: "by id"};
const tierRow = (rows, n, tier) => rows.find((row) => row.technique === "agaa" && row.n === n && row.c === 2 && !row.preset
    && field(row, "tiers", "generation") === tier) ?? null;

// Returns simple_complex's frame time as a multiple of the row's, and the row's error as a multiple of its error.
function againstSimpleComplex(scene, row, theirs) {
    const value = ratio(theirs && frameMs(theirs), row && frameMs(row));
    const errors = errorRatio(scene, METRICS.mseTm, row && errorOf(row, METRICS.mseTm), theirs && errorOf(theirs, METRICS.mseTm));
    return {text: ratioText(value), note: errors === null ? "" : `error ${ratioText(errors)}`, className: value >= 1 ? "best" : ""};
}

function onePassLine(scene, cost) {
    const rows = rowsAt(scene, cost), line = [String(scene.name ?? MISSING)];
    for (const n of [8, 32]) {
        const theirs = find(rows, "simple_complex", n), twice = find(rows, "agaa", n, 2), ids = tierRow(rows, n, "ids");
        for (const row of [twice, tierRow(rows, n, "gbuffer"), ids])
            line.push(againstSimpleComplex(scene, row, theirs));
        line.push(ratioText(ratio(ids && frameMs(ids), twice && frameMs(twice))));
    }
    return line;
}

function showOnePass(backend, cost) {
    const lines = scenesOf(backend).map((scene) => onePassLine(scene, cost))
        .filter((line) => line.slice(1).some((cell) => (cell.text ?? cell) !== MISSING));
    const heads = [8, 32].flatMap((n) => ["two passes", "G-buffer", "by id", "id ÷ two"].map((head) => `${head}, n=${n}`));
    fill("one-pass", lines.length ? tableOf(`Frame time of simple_complex by that of agaa c=2 in all scenes, lighting ${cost}×; `
        + "below it mseTm against the reference, agaa's by simple_complex's, 1 where the reference cannot tell them apart. Above 1× agaa is quicker. id ÷ two: the frame by id "
        + "by that of two passes.", ["<scene", ...heads], lines)
        : absent("This sweep has no rows of simple_complex and agaa at n = 8 or 32 to set beside each other."));
}

function median(values) {
    const sorted = [...values].sort((a, b) => a - b), half = sorted.length >> 1;
    return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

// Returns the median over the scenes, with the smallest and the largest value and its scene.
function overScenes(scenes, value, text) {
    const known = scenes.map((scene) => ({scene, value: value(rowsAt(scene, 1), scene)})).filter((one) => one.value !== null);
    if (!known.length)
        return MISSING;
    const all = known.map((one) => one.value), most = Math.max(...all);
    const span = spanText(all, text);
    return {text: text(median(all)), note: span === text(most) ? ""
        : `${span} (${known.find((one) => one.value === most).scene.name ?? MISSING})`};
}

function showPresets(backend) {
    const scenes = scenesOf(backend), kinds = new Map();
    for (const row of scenes.flatMap((scene) => rowsAt(scene, 1)).filter((one) => one.preset)) {
        const tier = field(row, "tiers", "generation");
        const name = [row.preset, ONE_PASS[tier] ?? "by two passes", `n=${row.n}`].join(" ");
        kinds.set(name, {n: row.n, same: (one) => one.preset === row.preset && one.n === row.n
            && field(one, "tiers", "generation") === tier});
    }
    if (!kinds.size) {
        fill("presets", absent("This sweep has no rows of presets."));
        return;
    }
    const set = (kind, other, of) => (rows, scene) => {
        const row = rows.find(kind.same), base = other(rows, kind.n);
        return row && base ? of(row, base, scene) : null;
    };
    const by = (kind, of, other) => set(kind, other, (row, base) => ratio(of(row), of(base)));
    const twice = (rows, n) => find(rows, "agaa", n, 2);
    const paper = (rows, n) => rows.find((row) => row.preset === "paper" && row.n === n);
    const share = (kind) => (rows) => {
        const row = rows.find(kind.same), single = find(rows, "single", 1);
        return ratio(row ? errorOf(row, METRICS["mseTm-ssaa"]) : null, single ? errorOf(single, METRICS.mseTm) : null);
    };
    const ssaa = (rows, n) => find(rows, "ssaa", n);
    const toReference = (row, base, scene) => errorRatio(scene, METRICS.mseTm, errorOf(row, METRICS.mseTm), errorOf(base, METRICS.mseTm));
    const over = (key) => (row, base) => temporalRatio(row, base, key);
    fill("presets", tableOf("Presets over all scenes, lighting 1×: the median, below it the least to the greatest. Frames and "
        + "shading events by those of agaa c=2 by two passes at the same n; mseTm against ssaa at the same n by that of single "
        + "against the reference, and against the reference by that of ssaa at the same n; bias² and variance over shifts of parts "
        + "of a pixel by those of the preset paper at the same n. The last three are 1 where the references cannot tell them apart.",
    ["<preset", "frame", "events", "mseTm ÷ single", "÷ ssaa, reference", "bias² ÷ paper", "variance ÷ paper"],
    [...kinds].map(([name, kind]) => [name,
        overScenes(scenes, by(kind, frameMs, twice), ratioText), overScenes(scenes, by(kind, eventsOf, twice), ratioText),
        overScenes(scenes, share(kind), significant),
        overScenes(scenes, set(kind, ssaa, toReference), ratioText),
        overScenes(scenes, set(kind, paper, over("biasSquared")), ratioText),
        overScenes(scenes, set(kind, paper, over("variance")), ratioText)])));
}
