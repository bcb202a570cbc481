"""Runs the minimal hosts, which lie in the folder AGAA_MINIMAL, and judges what they print and draw."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

PROGRAMS = pathlib.Path(os.environ["AGAA_MINIMAL"])
SIZE = (320, 180)
FRAMES = 3
VALIDATION = {
    "VK_INSTANCE_LAYERS": "VK_LAYER_KHRONOS_validation",
    "VK_LAYER_ENABLES": "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT",
    "VK_LOADER_DEBUG": "layer",  # tells that the layer is there
}


def run(program, *arguments, environment=None):
    return subprocess.run([PROGRAMS / program, *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, env={**os.environ, **(environment or {})})


def read_ppm(path):
    """Rows of (r, g, b), 0 to 255."""
    magic, width, height, largest, data = re.match(rb"(P6)\s+(\d+)\s+(\d+)\s+(\d+)\s(.*)",
                                                   path.read_bytes(), re.DOTALL).groups()
    assert (int(width), int(height)) == SIZE and largest == b"255", (width, height, largest)
    assert len(data) == 3 * SIZE[0] * SIZE[1], len(data)
    return [tuple(data[i:i + 3]) for i in range(0, len(data), 3)]


def linear(value):
    value /= 255
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def coverage(pixel, background, color):
    """Share of the colour over the background, by the channel that tells most, or None where the
    pixel is no mixture of the two."""
    p, b, c = ([linear(v) for v in each] for each in (pixel, background, color))
    channel = max(range(3), key=lambda i: abs(c[i] - b[i]))
    share = (p[channel] - b[channel]) / (c[channel] - b[channel])
    mixture = [b[i] + share * (c[i] - b[i]) for i in range(3)]
    return share if max(abs(mixture[i] - p[i]) for i in range(3)) < 0.006 else None


class Minimal(unittest.TestCase):
    samples = 8

    def render(self, program, environment=None, samples=None):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "image.ppm"
            result = run(program, path, environment=environment)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            self.check_output(result.stdout, samples or self.samples)
            return read_ppm(path), result.stderr

    def check_output(self, text, samples):
        """The frames and nothing else: validation layers write here, too. The host itself refuses frames in
        which samples are missed or accumulated twice."""
        lines = text.splitlines()
        self.assertEqual(len(lines), FRAMES, text)
        for index, line in enumerate(lines, 1):
            found = re.fullmatch(rf"frame {index}: visible (\d+) once (\d+) shadingEvents (\d+)", line)
            self.assertIsNotNone(found, text)
            visible, once, events = map(int, found.groups())
            self.assertGreater(visible, 0)
            self.assertEqual(once, visible, text)
            # Once for many samples is what the technique is for.
            self.assertTrue(visible / samples <= events < visible / 2, text)

    @staticmethod
    def edge_shares(pixels, background, colors):
        """Shares of the pixels that lie between the background and one of the colours."""
        shares = []
        for pixel in pixels:
            if pixel in (background, *colors):
                continue
            for color in colors:
                share = coverage(pixel, background, color)
                if share is not None and 0.01 < share < 0.99:
                    shares.append(share)
                    break
        return shares

    def check_image(self, pixels):
        counts = {}
        for pixel in pixels:
            counts[pixel] = counts.get(pixel, 0) + 1
        full = sorted(counts, key=counts.get, reverse=True)[:6]
        background, colors = full[0], full[1:]
        self.assertEqual(background, pixels[0])
        self.assertGreater(counts[background], len(pixels) / 2)
        for color in colors:  # the five triangles, each with pixels of its own
            self.assertGreater(counts[color], 20, full)
        shares = self.edge_shares(pixels, background, colors)
        self.assertGreater(len(shares), 400, "few pixels lie between background and triangle")
        # Coverage comes in eighths, or as many parts as there are samples.
        parts = [share * self.samples for share in shares]
        self.assertGreaterEqual({round(part) for part in parts}, set(range(1, self.samples)))
        odd = [part for part in parts if abs(part - round(part)) > 0.1]
        self.assertLess(len(odd), len(shares) / 20, odd)

    def check_refusals(self, program):
        for arguments in ((), ("/nonexistent/image.ppm",)):
            result = run(program, *arguments)
            self.assertEqual(result.returncode, 1)
            self.assertRegex(result.stderr, r"^[^\n]+\n$", "not one line")


class Vulkan(Minimal):
    def test_frames_are_clean_under_validation(self):
        pixels, messages = self.render("minimal_vk", VALIDATION)
        self.assertIn('Insert instance layer "VK_LAYER_KHRONOS_validation"', messages)
        self.check_image(pixels)

    def test_refusals(self):
        self.check_refusals("minimal_vk")
        result = run("minimal_vk", "image.ppm", environment={"VK_ICD_FILENAMES": "/nonexistent.json"})
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"[^\n]+\.\n$")


class OpenGl(Minimal):
    def test_frames_are_clean(self):
        pixels, messages = self.render("minimal_gl")
        self.assertEqual(messages, "")
        self.check_image(pixels)

    def test_refusals(self):
        self.check_refusals("minimal_gl")


class OwnGBufferOnVulkan(Minimal):
    samples = 4

    def test_frames_are_clean_under_validation(self):
        pixels, messages = self.render("gbuffer_vk", VALIDATION)
        self.assertIn('Insert instance layer "VK_LAYER_KHRONOS_validation"', messages)
        self.check_image(pixels)
        opengl, _ = self.render("gbuffer_gl")
        differences = [max(abs(a - b) for a, b in zip(p, q)) for p, q in zip(pixels, opengl)]
        self.assertLessEqual(sum(d > 2 for d in differences), len(differences) / 1000)

    def test_refusals(self):
        self.check_refusals("gbuffer_vk")


class OwnGBufferOnOpenGl(Minimal):
    samples = 4

    def test_frames_are_clean(self):
        pixels, messages = self.render("gbuffer_gl")
        self.assertEqual(messages, "")
        self.check_image(pixels)

    def test_refusals(self):
        self.check_refusals("gbuffer_gl")


class ById(Minimal):
    def check_same(self, by_id, two_passes):
        self.check_image(by_id)
        twice, _ = self.render(two_passes)
        most = max(abs(a - b) for left, right in zip(by_id, twice) for a, b in zip(left, right))
        self.assertLessEqual(most, 2, "materials by id are those that the second pass draws")


class ByIdOnVulkan(ById):
    def test_shows_what_two_passes_show(self):
        by_id, messages = self.render("ids_vk", VALIDATION)
        self.assertIn('Insert instance layer "VK_LAYER_KHRONOS_validation"', messages)
        self.check_same(by_id, "minimal_vk")

    def test_refusals(self):
        self.check_refusals("ids_vk")


class ByIdOnOpenGl(ById):
    def test_shows_what_two_passes_show(self):
        by_id, messages = self.render("ids_gl")
        self.assertEqual(messages, "")
        self.check_same(by_id, "minimal_gl")

    def test_refusals(self):
        self.check_refusals("ids_gl")


class Triangles(Minimal):
    samples = 64

    def check_fine_image(self, pixels, eight_samples):
        """The colours, the edges and the sum of light against an image of the same scene with 8 samples."""
        counts = {}
        for pixel in eight_samples:
            counts[pixel] = counts.get(pixel, 0) + 1
        background, *colors = sorted(counts, key=counts.get, reverse=True)[:6]
        self.assertEqual(background, pixels[0])
        for color in colors:  # the five triangles, each with pixels of its own
            self.assertGreater(pixels.count(color), 20, color)
        shares = self.edge_shares(pixels, background, colors)
        self.assertGreater(len(shares), 400, "few pixels lie between background and triangle")
        self.assertGreater(len({round(share * self.samples) for share in shares}), 48, "coverage has few steps")
        for channel in range(3):
            fine, coarse = (sum(linear(pixel[channel]) for pixel in image) for image in (pixels, eight_samples))
            self.assertAlmostEqual(fine / coarse, 1, delta=0.02)


class TrianglesOnVulkan(Triangles):
    def test_frames_are_clean_under_validation(self):
        pixels, messages = self.render("triangles_vk", VALIDATION)
        self.assertIn('Insert instance layer "VK_LAYER_KHRONOS_validation"', messages)
        self.check_fine_image(pixels, self.render("ids_vk", samples=8)[0])
        opengl, _ = self.render("triangles_gl")
        differences = [max(abs(a - b) for a, b in zip(p, q)) for p, q in zip(pixels, opengl)]
        self.assertLessEqual(sum(d > 2 for d in differences), len(differences) / 1000)

    def test_refusals(self):
        self.check_refusals("triangles_vk")


class TrianglesOnOpenGl(Triangles):
    def test_frames_are_clean(self):
        pixels, messages = self.render("triangles_gl")
        self.assertEqual(messages, "")
        self.check_fine_image(pixels, self.render("ids_gl", samples=8)[0])

    def test_refusals(self):
        self.check_refusals("triangles_gl")


class Both(Minimal):
    def test_images_agree(self):
        """By the project's measure of two backends."""
        vulkan, _ = self.render("minimal_vk")
        opengl, _ = self.render("minimal_gl")
        differences = [max(abs(a - b) for a, b in zip(p, q)) for p, q in zip(vulkan, opengl)]
        self.assertLessEqual(sum(differences) / len(differences), 0.5)
        self.assertLessEqual(sum(d > 4 for d in differences), len(differences) / 1000)


class Cpp(Minimal):
    def test_renders_what_the_host_in_c_renders(self):
        with tempfile.TemporaryDirectory() as folder:
            images = {name: pathlib.Path(folder) / f"{name}.ppm" for name in ("minimal_cpp", "minimal_gl")}
            printed = {name: run(name, path) for name, path in images.items()}
            for name, result in printed.items():
                self.assertEqual((result.returncode, result.stderr), (0, ""), name)
            self.check_output(printed["minimal_cpp"].stdout, self.samples)
            self.assertEqual(printed["minimal_cpp"].stdout, printed["minimal_gl"].stdout)
            self.assertTrue(images["minimal_cpp"].read_bytes() == images["minimal_gl"].read_bytes(), "the images differ")

    def test_refusals(self):
        self.check_refusals("minimal_cpp")


if __name__ == "__main__":
    unittest.main()
