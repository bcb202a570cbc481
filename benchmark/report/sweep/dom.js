// Small builders of elements. Texts of the results become text, never markup.

const byId = (id) => document.getElementById(id);

function element(tag, properties = {}, ...children) {
    const made = Object.assign(document.createElement(tag), properties);
    made.append(...children.filter((child) => child !== null && child !== undefined));
    return made;
}

const absent = (words) => element("p", {className: "absent", textContent: words});

// heads: texts; "<" at the beginning marks a column of words. rows: lists of cells; a cell is a text or
// {text, note, className}, and the first one is the head of its row.
function tableOf(caption, heads, rows) {
    const wordy = heads.map((head) => head.startsWith("<"));
    const cell = (value, column) => {
        const {text, note, className = ""} = typeof value === "object" && value ? value : {text: value};
        const made = element(column === 0 ? "th" : "td",
            {className: (wordy[column] ? "text " : "") + className, textContent: text ?? MISSING});
        if (column === 0)
            made.scope = "row";
        if (note)
            made.append(element("small", {textContent: note}));
        return made;
    };
    const head = element("tr", {}, ...heads.map((text, column) => element("th",
        {scope: "col", className: wordy[column] ? "text" : "", textContent: text.replace(/^</, "")})));
    const table = element("table", {}, element("caption", {textContent: caption}),
        element("thead", {}, head),
        element("tbody", {}, ...rows.map((row) => element("tr", {}, ...row.map(cell)))));
    // Tables scroll inside their own box, also by keys, so that the page itself never scrolls sideways.
    const box = element("div", {className: "scroll", tabIndex: 0}, table);
    box.setAttribute("role", "region");
    box.setAttribute("aria-label", caption);
    return box;
}

function fill(id, ...children) {
    byId(id).replaceChildren(...children);
}

// Options are {value, text}. The choice is kept if the new options have it.
function setOptions(select, options, preferred) {
    const before = select.value;
    select.replaceChildren(...options.map(({value, text, disabled = false}) =>
        element("option", {value, textContent: text, disabled})));
    const has = (value) => options.some((option) => option.value === value && !option.disabled);
    select.value = has(before) ? before : has(preferred) ? preferred : options[0]?.value ?? "";
    select.disabled = options.length < 2;
}
