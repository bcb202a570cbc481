// Techniques with and without a history in moving scenes (benchmark/motion.py), and animated images of them.

const motions = JSON.parse(document.getElementById("motions").textContent);
const motionViews = () => dicts(motions.views);

function motionTable(view) {
    const rows = dicts(view.rows), base = rows[0] ?? {};
    const hasGhosts = finite(base.ghosting) !== null;
    const times = (of) => (row) => significant(ratio(finite(of(row)), finite(of(base))), 2);
    const columns = [["error", times((row) => row.error)], ["flicker, thousandths", (row) => finite(row.flicker) === null ? MISSING : significant(1000 * row.flicker, 2)],
        ...(hasGhosts ? [["ghosting", times((row) => row.ghosting)]] : []),
        ["sharpness", (row) => significant(row.sharpness, 2)], ["time", times((row) => row.frameMs)],
        ["bytes a pixel", (row) => significant(row.bytesPerPixel)]];
    return tableOf("Error, ghosting and time by those of single; a sharpness of 1 is that of the reference",
        ["<view", ...columns.map(([name]) => name)],
        rows.map((row, i) => [String(row.name ?? i), ...columns.map(([, of]) => of(row))]));
}

function showMotion() {
    const view = motionViews()[Number(byId("motion-view").value)];
    if (!view) {
        fill("motion", absent("The page holds no moving scene."));
        return;
    }
    const parts = [];
    if (finite(view.image) !== null)
        parts.push(element("img", {className: "motion", src: imageUrl(view.image), alt: `${view.name ?? MISSING}, ${view.motion ?? MISSING}: reference, single, taa, agaa`}));
    parts.push(element("p", {className: "hint", textContent: `The figures: ${view.device ?? MISSING}, ${motions.size ?? MISSING} pixels, ${view.frames ?? MISSING} `
        + `frames, references of ${view.spp ?? MISSING} samples, whose own error is ${significant(ratio(view.referenceMseTm, view.rows?.[0]?.error), 2)} of that of single.`}));
    fill("motion", ...parts, motionTable(view));
}

function startMotion() {
    const api = (view) => view.backend === "gl" ? "OpenGL" : "Vulkan";
    setOptions(byId("motion-view"), motionViews().map((view, i) => ({value: String(i), text: `${view.name ?? MISSING}, ${view.motion ?? MISSING}, ${api(view)}`})), "0");
    byId("motion-view").addEventListener("change", showMotion);
    showMotion();
}
