// Frames of GPUs (benchmark/gpu_run.py) beside those of the sweep.

const gpus = dicts(JSON.parse(document.getElementById("gpus").textContent));

// Presets choose c themselves.
const settingsOf = (row, tier) => [row.technique, row.n, row.preset ? 0 : row.c ?? 0, row.preset ?? "", tier ?? ""].join("/");

function gpuTable(gpu, backend, scene) {
    const there = new Map(dicts(gpu.frames).filter((frame) => frame.scene === scene.name && !frame.way)
        .map((frame) => [settingsOf(frame, frame.tier), finite(frame.ms)]));
    const rows = rowsAt(scene, 1).filter((row) => there.has(settingsOf(row, row.tiers?.generation)));
    const rival = rows.find((row) => row.technique === "ssaa" && row.n === 8);
    if (!rival)
        return null;
    const gpuMs = (row) => there.get(settingsOf(row, row.tiers?.generation));
    return tableOf(`Frames by those of ssaa n=8 of the same device. ${gpu.device}: ${gpu.size}, sums of the passes; its build was not recorded`,
        ["<row", `${gpu.device}`, `${backend.device ?? MISSING}`],
        sortedRows(rows).map((row) => [label(row), significant(ratio(gpuMs(row), gpuMs(rival)), 2),
            significant(ratio(frameMs(row), frameMs(rival)), 2)]));
}

function showGpus(backend, scene) {
    const tables = gpus.filter((gpu) => gpu.backend === backend.backend).map((gpu) => gpuTable(gpu, backend, scene)).filter((table) => table);
    fill("gpus-table", ...(tables.length ? tables : [absent("The page holds no frames of a GPU for this scene.")]));
}
