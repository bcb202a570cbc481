"""Runs agaa-harness in tests."""
import json
import os
import subprocess
import unittest

HARNESS = os.environ["AGAA_HARNESS"]


def run(*arguments):
    return subprocess.run([HARNESS, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True)


def start(*arguments):
    return subprocess.Popen([HARNESS, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def data(*arguments):
    """The one JSON object that --json prints."""
    result = run(*arguments, "--json")
    if result.returncode != 0:
        raise AssertionError(f"{arguments}: {result.stderr}")
    return json.loads(result.stdout)


class Shard(unittest.TestLoader):
    """Loads every count-th method of each case: those of number/count in AGAA_SHARD, or all without it."""

    def getTestCaseNames(self, case):
        names = super().getTestCaseNames(case)
        number, count = map(int, os.environ.get("AGAA_SHARD", "1/1").split("/"))
        return names[number - 1::count]
