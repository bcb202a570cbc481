// Tables of one scene, and of the effects in all scenes.

const noDifference = "no difference";

function showEqualTime(scene, rows, selected) {
    const metric = referenceMetric(selected), gap = smallestGap(scene, metric);
    const budgets = equalTime(rows, metric);
    if (!budgets.length) {
        fill("equal-time", absent("There is no row of ssaa with a frame time, whose time others could be given."));
        return;
    }
    const techniques = inOrder(budgets.flatMap(({best}) => [...best.keys()]));
    const table = tableOf(`Least ${metric.name} of each technique within the frame time of ssaa. ★ is the least of all; `
        + `“${noDifference}” is too near to it to tell apart. taa is left out: its history converges before a still camera.`,
    ["<no longer than", "ms", ...techniques], budgets.map(({budget, best, winner}) => [
        label(budget), msText(frameMs(budget)), ...techniques.map((technique) => {
            const row = best.get(technique);
            if (!row)
                return MISSING;
            const error = errorOf(row, metric);
            const same = row !== winner && error - errorOf(winner, metric) < gap;
            return {text: errorText(error, metric) + (row === winner ? " ★" : ""),
                note: label(row).slice(technique.length) + (same ? " · " + noDifference : ""),
                className: row === winner || same ? "best" : ""};
        })]));
    table.id = "equal-time-table";
    fill("equal-time", table);
}

function showEqualQuality(scene, rows, selected) {
    const metric = referenceMetric(selected);
    const targets = equalQuality(rows, metric, smallestGap(scene, metric));
    if (!targets.length) {
        fill("equal-quality", absent("There is no row of ssaa or simple_complex with an error to reach."));
        return;
    }
    const techniques = inOrder(targets.flatMap(({reached, alike}) => [...reached.keys(), ...alike.keys()]));
    fill("equal-quality", tableOf(`Least frame time, ms, in which each technique reaches the ${metric.name} of a row of ssaa or `
        + `simple_complex. ★ is the quickest; “~” errs more, by less than can be told apart.`,
    ["<error of", "at most", ...techniques], targets.map(({target, reached, alike, winner}) => [
        label(target), errorText(errorOf(target, metric), metric), ...techniques.map((technique) => {
            const row = reached.get(technique), near = alike.get(technique);
            const nearly = near && `~ ${msText(frameMs(near))}${label(near).slice(technique.length)}`;
            if (!row)
                return near ? {text: "~ " + msText(frameMs(near)), note: label(near).slice(technique.length)} : MISSING;
            return {text: msText(frameMs(row)) + (row === winner ? " ★" : ""),
                note: label(row).slice(technique.length) + (nearly ? " · " + nearly : ""),
                className: row === winner ? "best" : ""};
        })])));
}

function showMemory(rows) {
    if (!rows.length) {
        fill("memory", absent("This scene has no rows."));
        return;
    }
    const bytes = (row) => finite(row?.bytesPerPixel);
    fill("memory", tableOf("Memory of a technique's buffers and the work of a frame. ÷ sbaa sets agaa at c beside sbaa at "
        + "S = c; MiB are of 1920×1080 pixels.",
    ["<row", "bytes/px", "peak", "MiB", "÷ ssaa", "÷ sbaa", "events/px", "of covered", "shadow taps/px", "geometry passes",
        "aggregates/px", "primitives/px", "materials/px", "widened/px", "frame ms", "p95", "<median within", "<tiers"],
    sortedRows(rows).map((row) => [
        label(row), significant(bytes(row)), significant(finite(row.peakBytesPerPixel)),
        bytes(row) === null ? MISSING : (bytes(row) * 1920 * 1080 / (1 << 20)).toFixed(0),
        ratioText(ratio(bytes(row), bytes(find(rows, "ssaa", row.n)))),
        row.technique === "agaa" ? ratioText(ratio(bytes(row), bytes(find(rows, "sbaa", row.n, row.c)))) : MISSING,
        significant(row.eventsPerPixel), significant(row.eventsPerCoveredPixel), significant(row.shadowTapsPerPixel),
        significant(row.geometryPasses), significant(row.aggregatesPerPixel), significant(row.primitivesPerPixel),
        significant(row.materialsPerPixel), significant(row.widenedLobesPerPixel), msText(frameMs(row)),
        msText(field(row, "frameMs", "p95")), boundsText(row.frameMs) ?? MISSING, tiersOf(row) || MISSING])));
}

// Errors are against ssaa at the same n, which itself has none.
function removedText(on, off) {
    if (on === null || off === null)
        return MISSING;
    if (off === on)
        return noDifference;
    if (off === 0)
        return "adds all of it";
    const share = 100 * Math.abs(off - on) / off;
    return on < off ? `removes ${share.toFixed(0)} %` : `adds ${share.toFixed(0)} %`;
}

// Compares frame times with an effect and without it.
function costCell(on, off) {
    const text = ratioText(ratio(finite(on?.median), finite(off?.median)));
    const alike = on?.low <= off?.high && off?.low <= on?.high;
    return {text, note: alike ? noDifference : ""};
}

function showAblation(backend) {
    const entries = allScenesOf(backend).flatMap((scene) => dicts(scene.ablation).map((entry) => ({scene, entry})));
    if (!entries.length) {
        fill("ablation", absent("This sweep has not switched effects off."));
        return;
    }
    const names = unique(entries.map(({entry}) => String(entry.effect ?? "unnamed")));
    const place = ({entry}) => names.indexOf(String(entry.effect ?? "unnamed")) * 2 + (entry.calledFor ? 0 : 1);
    entries.sort((a, b) => place(a) - place(b));
    const frames = unique(entries.map(({entry}) => finite(field(entry, "on", "frameMs", "frames"))).filter((n) => n !== null));
    fill("ablation", tableOf("Cost is the frame time with the effect by that without it, medians of "
        + `${frames.join(" or ") || "some"} frames in turns; “${noDifference}” where the one's least and greatest overlap the `
        + "other's. Error is mseTm against ssaa at the same n with all effects.",
        ["<effect", "<scene", "<called for", "n", "c", "ms with", "without", "cost", "error with", "without", "<error"],
        entries.map(({scene, entry}) => {
            const ms = (side) => finite(field(entry, side, "frameMs", "median"));
            const error = (side) => finite(field(entry, side, "mseTm"));
            const of = [entry.preset, entry.tier === "auto" ? "" : entry.tier].filter(Boolean);
            const verdict = removedText(error("on"), error("off"));
            return [String(entry.effect ?? "unnamed"), String(scene.name ?? MISSING), entry.calledFor ? "yes" : "no",
                significant(entry.n), significant(entry.c) + (of.length ? ` (${of.join(", ")})` : ""), msText(ms("on")), msText(ms("off")),
                costCell(field(entry, "on", "frameMs"), field(entry, "off", "frameMs")), errorText(error("on"), METRICS.mseTm),
                errorText(error("off"), METRICS.mseTm), {text: verdict, className: verdict.startsWith("removes") ? "best" : ""}];
        })));
}
