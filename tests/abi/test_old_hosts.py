"""Hosts that were compiled against earlier headers of this soname, with the library of the day: their output and their
images are those of the hosts of the day, byte for byte.

AGAA_OLD_HOSTS is the folder of the old programs, AGAA_MINIMAL that of today's."""
import os
import pathlib
import subprocess
import tempfile
import unittest

OLD = pathlib.Path(os.environ["AGAA_OLD_HOSTS"])
TODAY = pathlib.Path(os.environ["AGAA_MINIMAL"])


def render(program, path):
    result = subprocess.run([program, path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert result.returncode == 0, f"{program}: {result.stdout}{result.stderr}"
    return result.stdout, path.read_bytes()


class OldHosts(unittest.TestCase):
    def check(self, name):
        """Two passes, a G-buffer of the host and ids are the three ways of materials."""
        with tempfile.TemporaryDirectory() as folder:
            old, old_image = render(OLD / name, pathlib.Path(folder) / "old.ppm")
            today, image = render(TODAY / name, pathlib.Path(folder) / "today.ppm")
        self.assertEqual(old, today)
        self.assertEqual(old_image, image)
        self.assertGreater(len(set(image[i:i + 3] for i in range(15, len(image), 3))), 5, "an empty image")

    def test_vulkan(self):
        for name in ("minimal_vk", "gbuffer_vk", "ids_vk"):
            with self.subTest(name):
                self.check(name)

    def test_opengl(self):
        for name in ("minimal_gl", "gbuffer_gl", "ids_gl"):
            with self.subTest(name):
                self.check(name)


if __name__ == "__main__":
    unittest.main()
