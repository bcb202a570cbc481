// The row of least error within a budget of time, and four numbers of a row beside those of single.

const BUDGETS = [1.5, 2, 3, 5, 10]; // times of single
const budgetOptions = () => [
    ...BUDGETS.map((factor) => ({value: String(factor), text: `${factor}× the time of single`})),
    {value: "any", text: "any time"}, {value: "own", text: "my own choice"}];

const singleOf = (scene) => rowsOf(scene).find((row) => row.technique === "single" && costOf(row) === 1);

// Returns the index of the choice of least error whose frame takes no longer, or -1.
function bestWithin(scene, choices, budget) {
    const single = singleOf(scene);
    const limit = budget === "any" ? Infinity : Number(budget) * ((single && frameMs(single)) ?? NaN);
    const isWithin = (row) => frameMs(row) !== null && frameMs(row) <= limit && errorOf(row, METRICS.mseTm) !== null;
    const within = choices.filter(({row}) => row && isComparable(row) && isWithin(row));
    const best = least(within, ({row}) => errorOf(row, METRICS.mseTm));
    return best ? choices.indexOf(best) : -1;
}

function showNumbers(scene, row) {
    if (!row) {
        fill("numbers");
        return;
    }
    const single = singleOf(scene);
    const flicker = (of) => finite(field(of, "temporal", "flicker"));
    const beside = (of) => single && single !== row ? `${significant(ratio(of(row), of(single)), 2)} × single` : "";
    const error = (of) => errorOf(of, METRICS.mseTm), bytes = (of) => finite(of.bytesPerPixel);
    const numbers = [
        ["Error", errorText(error(row), METRICS.mseTm), beside(error)],
        ["Flicker", significant(flicker(row)), single ? `single ${significant(flicker(single))}, reference 1` : ""],
        ["Frame", msText(frameMs(row)) + " ms", single && single !== row ? `${significant(ratio(frameMs(row), frameMs(single)), 2)} × single` : ""],
        ["Memory", significant(bytes(row)) + " bytes a pixel", beside(bytes)],
    ];
    fill("numbers", ...numbers.map(([name, text, note]) => element("div", {},
        element("dt", {textContent: name}), element("dd", {textContent: text}, element("small", {textContent: note})))));
}
