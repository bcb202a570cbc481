"""Renders frames of each technique under the best-practices layer. Each message must have an entry in
best_practices.txt, and each entry must match a message."""
import json
import os
import pathlib
import subprocess
import unittest

HARNESS = os.environ["AGAA_HARNESS"]
LAYER = {"VK_LAYER_ENABLES": "VK_VALIDATION_FEATURE_ENABLE_BEST_PRACTICES_EXT"}
PREFIX = "API message: "
CONFIGURATIONS = {technique: [] for technique in
                  ("single", "fxaa", "msaa", "ssaa", "simple_complex", "sbaa", "agaa", "adaptive")}
CONFIGURATIONS["dcaa"] = CONFIGURATIONS["sgbc"] = ["--samples", "32"]


def entries():
    lines = pathlib.Path(__file__).with_name("best_practices.txt").read_text(encoding="utf-8").splitlines()
    rows = [tuple(part.strip() for part in line.split("|")) for line in lines if line and line[0] != "#"]
    assert all(len(row) == 3 and all(row) for row in rows), rows
    return rows


def messages(technique, arguments):
    result = subprocess.run([HARNESS, "render", "--technique", technique, "--scene", "city", "--size", "32x18",
                             "--frames", "2", "--warmup", "0", *arguments], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True, env={**os.environ, **LAYER})
    if result.returncode != 0:
        raise AssertionError(f"{technique}: {result.stderr[-2000:]}")
    lines = (result.stdout + result.stderr).splitlines()
    return [json.loads(line[len(PREFIX):]) for line in lines if line.startswith(PREFIX)]


class BestPractices(unittest.TestCase):
    def test_each_message_is_explained_and_each_entry_used(self):
        unused = set(entries())
        for technique, arguments in CONFIGURATIONS.items():
            unexplained = set()
            received = messages(technique, arguments)
            self.assertTrue(received, "The layer is missing: it reports at least its own extensions.")
            for message in received:
                matches = [row for row in entries() if row[0] == message["id"] and row[1] in message["text"]]
                unused.difference_update(matches)
                if not matches:
                    unexplained.add((message["id"], message["text"][-400:]))
            self.assertEqual(unexplained, set(), technique)
        self.assertEqual(unused, set())


if __name__ == "__main__":
    unittest.main()
