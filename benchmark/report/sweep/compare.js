// Two images under one slider; the right one may be their difference or a map of shading events.

const compare = {zoom: "fit", work: 0};
const imageUrl = (id) => {
    const text = byId("image-" + id).textContent;
    const kind = text.startsWith("/9j/") ? "jpeg" : text.startsWith("UklGR") ? "webp" : "png"; // FF D8 FF, RIFF
    return `data:image/${kind};base64,` + text;
};

// Returns the entries of a scene that have an image: {name, image, heat, difference}.
function choicesOf(scene) {
    const shown = sortedRows(rowsOf(scene)).map((row) => ({name: label(row), row, image: row.image, heat: row.heat,
        difference: row.difference}));
    shown.unshift({name: "reference" + (field(scene, "reference", "spp") ? `, ${scene.reference.spp} samples` : ""),
        image: scene.referenceImage, reference: true});
    return shown.filter((choice) => finite(choice.image) !== null);
}

function loaded(id) {
    const image = new Image();
    image.src = imageUrl(id);
    return image.decode().then(() => image);
}

// Returns the absolute difference of two images, multiplied by four, as a URL.
async function differenceUrl(first, second) {
    const images = await Promise.all([loaded(first), loaded(second)]);
    const canvas = element("canvas", {width: images[0].naturalWidth, height: images[0].naturalHeight});
    const context = canvas.getContext("2d", {willReadFrequently: true});
    const pixels = images.map((image) => {
        context.clearRect(0, 0, canvas.width, canvas.height);
        context.drawImage(image, 0, 0, canvas.width, canvas.height);
        return context.getImageData(0, 0, canvas.width, canvas.height);
    });
    const [a, b] = pixels.map((data) => data.data);
    for (let i = 0; i < a.length; ++i)
        a[i] = i % 4 === 3 ? 255 : Math.min(255, 4 * Math.abs(a[i] - b[i]));
    context.putImageData(pixels[0], 0, 0);
    return canvas.toDataURL();
}

function rightModes(left, right, reference) {
    return [
        {value: "image", text: "the image"},
        {value: "between", text: "left − right, 4×"},
        {value: "reference", text: "difference to the reference, 4×",
            disabled: !reference && finite(right.difference) === null},
        {value: "heat", text: "shading events", disabled: finite(right.heat) === null},
    ];
}

function resizeCompare() {
    const slider = byId("slider");
    if (!slider)
        return;
    const natural = Number(slider.dataset.width) || 640;
    const room = byId("compare").clientWidth - 2;
    const tallest = 0.8 * window.innerHeight * (Number(slider.dataset.shape) || 1);
    const fitting = Math.max(100, Math.min(room, tallest, 2 * natural));
    const fits = compare.zoom === "fit";
    slider.style.width = Math.round(fits ? fitting : natural * Number(compare.zoom)) + "px";
    slider.classList.toggle("magnified", slider.offsetWidth >= natural);
    // On a touch screen, a finger scrolls a picture larger than its frame. The handle moves the line.
    slider.handle = !fits && slider.offsetWidth > room;
    const frame = slider.parentElement;
    frame.scrollLeft = (frame.scrollWidth - frame.clientWidth) / 2;
    frame.scrollTop = (frame.scrollHeight - frame.clientHeight) / 2;
}

