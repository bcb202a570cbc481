#!/usr/bin/env python3
"""Tests of tools/report/demo_report.py: a small demo run in, a whole page out."""

import json
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

TOOL = Path(__file__).resolve().parents[2] / "tools" / "report" / "demo_report.py"
VOID = {"area", "base", "br", "col", "hr", "img", "input", "link", "meta", "source", "wbr"}


def write_png(path, color):
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data
                + struct.pack(">I", zlib.crc32(kind + data)))

    rows = (b"\0" + bytes(color) * 8) * 4
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 8, 4, 8, 2, 0,
                                                                      0, 0))
                     + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Page(HTMLParser):
    """All elements with their texts; raises where tags do not nest."""

    def __init__(self, source):
        super().__init__(convert_charrefs=True)
        self.elements = []  # (tag, attributes, [text])
        self.open = []
        self.feed(source)
        self.close()
        if self.open:
            raise AssertionError(f"not closed: {[self.elements[i][0] for i in self.open]}")

    def handle_starttag(self, tag, attrs):
        names = [name for name, _ in attrs]
        if len(names) != len(set(names)):
            raise AssertionError(f"an attribute twice in <{tag}>: {names}")
        self.elements.append((tag, dict(attrs), []))
        if tag not in VOID:
            self.open.append(len(self.elements) - 1)

    def handle_endtag(self, tag):
        if not self.open or self.elements[self.open[-1]][0] != tag:
            raise AssertionError(f"</{tag}> at {self.getpos()} closes nothing")
        self.open.pop()

    def handle_data(self, data):
        for index in self.open:
            self.elements[index][2].append(data)

    def find(self, tag, cls=None):
        return [(attrs, "".join(words)) for name, attrs, words in self.elements
                if name == tag and (cls is None or cls in (attrs.get("class") or "").split())]


def demo_run():
    metrics = {"mse": 0.25, "mseTm": 0.004, "relMse": 0.1, "psnr": 23.98, "flip": 0.0812,
               "flipP95": 0.4, "maxAbs": 3}
    return {
        "title": "Demo <1> & more",
        "device": "llvmpipe (LLVM 15)",
        "driver": "Mesa 22.3.6",
        "commands": ["agaa-harness render --scene bamboo --json > a.json"],
        "scenes": [
            {"name": "bamboo", "size": "8x4", "runs": [
                {"label": "reference 512 spp", "technique": "reference", "samples": 512,
                 "aggregates": None, "png": "ref.png", "difference": None, "metrics": None},
                {"label": "single", "technique": "single", "samples": 1, "aggregates": None,
                 "png": "single.png", "difference": "single-diff.png", "metrics": metrics,
                 "shadingEventsPerPixel": 1, "bytesPerPixel": 20, "driverBytes": 3 << 20,
                 "frameMs": {"median": 2, "p95": 2.5},
                 "passes": [{"name": "geometry", "stage": "prepass", "ms": {"median": 1}},
                            {"name": "light", "stage": "shading", "ms": {"median": 1}}],
                 "counters": {"visible": 32}},
                {"label": 'agaa n=8 c=2 "<b>"', "technique": "agaa", "samples": 8,
                 "aggregates": 2, "png": "agaa 8#2.png", "difference": "agaa-diff.png",
                 "metrics": {**metrics, "mseTm": 0.0005, "flip": 0.0123, "psnr": None},
                 "shadingEventsPerPixel": 1.4142, "bytesPerPixel": 72.5, "driverBytes": None,
                 "frameMs": {"median": 4, "p95": 4.4},
                 "passes": [{"name": "aggregate", "stage": "generation", "ms": {"median": 3}},
                            {"name": "light", "stage": "unheard of", "ms": {"median": 1}},
                            {"name": "broken", "stage": "post", "ms": {}}],
                 "counters": {"visible": 32, "missed": 0}},
            ]},
            {"name": "empty", "size": None, "runs": [
                {"label": "lost", "png": "not there.png", "metrics": {"mseTm": None}}]},
        ],
        "timings": [{"step": "render", "seconds": 1.25}, {"step": "compare", "seconds": None}],
    }


