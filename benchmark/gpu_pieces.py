"""The pieces of a run on a GPU. Each is one process or a few, whose result is JSON."""
import dataclasses
import json
import os
import re
import subprocess
from typing import Callable

import passes
from runs import view_options

TESTS = ["test_vk_stages", "test_gl_stages", "test_vk_scenes", "test_gl_scenes", "test_vk_accuracy", "test_threads"]
TESTS_OF_PIECE = 3  # a driver's compiler may need a minute for a test
SPP = 256  # samples per pixel of references
FIRST_ROWS = 10  # are measured in all scenes before the other rows


class OutOfTime(Exception):
    """The call ended before the piece."""


@dataclasses.dataclass(frozen=True)
class Piece:
    name: str
    run: Callable       # from a Machine to the result
    timed: bool = True  # runs while nothing else does


class Machine:
    """Runs programs until a time, and keeps files in a folder."""

    def __init__(self, programs, folder, left):
        self.programs = programs
        self.folder = folder
        self.left = left  # a function: the seconds until the end of the call

    def run(self, program, *arguments, **environment):
        try:
            return subprocess.run([self.programs / program, *map(str, arguments)], capture_output=True, text=True,
                                  timeout=max(self.left(), 0.1), env={**os.environ, **environment})
        except subprocess.TimeoutExpired:
            raise OutOfTime from None

    def ask(self, *arguments):
        """The JSON of a command of the sample engine, or its message as a refusal or a failure."""
        done = self.run("agaa-harness", *arguments, "--json")
        if done.returncode == 0:
            return json.loads(done.stdout)
        message = (done.stderr.strip().splitlines()[-1:] or ["no message"])[0]
        return {"refusal" if done.returncode == 1 else "failure": message}


# ---- tests ---------------------------------------------------------------------------------------

def suites_of(listing):
    """The suites that --gtest_list_tests names, and how many tests each has."""
    found = {}
    for line in listing.splitlines():
        if line.startswith(" "):
            found[suite] += 1
        elif line and not line.startswith(("Running", "[")):
            suite = line.split("#")[0].strip().rstrip(".")
            found[suite] = 0
    return found


def without_root(text):
    """The text with paths of source files that begin in the source tree, wherever it was built."""
    return re.sub(r"(?<!\S)/\S*?/(?=(?:tests|src)/)", "", text)


def run_suite(machine, program, suite, shard=0, shards=1):
    report = machine.folder / f"{program}-{suite.replace('/', '_')}-{shard}.json"
    report.unlink(missing_ok=True)
    done = machine.run(program, f"--gtest_filter={suite}.*", f"--gtest_output=json:{report}",
                       GTEST_SHARD_INDEX=str(shard), GTEST_TOTAL_SHARDS=str(shards))
    if not report.exists():
        return {"program": program, "suite": suite, "tests": 0, "skipped": [],
                "failed": [{"name": suite, "text": f"exit status {done.returncode}: {done.stderr[-400:]}"}]}
    tests = [test for group in json.loads(report.read_text())["testsuites"] for test in group["testsuite"]]
    return {"program": program, "suite": suite, "tests": len(tests),
            "skipped": [test["name"] for test in tests if test["result"] == "SKIPPED"],
            "failed": [{"name": test["name"], "text": without_root(test["failures"][0]["failure"])[:400]}
                       for test in tests if "failures" in test]}


def run_conformance(machine, backend):
    report = machine.folder / f"conformance-{backend}.json"
    report.unlink(missing_ok=True)
    done = machine.run("agaa-conformance", "--backend", backend, "--json", report)
    tests = json.loads(report.read_text())["results"] if report.exists() else []
    failed = [{"name": test["name"], "text": test["reason"][:400]} for test in tests if test["status"] == "failed"]
    if not tests:
        failed = [{"name": backend, "text": f"exit status {done.returncode}: {done.stderr[-400:]}"}]
    return {"program": "agaa-conformance", "suite": backend, "tests": len(tests), "failed": failed,
            "skipped": [test["name"] for test in tests if test["status"] == "skipped"]}


