#!/usr/bin/env python3
"""Renders our counterparts of the papers' figures, and prints docs/paper_figures.md, which explains them.

    benchmark/paper_figures.py render [--out FOLDER] [--figure NAME]     FOLDER/NAME.png, by default in docs/images/papers
    benchmark/paper_figures.py page                                      the page, on standard output

Both read the table FIGURES. An image has one or more rows of panels, which show one crop of a scene each, and below each panel its
difference from the row's reference. Rendering needs a built agaa-harness, and a Vulkan device or software rasteriser.
"""
import collections
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

from command_line import tool_parser
from png_rows import ImageError, beside, crop, read_png, write_png
from runs import HARNESS, ROOT, require_harness

IMAGES = ROOT / "docs" / "images" / "papers"
SIZE = "480x270"
SCALE, GAP = 2, 6  # texels of the image: of a side of a pixel, and between panels

# A figure. file: name of the image and of the argument; factor: of the differences; paper: what the paper's figure shows;
# seen: what ours shows.
Figure = collections.namedtuple("Figure", "file title factor paper rows seen")
# panels of one crop (x, y, width, height in pixels of the frame), and arguments of the reference, from which differences are taken.
Row = collections.namedtuple("Row", "scene crop reference panels")
# options: arguments of `agaa-harness render`; None: the row's reference; view: a debug view that is shown in place of the image.
Panel = collections.namedtuple("Panel", "label options view", defaults=[""])


def full(n, more=""):
    return f"--technique ssaa --samples {n} {more}".strip()


def shown(technique, n, groups, more=""):
    """Arguments of a technique with n samples and c aggregates or S surfaces."""
    return f"--technique {technique} --samples {n} --aggregates {groups} {more}".strip()


def reference(label):
    return Panel(label, None)


def ndf_panels():
    return [Panel(f"`agaa`, c = 2, `--ndf {ndf}`", shown("agaa", 8, 2, f"--brdf ggx --ndf {ndf}")) for ndf in ("toksvig", "sggx")]


def diffuse_row(scene, place):
    diffuse = "--without specular"
    return Row(scene, place, full(8, diffuse), [
        reference("`ssaa`"), *(Panel(f"`agaa`, c = 1, `{name}`", shown("agaa", 8, 1, f"{diffuse} --diffuse-filter {name}"))
                               for name in ("rectified", "mises-fisher", "sggx"))])


def event_row(scene, place, lobe=""):
    """Of AGAA beside SBAA with like numbers of events."""
    ours = f"`agaa {lobe}`" if lobe else "`agaa`"
    panels = [panel for k in (1, 2, 3) for panel in (Panel(f"`sbaa`, S = {k}", shown("sbaa", 16, k)),
                                                     Panel(f"{ours}, c = {k}", shown("agaa", 16, k, lobe)))]
    return Row(scene, place, full(16), [reference("`ssaa`"), *panels])


def failure_row(scene, place):
    return Row(scene, place, full(8), [
        reference("`ssaa`"), Panel("`agaa`, c = 1", shown("agaa", 8, 1)), Panel("c = 2", shown("agaa", 8, 2)),
        Panel("c = 1, `--ndf sggx`", shown("agaa", 8, 1, "--ndf sggx"))])


GRID = full(9, "--tier visibility=ordered-grid")
ADAPTIVE = "--technique adaptive --samples 9"


def footprint_row(place, label, arguments):
    by_id = f"{ADAPTIVE} --tier generation=ids"
    return Row("city", place, arguments, [
        reference(label), Panel("`adaptive` by id, n = 9", by_id), Panel("`--sample-footprints`", f"{by_id} --sample-footprints")])


DCAA = "--technique dcaa --samples 64"
EXACT = f"{DCAA} --exact"


def decoupled(more):
    return f"{DCAA} --aggregates 4 {more}".strip()


