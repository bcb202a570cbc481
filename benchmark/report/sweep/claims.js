// Compares the claims of the AGAA paper with this run, over all scenes of the backend.

// A claim that the value of each scene must meet; null if no scene has the value.
function judged(claim, scenes, value, isMet, cause, text = ratioText) {
    const measured = scenes.map((scene) => ({scene, value: value(scene)})).filter((one) => one.value !== null);
    if (!measured.length)
        return null;
    const broken = measured.filter((one) => !isMet(one.value));
    const names = broken.map((one) => `${one.scene.name ?? MISSING} ${text(one.value)}`).join(", ");
    return [claim, spanText(measured.map((one) => one.value), text),
        broken.length ? `on ${measured.length - broken.length} of ${measured.length}; not on ${names}`
            : `on all ${measured.length}`,
        broken.length ? cause(broken.map((one) => one.scene)) : ""];
}

// A claim that the value of the best scene must meet.
function best(claim, scenes, value, least, cause) {
    const measured = scenes.map((scene) => ({scene, value: value(scene)})).filter((one) => one.value !== null);
    if (!measured.length)
        return null;
    const top = measured.reduce((a, b) => b.value > a.value ? b : a);
    return [claim, spanText(measured.map((one) => one.value)), `${top.value >= least ? "" : "not "}on ${top.scene.name ?? MISSING}`,
        top.value >= least ? "" : cause([top.scene])];
}

const pairsAt = (scene, n, cost = 1) => pairAt(rowsAt(scene, cost), n);

// States how the ratio grows when lighting is most of the work: then the other passes limit it.
function heavierLighting(scenes, n, key) {
    for (const cost of [16, 4]) {
        const values = scenes.map((scene) => pairsAt(scene, n, cost)[key]).filter((value) => value !== null);
        if (values.length)
            return `with lighting ${cost}× heavier ${spanText(values)}`;
    }
    return "heavier lighting was not measured";
}

function geometrySpan(scenes, n) {
    const shares = scenes.map((scene) => geometryShare(find(rowsAt(scene, 1), "agaa", n, 2))).filter((share) => share !== null);
    return shares.length ? spanText(shares, percent) : null;
}

const shadingCause = (n, key) => (scenes) => "work that both do once a pixel, such as shadows of all samples, weighs as much as "
    + `the lighting: ${heavierLighting(scenes, n, key)} on these`;
const frameCause = (n) => (scenes) => {
    const share = geometrySpan(scenes, n);
    const passes = scenes.map((scene) => finite(pairsAt(scene, n).ours?.geometryPasses) ?? 0);
    return (Math.max(...passes) > 1 ? "the second geometry pass" : "geometry")
        + (share ? `: prepass and generation are ${share} of agaa's frame` : "") + `; ${heavierLighting(scenes, n, "frame")}`;
};

function errorShare(s) {
    return (scene) => {
        const rows = rowsAt(scene, 1), metric = METRICS["mseTm-ssaa"];
        const ours = find(rows, "agaa", 8, 2), theirs = find(rows, "sbaa", 8, s);
        return ratio(ours && errorOf(ours, metric), theirs && errorOf(theirs, metric));
    };
}
// Compares agaa c=2 with a technique at c or S.
const saved = (n, technique, c) => (scene) => {
    const bytes = (row) => finite(row?.bytesPerPixel), rows = rowsAt(scene, 1);
    const left = ratio(bytes(find(rows, "agaa", n, 2)), bytes(find(rows, technique, n, c)));
    return left === null ? null : 1 - left;
};
const memoryCause = (n) => () => "bytes as allocated: without the paper's formats and mixed samples, records of surfaces and "
    + `aggregates are words of a buffer; by the paper's layouts ${percent(1 - paperBytes.agaa(n, 2) / paperBytes.sbaa(n, 2))}`;
const errorCause = () => "one lobe, round and wide, stands for all normals of an aggregate, where sbaa keeps exact ones: on most of the "
    + "scenes where it happens on lavapipe it does not without specular light (docs/results/lavapipe/causes.md, by benchmark/causes.py)";
const eventsCause = () => `nearly all pixels of the paper's scene are complex: ${paperFigures.agaa.events.simpleComplex} events of 8`;

function showClaims(backend) {
    const scenes = scenesOf(backend), atLeast = (least) => (value) => value >= least, atMost = (most) => (value) => value <= most;
    const atLeastPercent = (least) => (value) => Math.round(100 * value) >= least;
    const lines = [
        judged("shading at least 2× faster than simple/complex, n = 8", scenes, (s) => pairsAt(s, 8).shading, atLeast(2),
            shadingCause(8, "shading")),
        judged("shading at least 2.23× faster, n = 32 (table 1)", scenes, (s) => pairsAt(s, 32).shading, atLeast(2.23),
            shadingCause(32, "shading")),
        best("shading up to 3.5× faster on the best scene, n = 8 (§5.3)", scenes, (s) => pairsAt(s, 8).shading, 3.5,
            shadingCause(8, "shading")),
        best("shading up to 9.2× faster on the best scene, n = 32 (§5.3)", scenes, (s) => pairsAt(s, 32).shading, 9.2,
            shadingCause(32, "shading")),
        judged("shading events below 25 % of simple/complex's, n = 8 (§5.2)", scenes, (s) => pairsAt(s, 8).eventShare,
            (value) => value < 0.25, eventsCause, percent),
        judged("shading events at most 45 % of SBAA's at S = 6, n = 8 (§5.2)", scenes, (s) => ratio(
            eventsOf(find(rowsAt(s, 1), "agaa", 8, 2)), eventsOf(find(rowsAt(s, 1), "sbaa", 8, 6))), atMost(0.45), eventsCause,
            percent),
        judged("0.64 of the ratio of shading events is gained in time, n = 8 (from table 1 and the slides' counts, Old City)", scenes, (s) => pairsAt(s, 8).efficiency,
            atLeast(0.64), shadingCause(8, "efficiency")),
        judged("no less of it at n = 32 (ours to ask; the paper has no counts there)", scenes, (s) => pairsAt(s, 32).efficiency,
            atLeast(0.64), shadingCause(32, "efficiency")),
        judged("frames faster than simple/complex on every scene, n = 8 (table 1, with 1.00 on Fur Ball)", scenes, (s) => pairsAt(s, 8).frame, atLeast(1),
            frameCause(8)),
        judged("frames faster than simple/complex on every scene, n = 32 (table 1, with 1.00 on Fur Ball)", scenes, (s) => pairsAt(s, 32).frame, atLeast(1),
            frameCause(32)),
        judged("30 % less memory than deferred supersampling, n = 8 (abstract)", scenes, saved(8, "ssaa"), atLeastPercent(30),
            () => "", percent),
        judged("54 % less memory than deferred supersampling, n = 32 (abstract)", scenes, saved(32, "ssaa"), atLeastPercent(54),
            () => "", percent),
        ...[[8, 19], [16, 24], [32, 27]].map(([n, share]) => judged(
            `${share} % less memory than SBAA, two aggregates by two surfaces, n = ${n}`, scenes, saved(n, "sbaa", 2),
            atLeastPercent(share), memoryCause(n), percent)),
        judged("two aggregates are as good as four surfaces of SBAA, n = 8", scenes, errorShare(4), atMost(1), errorCause),
    ].filter((line) => line);
    if (!lines.length) {
        fill("claims", absent("This sweep has no rows that the paper's claims are about."));
        return;
    }
    const table = tableOf("Claims of the AGAA paper, and whether they hold in this run", ["<claim", "<ours", "<holds", "<why not"],
        lines);
    table.classList.add("words");
    fill("claims", table);
}