def test_pieces(machine, backends):
    pieces = []
    if (machine.programs / "agaa-conformance").exists():
        pieces += [Piece(f"tests/agaa-conformance-{backend}", lambda m, backend=backend: run_conformance(m, backend), timed=False)
                   for backend in backends]
    for program in TESTS:
        if not (machine.programs / program).exists():
            print(f"gpu_run: {machine.programs / program} is not there; its tests are left out.", flush=True)
            continue
        for suite, tests in suites_of(machine.run(program, "--gtest_list_tests").stdout).items():
            shards = -(-tests // TESTS_OF_PIECE)
            pieces += [Piece(f"tests/{program}-{suite.replace('/', '_')}-{shard}",
                             lambda m, program=program, suite=suite, shard=shard, shards=shards:
                             run_suite(m, program, suite, shard, shards), timed=False) for shard in range(shards)]
    return pieces


# ---- passes and errors ---------------------------------------------------------------------------

def words(scene, row):
    return {"scene": scene[0], "row": row.name, "preset": row.preset, "way": row.way, "aggregates": row.aggregates}


def frame_options(backend, scene, size, row):
    _, source, camera = scene
    return ["--backend", backend, *view_options(source, camera, size), *row.options, "--no-validation"]


def render_passes(machine, backend, scene, size, row, frames):
    rendered = machine.ask("render", *frame_options(backend, scene, size, row), "--frames", frames, "--warmup", 8)
    if "passes" not in rendered:
        return rendered
    kept = {key: rendered[key] for key in passes.KEPT if key != "passes"}
    return {**kept, **words(scene, row),
            "passes": [{"name": one["name"], "stage": one["stage"],
                        "ms": one["ms"] and {key: round(one["ms"][key], 5) for key in ("median", "p95")}}
                       for one in rendered["passes"]]}


def render_reference(machine, scene, size):
    path = machine.folder / f"{scene[0]}-{size}.exr"
    part = path.with_name("part.exr")
    found = machine.ask("reference", "--backend", "vk", *view_options(scene[1], scene[2], size), "--spp", SPP,
                        "--no-validation", "--exr", part)
    if "refusal" not in found and "failure" not in found:
        part.rename(path)
        return {"exr": path.name}
    return found


def measure_error(machine, backend, scene, size, row):
    reference = machine.folder / f"{scene[0]}-{size}.exr"
    image = machine.folder / "frame.exr"
    rendered = machine.ask("render", *frame_options(backend, scene, size, row), "--frames", 1, "--exr", image)
    if "technique" not in rendered:
        return rendered
    errors = machine.ask("compare", reference, image)
    kept = {key: rendered[key] for key in ("size", "backend", "device", "driver", "technique", "samples", "tiers")}
    return {**kept, **words(scene, row), "errors": errors}


def pass_pieces(scenes, sizes, backends, rows, frames):
    first, rest = rows[:FIRST_ROWS], rows[FIRST_ROWS:]
    return [Piece(f"passes/{size}-{scene[0]}-{backend}-{row.name}",
                  lambda m, size=size, scene=scene, backend=backend, row=row:
                  render_passes(m, backend, scene, size, row, frames))
            for block in (first, rest) for size in sizes for scene in scenes for backend in backends for row in block]


def error_pieces(scenes, size, backends, rows):
    pieces = []
    for scene in scenes:
        pieces.append(Piece(f"references/{size}-{scene[0]}", lambda m, scene=scene: render_reference(m, scene, size)))
        pieces += [Piece(f"errors/{size}-{scene[0]}-{backend}-{row.name}",
                         lambda m, scene=scene, backend=backend, row=row: measure_error(m, backend, scene, size, row))
                   for backend in backends for row in rows]
    return pieces