FIGURES = [
    Figure(
        "agaa-10", "AGAA, figure 10: lobes of GGX", 2,
        """GGX highlights of AGAA by Toksvig's isotropic distribution of normals and by the anisotropic SGGX, beside shading per
        sample; SGGX is better on elongated, curved metal.""",
        [Row("metal", (208, 96, 80, 80), full(8, "--brdf ggx"), [reference("`ssaa`, n = 8"), *ndf_panels()])],
        """highlights that are spread over the tubes with Toksvig stay bright and narrow with SGGX, as in the reference, and fewer pixels
        differ from it."""),
    Figure(
        "agaa-11", "AGAA, figure 11: filters of diffuse light", 8,
        """diffuse light filtered by the isotropic distribution and by SGGX; SGGX is better where normals are anisotropic, and slightly
        too smooth elsewhere.""",
        [diffuse_row("foliage", (144, 188, 88, 80)), diffuse_row("city", (304, 152, 88, 80))],
        """with `sggx` the green blades of the first row differ less from the reference than with the isotropic filters `rectified` and
        `mises-fisher`, which look alike. In the second row it is the opposite: with `sggx` the wall between the bars differs more."""),
    Figure(
        "agaa-12", "AGAA, figure 12: more visibility samples", 4,
        """supersampling and AGAA with c = 3 as the visibility samples increase from 4 to 32 per pixel: both become more accurate,
        though AGAA shades no more often.""",
        [Row("city", (288, 12, 80, 80), full(32), [
            *(Panel(f"`ssaa`, n = {n}", full(n)) for n in (4, 8, 16)), reference("n = 32")]),
         Row("city", (288, 12, 80, 80), full(32), [Panel(f"`agaa`, c = 3, n = {n}", shown("agaa", n, 3)) for n in (4, 8, 16, 32)])],
        """the wires are dotted with 4 samples and continuous with 32, in both rows, and the differences shrink alike; with 32 samples
        the difference of c = 3 is faint."""),
    Figure(
        "agaa-16", "AGAA, figure 16: AGAA and SBAA with few shading events", 2,
        """a ball of fur and thin metal tubes with few shading events per pixel, beside supersampling with 16 samples: AGAA, with LEAN
        for the metal, is noticeably better than SBAA.""",
        [event_row("furball", (216, 136, 80, 80)), event_row("metal", (208, 84, 80, 80), "--ndf lean")],
        """in the fur, `agaa` is close to the reference with one event, while `sbaa` is too dark and noisy with one and still noisy with
        three. In the metal the paper's clear advantage does not show: `agaa` has a smaller error by a little only, it is too flat with
        c = 1, and with more it draws dotted highlights as lines, while `sbaa` differs in single bright pixels."""),
    Figure(
        "agaa-17", "AGAA, figure 17: where the filter fails", 4,
        """three failures with few aggregates: (a) halos around leaves, where albedo and shadow are correlated; (b) thin hair, which
        needs an anisotropic distribution; (c) railings, whose normals have several modes. Two aggregates make them rare.""",
        [failure_row("foliage", (16, 164, 88, 80)), failure_row("hard-hair", (192, 80, 88, 80)),
         failure_row("hard-railings", (72, 72, 88, 80))],
        """with c = 1, specks too bright appear in the bush, highlights along hairs break into dots, and all bars are equally pale. With
        c = 2 much of it is gone. SGGX with c = 1 helps the bars, but, unlike in the paper, hardly the hair."""),
    Figure(
        "dcaa-8", "DCAA, figure 8: numbers of surfaces", 4,
        """a detail of a scene with several numbers of surfaces per pixel (and, in further rows, encodings of normals and depth, which
        we leave out); the paper settles on 4.""",
        [Row("city", (324, 8, 96, 80), EXACT, [
            reference("`dcaa --exact`, which keeps all fragments"),
            *(Panel(f"S = {s}", f"{DCAA} --aggregates {s}") for s in (1, 2, 4, 8))])],
        """with S = 1, bars of balconies and the window above them are wrong; the differences shrink with each further surface, and few
        are left with S = 4."""),
    Figure(
        "dcaa-10", "DCAA, figure 10: artefacts", 4,
        """artefacts beside MSAA and the reference: (a) blurred textures, (b) merged normals where walls meet, (c) a window frame that
        is discarded, so that the wall shows, (d) background that leaks through cracks for the approximate depth prepass.""",
        [Row("city", (352, 88, 88, 80), EXACT, [
            reference("`dcaa --exact`"), Panel("S = 4", decoupled("")), Panel("S = 4, `--merge paper`", decoupled("--merge paper")),
            Panel("`msaa`, n = 8", "--technique msaa --samples 8")]),
         Row("city", (140, 104, 88, 80), EXACT, [
             reference("`dcaa --exact`"), Panel("S = 4", decoupled("")), Panel("S = 4, `--merge paper`", decoupled("--merge paper")),
             Panel("`msaa`, n = 8", "--technique msaa --samples 8")]),
         Row("city", (140, 104, 88, 80), EXACT, [
             reference("`dcaa --exact`"), Panel("`--exact --depth-prepass`", f"{EXACT} --depth-prepass"),
             Panel("S = 4, `--depth-prepass`", decoupled("--depth-prepass"))])],
        """with our way of merging, (a) and (c) do not show in these crops. By the paper's rule, here from front to back (`--merge paper`), panes of windows take the
        colours of the wall behind them in the first row, which is an error of merging, and in the second row visible bars of the fence
        are discarded, so that the sky shows; MSAA draws the fence with gaps. In the third row the depth prepass drops what is seen
        between bars of the fence, so that about ten pixels are as dark as the bars, while the paper's leaks show the background. There
        is no row for (b): in `hard-sweep`, whose ridges meet at many angles, S = 4 does not visibly differ by either rule."""),
    Figure(
        "adaptive-5", "Adaptive supersampling, figure 5: footprints of textures", 4,
        """3 x 3 supersampling with anisotropic filtering, the adaptive way with texture look-ups over the area that a shaded sample
        stands for, and without them; the last has texture artefacts.""",
        [footprint_row((384, 80, 88, 80), "`ssaa` on a grid of 3 x 3, with textures over a pixel", GRID),
         footprint_row((384, 80, 88, 80), "64 accumulated samples, with textures over a sample",
                       "--technique ssaa --samples 8 --spp 64 --footprint sample")],
        """the answer depends on the reference. Beside `ssaa`, whose textures are filtered over a pixel, the default is nearly the same, and
        the bricks are too sharp with `--sample-footprints`; beside textures that are filtered over a sample, the default is the
        blurred one, and `--sample-footprints` is nearer."""),
    Figure(
        "adaptive-6", "Adaptive supersampling, figure 6: samples per pixel", 4,
        """(a) the number of samples per pixel as a heat map, (b) the same numbers sorted, (c) their maximum over windows of 6 x 6
        pixels.""",
        [Row("city", (300, 60, 96, 80), GRID, [
            reference("`ssaa` on a grid of 3 x 3"), Panel("samples of `adaptive`", ADAPTIVE, "events"),
            Panel("`--printed-metric`", f"{ADAPTIVE} --printed-metric", "events"),
            Panel("`--tile-maximum`", f"{ADAPTIVE} --tile-maximum", "events")])],
        """lighter pixels have more samples: most are along edges, and the walls have the least. The paper's metric gives nearly all edges
        all samples, and yet misses some that the default finds. The maximum over tiles spreads high numbers over most of the crop
        without a visibly better image. Sorted numbers have no image: `--sorted` shades the same samples."""),
    Figure(
        "adaptive-8", "Adaptive supersampling, figure 8: the two metrics", 4,
        """3 x 3 supersampling, one sample, FXAA and the adaptive way; then the density of samples and the error of the geometric and
        of the shading metric alone. Small geometry escapes the shading metric, and the geometric one finds it.""",
        [Row("city", (304, 8, 96, 80), GRID, [
            reference("`ssaa` on a grid of 3 x 3"), Panel("`single`", "--technique single --samples 1"),
            Panel("`fxaa`", "--technique fxaa --samples 1"), Panel("`adaptive`", ADAPTIVE)]),
         Row("city", (304, 8, 96, 80), GRID, [
             Panel("samples of the shading metric alone", f"{ADAPTIVE} --metrics shading", "events"),
             Panel("of the geometric metric alone", f"{ADAPTIVE} --metrics geometry", "events"), Panel("of both", ADAPTIVE, "events")])],
        """with the shading metric alone, bars and frames of windows keep errors; the geometric metric alone finds nearly all of them, with
        more samples (lighter) at bars and wires, and both together look the same as it. FXAA smooths edges, but the wires stay
        broken."""),
]