async function updateCompare(scene, choices) {
    showNumbers(scene, choices[Number(byId("right").value)].row);
    const left = choices[Number(byId("left").value)], right = choices[Number(byId("right").value)];
    const reference = choices.find((choice) => choice.reference);
    setOptions(byId("mode"), rightModes(left, right, reference), "image");
    const mode = byId("mode").value, work = ++compare.work;
    let url = imageUrl(right.image);
    if (mode === "heat")
        url = imageUrl(right.heat);
    else if (mode === "between")
        url = await differenceUrl(left.image, right.image);
    else if (mode === "reference")
        url = reference ? await differenceUrl(right.image, reference.image) : imageUrl(right.difference);
    const first = await loaded(left.image);
    // A choice that was made while the pictures were computed takes precedence.
    if (work !== compare.work)
        return;
    byId("slider").dataset.width = first.naturalWidth;
    byId("slider").dataset.shape = first.naturalWidth / first.naturalHeight;
    byId("slider-left").src = first.src;
    byId("slider-right").src = url;
    const words = {image: "", between: "left − this: ", reference: "difference to the reference: ", heat: "shading events: "};
    byId("slider-left").alt = left.name;
    byId("slider-right").alt = words[mode] + right.name;
    byId("side-left").textContent = "◀ " + left.name;
    byId("side-right").textContent = words[mode] + right.name + " ▶";
    byId("slider").dataset.mode = mode;
    resizeCompare();
}

function showCompare(scene) {
    const choices = choicesOf(scene);
    if (!choices.length) {
        ++compare.work;
        fill("compare", absent("The page holds no images of this scene."));
        return;
    }
    const options = choices.map(({name}, i) => ({value: String(i), text: name}));
    const pick = (technique, n, c) => choices.findIndex(({row}) => row && row.technique === technique
        && (n === undefined || row.n === n) && (c === undefined || row.c === c));
    const first = (...indices) => String(Math.max(0, indices.find((index) => index >= 0) ?? 0));
    const selects = ["left", "right", "mode"].map((id) => element("select", {id, autocomplete: "off"}));
    setOptions(selects[0], options, first(pick("single"), pick("ssaa", 8), 0));
    setOptions(selects[1], options, first(pick("agaa", 8, 2), pick("agaa"), choices.length - 1));
    const budget = element("select", {id: "budget", autocomplete: "off"});
    setOptions(budget, budgetOptions(), "3");
    budget.value = byId("budget")?.value ?? "3"; // of the scene before
    const zooms = ["fit", "1", "2", "4"].map((zoom) => element("button",
        {type: "button", textContent: zoom === "fit" ? "Fit" : zoom + "×", value: zoom}));
    const pressed = () => zooms.forEach((button) => button.setAttribute("aria-pressed", String(button.value === compare.zoom)));
    for (const button of zooms) {
        button.addEventListener("click", () => {
            compare.zoom = button.value;
            pressed();
            resizeCompare();
        });
    }
    pressed();
    const slider = element("img-comparison-slider", {id: "slider"},
        element("img", {id: "slider-left", slot: "first", draggable: false}),
        element("img", {id: "slider-right", slot: "second", draggable: false}),
        element("div", {className: "grip", slot: "handle", textContent: "◂ ▸"}));
    fill("compare",
        element("div", {className: "controls inner"},
            element("label", {}, "Least error within ", budget), ...["Left", "Right", "Right shows"].map((words, i) => element("label", {}, words + " ", selects[i])),
            element("div", {className: "zoom"}, ...zooms)),
        element("dl", {className: "numbers", id: "numbers"}),
        element("div", {className: "view"},
            element("div", {className: "sides"}, element("span", {id: "side-left"}), element("span", {id: "side-right"})),
            element("div", {className: "frame"}, slider)),
        element("p", {className: "hint", textContent: "Drag the line, or use the arrow keys on it. Brighter pixels of the map "
            + "of shading events were lit more often." + (results.imagesLeftOut ? ` ${results.imagesLeftOut} images of this sweep `
            + "are not on this page, which takes a part of those beside its results to stay small." : "")}));
    const applyBudget = () => {
        const best = budget.value === "own" ? -1 : bestWithin(scene, choices, budget.value);
        if (best >= 0)
            selects[1].value = String(best);
        else
            budget.value = "own"; // no image on the page is of such a row
        updateCompare(scene, choices);
    };
    budget.addEventListener("change", applyBudget);
    for (const select of selects)
        select.addEventListener("change", () => {
            if (select === selects[1])
                budget.value = "own";
            updateCompare(scene, choices);
        });
    applyBudget();
}
