#!/usr/bin/env python3
"""Converts the public headers and the guides to input for Doxygen. scripts/site runs it.

    tools/site/convert.py [--root ROOT] FOLDER

It writes into FOLDER: headers/, pages/, the images of pages (images/), the tree of the site (layout.xml), the style and
the Doxyfile.
"""
import argparse
import pathlib
import re
import shutil
import sys
from xml.sax.saxutils import quoteattr

import declarations
import guides
import headers
import interface
import markup

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOXYFILE, STYLE = (pathlib.Path(__file__).with_name(name) for name in ("Doxyfile", "style.css"))
PARTS = "base", "config", "adaptive", "frame", "functions", "query", "price", "statistics", "outputs", "goal", "temporal"
# Headers in the order of the site: their folder, the title of their group and the group around it.
HEADERS = {"agaa_sdk.h": ("include", "SDK (agaa_sdk.h)", ""),
           **{f"agaa/{part}.h": ("include", f"agaa/{part}.h", "agaa_sdk") for part in PARTS},
           "agaa_vk.h": ("include", "Vulkan (agaa_vk.h)", ""), "agaa_gl.h": ("include", "OpenGL (agaa_gl.h)", ""),
           "agaa_conformance.h": ("conformance/include", "Conformance (agaa_conformance.h)", "")}
MAIN = "README.md"
INDEX = "docs/README.md"
PROJECT = {"CHANGELOG.md": "Changes", "CONTRIBUTING.md": "Contributing", "SECURITY.md": "Security", "NOTICES.md": "Notices"}
RESULTS = "docs/results/"  # generated reports, which the index does not list
# In these guides, AgaaSurface is a struct of GLSL.
GLSL_SURFACE = {"docs/shader-interface.md", "docs/integration/shading-functions.md"}


def read_headers(root):
    known = {path.relative_to(root / "include").as_posix() for path in (root / "include").rglob("*.h")}
    for name in sorted(known - HEADERS.keys()):
        raise declarations.SourceError(f"include/{name} is not listed in tools/site/convert.py.")
    return {name: declarations.read((root / folder / name).read_text(encoding="utf-8"), f"{folder}/{name}")
            for name, (folder, _, _) in HEADERS.items()}


def read_guides(root):
    paths = [MAIN, *PROJECT, *sorted(path.relative_to(root).as_posix() for path in (root / "docs").rglob("*.md"))]
    return [guides.Guide(path, (root / path).read_text(encoding="utf-8"), guides.MAIN if path == MAIN else "") for path in paths]


def index_parts(index, known):
    """Parts of the index: [(title, anchor, [(text of the link, guide)])]."""
    parts = []
    titles = {number: (title, anchor) for number, level, title, anchor in guides.headings(index.text) if level == 2}
    for number, line in guides.outside_code(index.text):
        if number in titles:
            parts.append((*titles[number], []))
        link = re.match(r"\* \[([^\]]+)\]\(([^)#]+)\)", line)
        if link and parts:
            path = "docs/" + link[2]
            if path not in known:
                raise declarations.SourceError(f"{INDEX}:{number}: {link[2]} is not a guide.")
            parts[-1][2].append((link[1], known[path]))
    return parts


