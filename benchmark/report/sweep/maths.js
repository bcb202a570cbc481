// What the page works out of the rows.

// Rows that no other beats in both: none is as quick with less error, nor as exact in less time.
function paretoFront(points) {
    const front = [];
    for (const point of [...points].sort((a, b) => a.x - b.x || a.y - b.y)) {
        if (!front.length || point.y < front[front.length - 1].y)
            front.push(point);
    }
    return front;
}

const least = (rows, of) => rows.reduce((best, row) => best === null || of(row) < of(best) ? row : best, null);
const timed = (rows, metric) => rows.filter((row) => frameMs(row) > 0 && errorOf(row, metric) !== null);

// For the frame time of each ssaa row: by technique, the row of least error that takes no longer.
function equalTime(rows, metric) {
    const usable = timed(rows, metric);
    return usable.filter((row) => row.technique === "ssaa")
        .sort((a, b) => frameMs(a) - frameMs(b))
        .map((budget) => {
            const within = usable.filter((row) => frameMs(row) <= frameMs(budget));
            const best = new Map();
            for (const technique of unique(within.map(techniqueOf)))
                best.set(technique, least(within.filter((row) => techniqueOf(row) === technique),
                                          (row) => errorOf(row, metric)));
            return {budget, best, winner: least([...best.values()], (row) => errorOf(row, metric))};
        });
}

// For the error of each ssaa and simple_complex row: by technique, the quickest row that errs no
// more, and the quickest whose error is no different where that is a quicker one.
function equalQuality(rows, metric, gap) {
    const usable = timed(rows, metric);
    return usable.filter((row) => row.technique === "ssaa" || row.technique === "simple_complex")
        .sort((a, b) => errorOf(b, metric) - errorOf(a, metric))
        .map((target) => {
            const error = errorOf(target, metric);
            const reached = new Map(), alike = new Map();
            for (const technique of unique(usable.map(techniqueOf))) {
                const own = usable.filter((row) => techniqueOf(row) === technique);
                const strict = least(own.filter((row) => errorOf(row, metric) <= error), frameMs);
                const loose = least(own.filter((row) => errorOf(row, metric) < error + gap), frameMs);
                if (strict)
                    reached.set(technique, strict);
                if (loose && (!strict || frameMs(loose) < frameMs(strict)))
                    alike.set(technique, loose);
            }
            return {target, reached, alike, winner: least([...reached.values()], frameMs)};
        });
}

// Stages of a row that took time, in the order of a frame.
const STAGES = ["prepass", "shadowmap", "definition", "generation", "shading", "post", "other"];
function stagesOf(row) {
    const times = row.stageMs && typeof row.stageMs === "object" ? row.stageMs : {};
    const out = {};
    for (const [stage, ms] of Object.entries(times)) {
        if (finite(ms) > 0) {
            const known = STAGES.includes(stage) ? stage : "other";
            out[known] = (out[known] ?? 0) + ms;
        }
    }
    return out;
}

// The papers' way of a technique: no preset, and not from a G-buffer or by id.
const isPlain = (row) => !row.preset && !["gbuffer", "ids"].includes(field(row, "tiers", "generation"));
const find = (rows, technique, n, c) => rows.find((row) => row.technique === technique && row.n === n
    && (c === undefined || row.c === c) && isPlain(row)) ?? null;
