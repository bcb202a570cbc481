// The controls of the page, and drawing for their values.

const chosen = () => {
    const backend = backendsOf()[Number(byId("backend").value)] ?? {};
    const scene = scenesOf(backend)[Number(byId("scene").value)] ?? {};
    const cost = Number(byId("cost").value) || 1;
    return {backend, scene, cost, rows: rowsAt(scene, cost), metric: METRICS[byId("metric").value] ?? METRICS.mseTm};
};

function showHead(backend, scene) {
    const size = results.size ? ` · ${String(results.size).replace("x", "×")} pixels` : "";
    byId("device").textContent = `Device: ${backend.device ?? MISSING} · Driver: ${backend.driver ?? MISSING}${size}`;
    const notes = [];
    if (results.quick)
        notes.push("This is a quick sweep: fewer rows, and each of fewer frames, than a claim should rest on.");
    if (SOFTWARE.test(`${backend.device} ${backend.driver}`))
        notes.push("These frames were drawn by a software rasteriser. Its milliseconds say nothing about a graphics card; compare "
            + "them with each other only. Errors, bytes and shading events do not depend on its speed.");
    if (!backendsOf().some((one) => scenesOf(one).length))
        notes.push("These results hold no scene.");
    fill("notes", ...notes.map((textContent) => element("p", {className: "note", textContent})));
    byId("scene-name").textContent = scene.name ?? "No scene";
    const facts = [scene.stresses, finite(scene.triangles) !== null && `${scene.triangles.toLocaleString("en")} triangles`,
        finite(scene.lights) !== null && `${scene.lights} lights`,
        field(scene, "reference", "spp") && `reference of ${scene.reference.spp} samples a pixel, its own mseTm `
            + errorText(field(scene, "reference", "splitHalfMseTm"), METRICS.mseTm),
        scene.build && `measured by build ${scene.build}`,
        finite(scene.pixelsPerDegree) !== null && `FLIP at ${significant(scene.pixelsPerDegree)} pixels a degree`];
    byId("scene-facts").textContent = facts.filter((fact) => fact).join(" · ");
}

function showCharts() {
    const {backend, scene, rows, metric} = chosen();
    showPareto(scene, rows, metric);
    showStages(backend, rows);
    showTemporal(rowsOf(scene).filter((row) => costOf(row) === 1));
}

function showErrors() {
    const {scene, rows, metric} = chosen();
    showPareto(scene, rows, metric);
    showEqualTime(scene, rows, metric);
    showEqualQuality(scene, rows, metric);
}

function showCost() {
    const {backend, scene, cost, rows} = chosen();
    showErrors();
    showStages(backend, rows);
    showMemory(rows);
    showOnePass(backend, cost);
    showPapers(backend, scene, rows, cost);
}

function showScene() {
    const {backend, scene} = chosen();
    const costs = unique(rowsOf(scene).map(costOf)).sort((a, b) => a - b);
    setOptions(byId("cost"), costs.map((cost) => ({value: String(cost), text: cost + "×"})), "1");
    showHead(backend, scene);
    showGpus(backend, scene);
    showCost();
    showTemporal(rowsOf(scene).filter((row) => costOf(row) === 1));
    showCompare(scene);
}

function showBackend() {
    const {backend} = chosen();
    // The scene stays selected if the other backend also has it.
    const name = byId("scene").selectedOptions[0]?.textContent;
    const scenes = scenesOf(backend).map((scene, i) => ({value: String(i), text: String(scene.name ?? `scene ${i + 1}`)}));
    setOptions(byId("scene"), scenes, "0");
    const same = scenes.find(({text}) => text === name);
    byId("scene").value = same?.value ?? scenes[0]?.value ?? "";
    showClaims(backend);
    showPresets(backend);
    showAblation(chosen().backend);
    showScene();
}

const backendNames = {vk: "Vulkan", gl: "OpenGL"};
setOptions(byId("backend"), backendsOf().map((backend, i) =>
    ({value: String(i), text: backendNames[backend.backend] ?? String(backend.backend ?? `backend ${i + 1}`)})), "0");
setOptions(byId("metric"), Object.entries(METRICS).map(([value, {name}]) => ({value, text: name})), "mseTm");
byId("backend").addEventListener("change", showBackend);
byId("scene").addEventListener("change", showScene);
byId("cost").addEventListener("change", showCost);
byId("metric").addEventListener("change", showErrors);
byId("stage-n").addEventListener("change", () => showStages(chosen().backend, chosen().rows));
darkScheme.addEventListener("change", showCharts);
window.addEventListener("resize", resizeCompare);
showBackend();
startMotion();