class DemoReport(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_tool(self, *arguments):
        return subprocess.run([sys.executable, str(TOOL), *map(str, arguments)],
                              capture_output=True, text=True, check=False)

    def make(self, demo):
        for name in ["ref.png", "single.png", "single-diff.png", "agaa 8#2.png", "agaa-diff.png"]:
            write_png(self.folder / name, (90, 120, 30))
        path = self.folder / "demo.json"
        path.write_text(json.dumps(demo), encoding="utf-8")
        done = self.run_tool("--out", self.folder, path)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.source = (self.folder / "index.html").read_text(encoding="utf-8")
        return Page(self.source)

    def row(self, page, heading):
        """Label to text of the cells of the run whose row has this heading."""
        at = next(i for i, (tag, attrs, words) in enumerate(page.elements)
                  if tag == "th" and attrs.get("scope") == "row" and "".join(words) == heading)
        cells = {}
        for tag, attrs, words in page.elements[at + 1:]:
            if tag == "tr":
                break
            if tag == "td":
                cells[attrs["data-label"]] = "".join(words)
        return cells

    def test_page_has_all_parts(self):
        page = self.make(demo_run())
        self.assertEqual(page.find("h1")[0][1], "Demo <1> & more")
        self.assertEqual(page.find("title")[0][1], "Demo <1> & more")
        self.assertIn("llvmpipe (LLVM 15)", page.find("p", "device")[0][1])
        self.assertIn("Mesa 22.3.6", page.find("p", "device")[0][1])
        self.assertEqual(len(page.find("section", "scene")), 2)
        self.assertEqual(len(page.find("div", "viewer")), 1)
        self.assertEqual(len(page.find("img", "left")), 1)
        self.assertEqual(len(page.find("img", "right")), 1)
        self.assertEqual(page.find("input", "split")[0][0]["type"], "range")
        self.assertEqual(page.find("input", "difference")[0][0]["type"], "checkbox")
        self.assertEqual([a["data-zoom"] for a, _ in page.find("button")], ["fit", "1", "2", "4"])
        self.assertEqual(len(page.find("table", "runs")), 2)
        self.assertIn("How to read this", [words for _, words in page.find("h2")])
        self.assertEqual(page.find("pre")[0][1], demo_run()["commands"][0])
        self.assertIn("prefers-color-scheme: dark", page.find("style")[0][1])
        self.assertIn("image-rendering: pixelated", page.find("style")[0][1])
        self.assertIn("clipPath", page.find("script")[0][1])
        self.assertTrue(any(a.get("name") == "viewport" for a, _ in page.find("meta")))
        self.assertEqual(len(page.find("p", "absent")), 1)
        ids = [attrs["id"] for _, attrs, _ in page.elements if "id" in attrs]
        self.assertEqual(len(ids), len(set(ids)))
        for attrs, _ in page.find("a"):
            self.assertIn(attrs["href"].removeprefix("#"), ids)

    def test_table_values(self):
        page = self.make(demo_run())
        self.assertEqual(self.row(page, 'agaa n=8 c=2 "<b>"'),
                         {"technique": "agaa", "n": "8", "c": "2", "mseTm": "5.00e-4",
                          "÷ single": "0.125", "FLIP": "0.0123", "events/px": "1.41",
                          "bytes/px": "72.5", "frame ms": "4.00 (4.40)", "passes": ""})
        self.assertEqual(self.row(page, "single")["÷ single"], "1.000")
        reference = self.row(page, "reference 512 spp")
        for name in ["c", "mseTm", "÷ single", "FLIP", "events/px", "bytes/px", "frame ms",
                     "passes"]:
            self.assertEqual(reference[name], "–", name)

    def test_pass_bars_share_one_scale(self):
        page = self.make(demo_run())
        bars = [(attrs["class"], attrs["style"]) for attrs, _ in page.find("i") if "style" in attrs]
        self.assertEqual(bars, [("stage-prepass", "width:25.00%"), ("stage-shading", "width:25.00%"),
                                ("stage-generation", "width:75.00%"),
                                ("stage-other", "width:25.00%")])

    def test_choices_and_defaults(self):
        page = self.make(demo_run())
        options = page.find("option")
        self.assertEqual(len(options), 6)
        chosen = [words for attrs, words in options if "selected" in attrs]
        self.assertEqual(chosen, ["single", 'agaa n=8 c=2 "<b>"'])
        self.assertNotIn("data-difference", options[0][0])
        self.assertEqual(options[2][0]["data-difference"], "agaa-diff.png")

    def test_refers_to_nothing_but_files_beside_it(self):
        page = self.make(demo_run())
        links = [attrs[key] for _, attrs, _ in page.elements
                 for key in ("src", "href", "data-png", "data-difference") if key in attrs]
        files = [link for link in links if not link.startswith(("#", "data:"))]
        self.assertGreater(len(files), 4)
        for link in files:
            self.assertTrue((self.folder / unquote(link)).is_file(), link)
        self.assertIsNone(re.search(r"https?:|url\(|@import", self.source))

    def test_software_rasteriser_is_named(self):
        self.assertEqual(len(self.make(demo_run()).find("p", "note")), 1)
        demo = {**demo_run(), "device": "NVIDIA H200", "driver": "570"}
        self.assertEqual(len(self.make(demo).find("p", "note")), 0)

    def test_infinite_and_missing_numbers(self):
        demo = demo_run()
        demo["scenes"][0]["runs"][2]["metrics"]["psnr"] = float("inf")
        demo["scenes"][0]["runs"][2]["metrics"]["mse"] = float("nan")
        demo["scenes"][0]["runs"][1]["metrics"]["mseTm"] = 0
        page = self.make(demo)
        self.assertIn("∞", self.source)
        self.assertNotRegex(self.source, r">(nan|inf|None)<")
        self.assertEqual(self.row(page, "single")["÷ single"], "–")

    def test_anything_may_be_missing(self):
        for demo in [{}, {"scenes": None, "commands": None, "timings": None},
                     {"scenes": [{}, {"runs": [{}, None]}]},
                     {"scenes": [{"runs": [{"metrics": [], "passes": {}, "frameMs": 3,
                                            "counters": [1], "png": 5}]}], "timings": [{}]}]:
            with self.subTest(demo=demo):
                self.assertEqual(len(self.make(demo).find("h1")), 1)

    def test_images_outside_the_folder_are_not_shown(self):
        demo = demo_run()
        demo["scenes"][0]["runs"] = [{"label": "x", "png": "../" + self.folder.name + "/../x.png"}]
        self.assertEqual(self.make(demo).find("img"), [])

    def test_errors(self):
        missing = self.folder / "none.json"
        done = self.run_tool("--out", self.folder, missing)
        self.assertEqual(done.returncode, 1)
        self.assertIn(str(missing), done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1)
        for content in ["{", "[]"]:
            missing.write_text(content, encoding="utf-8")
            done = self.run_tool("--out", self.folder, missing)
            self.assertEqual(done.returncode, 1)
            self.assertIn(str(missing), done.stderr)
        self.assertEqual(self.run_tool(missing).returncode, 2)


if __name__ == "__main__":
    unittest.main()