# ---- the images --------------------------------------------------------------------------------

def arguments_of(scene, options):
    """The command of the sample engine. References with --spp are accumulated over frames."""
    verb = "reference" if "--spp" in options else "render"
    return [verb, "--scene", scene, "--size", SIZE, "--backend", "vk", "--no-validation", *options]


class Frames:
    """Rendered frames, each of which is rendered once."""

    def __init__(self, harness, folder):
        self.harness, self.file, self.frames = harness, pathlib.Path(folder) / "frame.png", {}

    def __call__(self, scene, options):
        arguments = arguments_of(scene, options.split())
        key = tuple(arguments)
        if key not in self.frames:
            done = subprocess.run([self.harness, *arguments, "--png", self.file], capture_output=True, text=True)
            if done.returncode != 0:
                message = (done.stderr.strip().splitlines()[-1:] or ["no message"])[0]
                sys.exit(f"paper_figures: {' '.join(arguments)}: exit status {done.returncode}: {message}")
            self.frames[key] = read_png(self.file)
        return self.frames[key]


def difference(one, other, factor):
    """Grey rows: the largest difference of the three channels of each pixel, times factor, at most 255."""
    rows = []
    for first, second in zip(one, other):
        apart = [min(255, factor * abs(a - b)) for a, b in zip(first, second)]
        rows.append(b"".join(bytes([max(apart[i:i + 3])]) * 3 for i in range(0, len(apart), 3)))
    return rows


