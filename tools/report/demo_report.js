"use strict";
for (const viewer of document.querySelectorAll(".viewer")) {
    const find = (selector) => viewer.querySelector(selector);
    const view = find(".view"), frame = find(".frame"), stage = find(".stage"), divider = find(".divider");
    const left = find("img.left"), right = find("img.right");
    const pickLeft = find("select.left"), pickRight = find("select.right");
    const split = find(".split"), difference = find(".difference");
    const zooms = viewer.querySelectorAll(".zoom button");
    let zoom = "fit";

    // The split is a share of what is visible, so that a magnified image never scrolls it away.
    const place = () => {
        const visible = Math.min(frame.clientWidth, stage.clientWidth);
        const at = Math.min(stage.clientWidth, frame.scrollLeft + visible * split.value / 100);
        right.style.clipPath = "inset(0 0 0 " + at + "px)";
        divider.style.left = at + "px";
    };
    const resize = () => {
        const borders = 2 * frame.clientLeft;
        const room = viewer.clientWidth - borders;
        const natural = left.naturalWidth || Number(stage.dataset.width) || room;
        const shape = left.naturalWidth / left.naturalHeight || 1;
        const tallest = (parseFloat(getComputedStyle(frame).maxHeight) || Infinity) - borders;
        const fitting = Math.floor(Math.min(natural, room, tallest * shape));
        const width = zoom === "fit" ? fitting : natural * zoom;
        stage.style.width = width + "px";
        // The slider below is as long as the picture above it.
        view.style.width = width + borders + "px";
        // Pixels stay squares when magnified; an image made smaller is smoothed.
        stage.classList.toggle("magnified", width >= natural);
        place();
    };
    const show = () => {
        const a = pickLeft.selectedOptions[0], b = pickRight.selectedOptions[0];
        const available = Boolean(b.dataset.difference);
        difference.disabled = !available;
        difference.parentElement.classList.toggle("off", !available);
        const differing = available && difference.checked;
        left.src = a.dataset.png;
        left.alt = a.textContent;
        right.src = differing ? b.dataset.difference : b.dataset.png;
        right.alt = (differing ? "Difference of " : "") + b.textContent;
        find(".side-left").textContent = "◀ " + a.textContent;
        find(".side-right").textContent =
            (differing ? "difference: " : "") + b.textContent + " ▶";
    };
    const drag = (event) => {
        const box = frame.getBoundingClientRect();
        const visible = Math.min(frame.clientWidth, stage.clientWidth);
        split.value = 100 * (event.clientX - box.left - frame.clientLeft) / visible;
        place();
    };

    // A finger drags the divider and elsewhere scrolls; a mouse may take hold anywhere.
    stage.addEventListener("pointerdown", (event) => {
        if (event.button !== 0 || (event.pointerType !== "mouse" && event.target !== divider))
            return;
        event.preventDefault();
        stage.setPointerCapture(event.pointerId);
        drag(event);
    });
    stage.addEventListener("pointermove", (event) => {
        if (stage.hasPointerCapture(event.pointerId))
            drag(event);
    });
    split.addEventListener("input", place);
    frame.addEventListener("scroll", place);
    window.addEventListener("resize", resize);
    left.addEventListener("load", resize);
    for (const control of [pickLeft, pickRight, difference])
        control.addEventListener("change", show);
    for (const button of zooms) {
        button.addEventListener("click", () => {
            const before = stage.clientWidth;
            const middle = frame.scrollLeft + frame.clientWidth / 2;
            const height = frame.scrollTop + frame.clientHeight / 2;
            zoom = button.dataset.zoom === "fit" ? "fit" : Number(button.dataset.zoom);
            for (const other of zooms)
                other.setAttribute("aria-pressed", String(other === button));
            resize();
            // The middle of the picture stays where it was.
            const scale = stage.clientWidth / before;
            frame.scrollLeft = middle * scale - frame.clientWidth / 2;
            frame.scrollTop = height * scale - frame.clientHeight / 2;
            place();
        });
    }
    show();
    resize();
}
