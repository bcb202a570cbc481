"""Tests that docs/paper_figures.md is what benchmark/paper_figures.py prints, with all its images, and how images are composed."""
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark"))
import paper_figures  # noqa: E402
from png_rows import ImageError, read_png, write_png  # noqa: E402


def run(*arguments):
    return subprocess.run([sys.executable, ROOT / "benchmark/paper_figures.py", *arguments], capture_output=True, text=True)


def texels(figure):
    """Width and height of an image: per row of panels, the crops and their differences, with gaps between them."""
    scale, gap = paper_figures.SCALE, paper_figures.GAP
    widths = [len(row.panels) * (scale * row.crop[2] + gap) - gap for row in figure.rows]
    return max(widths), sum(2 * (scale * row.crop[3] + gap) for row in figure.rows) - gap


class Page(unittest.TestCase):
    def test_is_what_the_tool_prints(self):
        done = run("page")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((ROOT / "docs/paper_figures.md").read_text(), done.stdout,
                         "benchmark/paper_figures.py page > docs/paper_figures.md")

    def test_images_are_those_of_the_table(self):
        kept = {path.stem: path for path in paper_figures.IMAGES.iterdir()}
        self.assertEqual(set(kept), {figure.file for figure in paper_figures.FIGURES})
        self.assertLess(sum(path.stat().st_size for path in kept.values()), 1_200_000)
        for figure in paper_figures.FIGURES:
            self.assertEqual(struct.unpack(">II", kept[figure.file].read_bytes()[16:24]), texels(figure), figure.file)

    def test_crops_are_inside_frames(self):
        for figure in paper_figures.FIGURES:
            for x, y, width, height in (row.crop for row in figure.rows):
                self.assertTrue(0 <= x <= 480 - width and 0 <= y <= 270 - height, figure.file)


class Arguments(unittest.TestCase):
    def test_wrong_ones_are_refused_in_a_sentence(self):
        for arguments in (["render", "--figure", "agaa-99"], ["render", "--harness", ROOT / "missing"]):
            done = run(*arguments)
            self.assertNotEqual(done.returncode, 0)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def test_no_command_is_refused(self):
        self.assertNotEqual(run().returncode, 0)


class Images(unittest.TestCase):
    def test_differences_are_of_the_largest_channel(self):
        one, other = [bytes([10, 20, 30, 255, 0, 0])], [bytes([12, 15, 30, 0, 0, 0])]
        self.assertEqual(paper_figures.difference(one, other, 4), [bytes([20, 20, 20, 255, 255, 255])])

    def test_images_survive_writing(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "image.png"
            write_png(path, [bytes([1, 2, 3]), bytes([4, 5, 6])], 2)
            self.assertEqual(read_png(path), [bytes([1, 2, 3])] * 2 + [bytes([4, 5, 6])] * 2)
            path.write_bytes(path.read_bytes().replace(b"\x08\x02\0\0\0", b"\x10\x02\0\0\0"))
            with self.assertRaises(ImageError):
                read_png(path)


if __name__ == "__main__":
    unittest.main()