def layout(pages):
    """The tree of the site."""
    def tab(kind, title, reference="", inner=()):
        url = f" url=\"@ref {reference}\"" if reference else ""
        return [f"<tab type=\"{kind}\" visible=\"yes\" title={quoteattr(title)}{url}>", *inner, "</tab>"]

    def entries(rows):
        return [line for title, guide in rows for line in tab("user", title, guide.label)]

    index = pages.guides[INDEX]
    parts = index_parts(index, pages.guides)
    inner = [line for title, anchor, rows in parts if title != "Reference"
             for line in tab("usergroup", title, index.anchors[anchor], entries(rows))]
    reports = sorted((guide for path, guide in pages.guides.items() if path.startswith(RESULTS)), key=lambda guide: guide.path)
    inner += tab("usergroup", "Kept reports", "kept_reports",
                 entries([(guide.path.removeprefix(RESULTS).removesuffix(".md"), guide) for guide in reports]))
    reference = [line for title, _, rows in parts if title == "Reference" for line in entries(rows)]
    reference += [*tab("classlist", "Structs"), *tab("globals", "Names"),
                  *entries([(title, pages.guides[path]) for path, title in PROJECT.items()])]
    lines = ["<doxygenlayout version=\"1.0\">", "<navindex>", *tab("mainpage", "Start"),
             *tab("usergroup", "Guides", index.label, inner), *tab("modules", "API"),
             *tab("usergroup", "Reference", "reference", reference), "</navindex>", "</doxygenlayout>"]
    return "\n".join(lines) + "\n"


def lists(pages):
    """Pages of the site that list others: the kept reports, and the reference."""
    reports = sorted((guide for path, guide in pages.guides.items() if path.startswith(RESULTS)), key=lambda guide: guide.path)
    rows = [f"<li>\\ref {guide.label} \"{markup.escape(guide.path)}\": {markup.escape(guide.title)}</li>" for guide in reports]
    yield "kept_reports", ["\\page kept_reports Kept reports", "", "Reports in docs/results/, made by benchmarks.", "",
                           "<ul>", *rows, "</ul>"]
    index = pages.guides[INDEX]
    rows = [(title, guide) for part, _, found in index_parts(index, pages.guides) if part == "Reference" for title, guide in found]
    rows += [(title, pages.guides[path]) for path, title in PROJECT.items()]
    yield "reference", ["\\page reference Reference", "", "<ul>", "<li><a href=\"annotated.html\">Structs</a></li>",
                        "<li><a href=\"globals.html\">Names</a>: functions, types, values and macros</li>",
                        *(f"<li>\\ref {guide.label} \"{markup.escape(title)}\"</li>" for title, guide in rows), "</ul>"]


def convert(root, folder):
    source = read_headers(root)
    found = interface.Interface(source)
    linker = markup.Linker()
    linker.names = set(found.known)
    linker.bits = interface.flag_anchors(source)
    linker.headers = {name: headers.group_of(name) for name in source}
    pages = guides.Pages(root, read_guides(root), linker)
    linker.pages = {guide.path: guide.label for guide in pages.guides.values()}
    for name, (_, title, parent) in HEADERS.items():
        path = folder / "headers" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(headers.Writer(name, found, linker).write(title, parent), encoding="utf-8")
    (folder / "pages").mkdir(parents=True, exist_ok=True)
    for guide in pages.guides.values():
        linker.unlinked = {"AgaaSurface"} if guide.path in GLSL_SURFACE else set()
        (folder / "pages" / f"{guide.label}.dox").write_text(pages.write(guide), encoding="utf-8")
    for label, lines in lists(pages):
        (folder / "pages" / f"{label}.dox").write_text("".join(f"/// {line}\n" for line in lines), encoding="utf-8")
    for path, place in pages.images.items():
        (folder / place).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(root / path, folder / place)
    version = ".".join(re.search(rf"AGAA_VERSION_{part} (\d+)", (root / "include/agaa/base.h").read_text())[1]
                       for part in ("MAJOR", "MINOR", "PATCH"))
    inputs = [*(f"headers/{name}" for name in HEADERS), "pages"]  # groups have the order of the headers
    (folder / "Doxyfile").write_text(f"{DOXYFILE.read_text()}PROJECT_NUMBER = {version}\nINPUT = {' '.join(inputs)}\n")
    shutil.copyfile(STYLE, folder / "style.css")
    (folder / "layout.xml").write_text(layout(pages), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="of the sources")
    parser.add_argument("folder", type=pathlib.Path)
    arguments = parser.parse_args()
    try:
        convert(arguments.root.resolve(), arguments.folder)
    except (declarations.SourceError, OSError) as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main()
