// Figures that the page computes from the rows.

// Returns the Pareto front: rows for which none is as quick with less error, nor as exact in less time.
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
// The history of "taa" converges, because the camera of a sweep stands still: its errors are not those of a moving camera.
const isComparable = (row) => row.technique !== "taa";

// For the frame time of each ssaa row, returns the row of least error of each technique that takes no longer.
function equalTime(rows, metric) {
    const usable = timed(rows, metric).filter(isComparable);
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

// For the error of each ssaa and simple_complex row, returns the quickest row of each technique with no larger error, and
// the quickest row whose error is not different if that one is quicker.
function equalQuality(rows, metric, gap) {
    const usable = timed(rows, metric).filter(isComparable);
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

// Returns the stages of a row that took time, in the order of a frame.
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

// Returns whether a row has the papers' configuration: no preset, and not from a G-buffer or by id.
const isPlain = (row) => !row.preset && !["gbuffer", "ids"].includes(field(row, "tiers", "generation"));
const find = (rows, technique, n, c) => rows.find((row) => row.technique === technique && row.n === n
    && (c === undefined || row.c === c) && isPlain(row)) ?? null;
