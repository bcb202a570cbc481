"""Runs compilers and the programs that they make, for the tests of the bindings."""
import os
import pathlib
import shutil
import subprocess
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TESTS = ROOT / "tests" / "bindings"


def program(name):
    """Returns the program that CMake found. Without it, the tests are skipped."""
    found = shutil.which(os.environ[f"AGAA_{name.upper()}"])
    if found is None:
        raise unittest.SkipTest(f"{name} is not installed")
    return found


def scratch():
    """Returns an empty folder."""
    folder = pathlib.Path(os.environ["AGAA_SCRATCH"])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def run(*command, **options):
    """Returns what a command printed. Its failure is that of the test."""
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    if result.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\n{result.stdout}")
    return result.stdout