def white(width, height):
    return [b"\xff" * (3 * width)] * height


def panel_images(frames, row, panel, factor):
    """A panel, and its difference from the reference, which is white for the reference itself."""
    own = panel.options or row.reference
    frame = frames(row.scene, f"{own} --view {panel.view}" if panel.view else own)
    _, _, width, height = row.crop
    if panel.options is None:
        return crop(frame, *row.crop), white(width, height)
    against = crop(frames(row.scene, row.reference), *row.crop)
    return crop(frame, *row.crop), difference(crop(frames(row.scene, own), *row.crop), against, factor)


def strip(frames, figure):
    """Rows of the image; each is written SCALE times."""
    lines = []
    for row in figure.rows:
        for part in zip(*(panel_images(frames, row, panel, figure.factor) for panel in row.panels)):
            lines += beside(part, SCALE, GAP) + [b""] * (GAP // SCALE)
    width = max(map(len, lines))
    return [line.ljust(width, b"\xff") for line in lines[:-(GAP // SCALE)]]


def render(arguments):
    chosen = [figure for figure in FIGURES if not arguments.figure or figure.file in arguments.figure]
    unknown = set(arguments.figure or ()) - {figure.file for figure in FIGURES}
    if unknown:
        sys.exit(f"paper_figures: no figure is called {', '.join(sorted(unknown))}; there are "
                 + ", ".join(figure.file for figure in FIGURES) + ".")
    require_harness("paper_figures", arguments.harness)
    arguments.out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        frames = Frames(arguments.harness, folder)
        for figure in chosen:
            path = arguments.out / f"{figure.file}.png"
            write_png(path, strip(frames, figure), SCALE)
            print(f"{path}: {path.stat().st_size} bytes", flush=True)


# ---- the page ----------------------------------------------------------------------------------

INTRODUCTION = f"""Figures of the papers, rendered with the sample engine in its own scenes. `benchmark/paper_figures.py render`
makes the images, and `benchmark/paper_figures.py page` this page, from one table. Frames have {SIZE} pixels; the kept images are of
Vulkan on llvmpipe, Mesa's software rasteriser. Each panel is a crop of a frame, with each pixel {SCALE} x {SCALE} texels large. Below it
is its difference from the reference of its row: the largest difference of the three channels of the tone-mapped pixel, times the
factor that is named. White below a panel: it is the reference. A panel that names no n has the samples of the reference.
[`docs/papers.md`](papers.md) has errors over whole frames."""


def fill(text, first="", others=""):
    """Wrapped text, without line ends in code and at equals signs."""
    joined = re.sub("`[^`]*`|[a-zA-Z] = [0-9]", lambda found: found[0].replace(" ", "\0"), " ".join(text.split()))
    return textwrap.fill(joined, 118, initial_indent=first, subsequent_indent=others, break_long_words=False,
                         break_on_hyphens=False).replace("\0", " ")


def paragraph(text):
    return fill(text) + "\n"


def row_text(row, name):
    x, y, width, height = row.crop
    panels = "; ".join(panel.label for panel in row.panels)
    return (f"{name}`{row.scene}`, {width} x {height} pixels at ({x}, {y}). Panels: {panels}. "
            f"Reference: `{row.reference}`.")


def section(figure):
    """Markdown of one figure."""
    names = [f"Row {i + 1}: " for i in range(len(figure.rows))] if len(figure.rows) > 1 else [""]
    lines = [f"## {figure.title}\n", f"![{figure.title}](images/papers/{figure.file}.png)\n", paragraph(f"The paper: {figure.paper}")]
    lines += [fill(row_text(row, name), "* ", "  ") for name, row in zip(names, figure.rows)]
    return "\n".join([*lines, f"* Differences are times {figure.factor}.\n", paragraph(f"Ours: {figure.seen}")])


def page():
    return "\n".join(["# Figures of the papers\n", paragraph(INTRODUCTION), *(section(figure) for figure in FIGURES)])


def main():
    parser = tool_parser(__doc__, harness=False)
    commands = parser.add_subparsers(dest="command", required=True)
    rendering = commands.add_parser("render", help="renders the images")
    rendering.add_argument("--harness", default=HARNESS, type=pathlib.Path, help="the program agaa-harness")
    rendering.add_argument("--out", default=IMAGES, type=pathlib.Path, help="folder of the images")
    rendering.add_argument("--figure", action="append", help="only this figure; repeatable")
    commands.add_parser("page", help="prints the page")
    arguments = parser.parse_args()
    try:
        if arguments.command == "render":
            render(arguments)
        else:
            print(page(), end="")
    except (ImageError, OSError) as problem:
        sys.exit(f"paper_figures: {problem}")


if __name__ == "__main__":
    main()
