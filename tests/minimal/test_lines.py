"""Measures the minimal hosts: what an integration takes is told by the lines of the smallest one."""
import os
import pathlib
import re
import unittest

FOLDER = pathlib.Path(os.environ["AGAA_SOURCE"]) / "samples" / "minimal"
# Every host stays below these, its scene, comments and empty lines included.
LIMITS = {"gbuffer_gl.c": 400, "gbuffer_vk.c": 620, "ids_gl.c": 450, "ids_vk.c": 570, "minimal_gl.c": 400,
          "minimal_vk.c": 420}


def files_of(path):
    """The file and all of the folder that it includes, directly or not."""
    found, open_ends = set(), [path]
    while open_ends:
        file = open_ends.pop()
        if file.exists() and file not in found:
            found.add(file)
            names = re.findall(r'^#include "(.+)"$', file.read_text(), re.MULTILINE)
            open_ends += [FOLDER / name for name in names]
    return found


class Lines(unittest.TestCase):
    def test_hosts_are_small(self):
        hosts = sorted(FOLDER.glob("*.c"))
        self.assertEqual([host.name for host in hosts], sorted(LIMITS))
        for host in hosts:
            lines = {file.name: len(file.read_text().splitlines()) for file in files_of(host)}
            self.assertIn("host.h", lines)
            self.assertLess(sum(lines.values()), LIMITS[host.name], lines)
            for file in files_of(host):
                self.assertLessEqual(max(map(len, file.read_text().splitlines())), 120, file.name)


if __name__ == "__main__":
    unittest.main()
