#!/usr/bin/env python3
"""Tests and measures the SDK on a machine with a GPU, in calls of limited time.

    benchmark/gpu_run.py --pack FILE            packs the programs of a build, without symbols, as a tar file
    benchmark/gpu_run.py --out DIR              runs pieces for --minutes, and writes each result to DIR as it comes
    benchmark/gpu_run.py --out DIR --merge      writes docs/results/DEVICE/ from the results in DIR

A call continues where the last one stopped; a machine that keeps nothing needs DIR of the last call. The order is: the tests
on the device, the times of passes in all scenes, the errors. The machine needs Python, drivers and loaders, and no network.
"""
import collections
import concurrent.futures
import json
import lzma
import os
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import time

import gpu_pieces
import passes
from command_line import BACKENDS, tool_parser
from gpu_rows import rows
from markdown_table import table
from runs import HARNESS, ROOT, find_scenes, write_json, write_results

SIZES = ["1920x1080", "2560x1440"]
GROUPS = ["tests", "passes", "references", "errors"]
PROGRAMS = [*gpu_pieces.TESTS, "agaa-conformance", "agaa-harness"]


# ---- packing -------------------------------------------------------------------------------------

def pack(programs, target):
    """Packs the programs and their library with the folders of a build, so that a copy runs where it is unpacked.

    All programs contain the shaders. A dictionary larger than all files stores them once.
    """
    files = [path for path in map(programs.joinpath, PROGRAMS) if path.exists()]
    files += sorted(programs.parent.glob("lib/libagaa.so.*"))
    dictionary = [{"id": lzma.FILTER_LZMA2, "preset": 0, "dict_size": 2**28}]
    with (lzma.open(target, "w", filters=dictionary) as packed, tarfile.open(fileobj=packed, mode="w") as archive,
          tempfile.TemporaryDirectory() as folder):
        for path in files:
            name = path.relative_to(programs.parent.parent)
            if path.is_symlink():
                archive.add(path, name)
                continue
            stripped = pathlib.Path(folder) / path.name
            subprocess.run(["strip", "-o", stripped, path], check=True)
            archive.add(stripped, name)
    print(f"Packed {len(files)} files, {target.stat().st_size / 2**20:.1f} MiB: {target}")


# ---- running -------------------------------------------------------------------------------------

def pieces_of(machine, arguments):
    scenes = find_scenes("gpu_run", arguments.scene)
    sizes, backends = arguments.size or SIZES, arguments.backend or BACKENDS
    wanted = [row for row in rows() if not arguments.row or row.name in arguments.row]
    found = {"tests": lambda: gpu_pieces.test_pieces(machine, backends),
             "passes": lambda: gpu_pieces.pass_pieces(scenes, sizes, backends, wanted, arguments.frames),
             "errors": lambda: gpu_pieces.error_pieces(scenes, sizes[0], backends, wanted)}
    return [piece for group in arguments.group or found for piece in found[group]()]


def run(pieces, machine, out, seconds, jobs):
    """Runs pieces without a result until the time is over. Returns how many remain. jobs: tests at once."""
    todo = [piece for piece in pieces if not (out / f"{piece.name}.json").exists()]
    print(f"{len(pieces)} pieces, {len(pieces) - len(todo)} of them done before", flush=True)
    tests = [piece for piece in todo if not piece.timed]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        done = sum(pool.map(lambda piece: run_piece(piece, machine, out, seconds), tests))
    for piece in todo:
        if piece.timed and machine.left() > 0:
            done += run_piece(piece, machine, out, seconds)
    return len(todo) - done


def run_piece(piece, machine, out, seconds):
    """Runs a piece and writes its result. Returns whether there is one."""
    left = machine.left()
    if left <= 0:
        return False
    path = out / f"{piece.name}.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        result = piece.run(machine)
    except gpu_pieces.OutOfTime:
        # A piece that had most of a call will not fit the next one either. Tests also wait for each other.
        if left < seconds / 2 or (not piece.timed and left < 0.9 * seconds):
            return False
        result = {"failure": f"it takes more than {left:.0f} s"}
    result["seconds"] = round(left - machine.left(), 2)
    part = path.with_suffix(".part")  # moved when it is complete
    write_json(part, result)
    part.rename(path)
    print(f"{piece.name}: {sentence(result)}", flush=True)
    return True


def sentence(result):
    if "tests" in result:
        failed = ", ".join(test["name"] for test in result["failed"])
        return f"{result['tests']} tests" + (f", failed: {failed}" if failed else "")
    for key in ("refusal", "failure"):
        if key in result:
            return f"{key}: {result[key]}"
    return f"{result['seconds']} s"


# ---- results -------------------------------------------------------------------------------------

def results(out, group):
    """The results of a group; rows in their order within a size, a scene and a backend."""
    order = {row.name: i for i, row in enumerate(rows())}
    found = [json.loads(path.read_text()) for path in sorted((out / group).glob("*.json"))]
    return sorted(found, key=lambda one: (one.get("size", ""), one.get("scene", ""), one.get("backend") == "gl",
                                          order.get(one.get("row"), 0)))


def slug(device):
    """"NVIDIA H200/PCIe/SSE2" and "NVIDIA H200" are one device: "nvidia-h200"."""
    return re.sub(r"[^a-z0-9]+", "-", re.sub(r"[/(].*", "", device).lower()).strip("-")


def test_page(tests, unfinished):
    by_program = collections.defaultdict(lambda: [0, 0, 0])
    for one in tests:
        for i, count in enumerate((one["tests"], len(one["failed"]), len(one["skipped"]))):
            by_program[one["program"]][i] += count
    lines = ["# Tests on a device", "", "Generated by `benchmark/gpu_run.py`.", "",
             *table(["program", "tests", "failed", "skipped"], [[f"`{name}`", *counts] for name, counts in by_program.items()])]
    failed = [[f"`{one['program']}`", test["name"], " ".join(test["text"].split())] for one in tests for test in one["failed"]]
    lines += ["", *table(["program", "failed test", "first lines"], failed)] if failed else []
    if unfinished:
        lines += ["", "Did not finish within a call: " + ", ".join(f"`{name}`" for name in unfinished) + "."]
    return "\n".join(lines) + "\n"


def error_page(errors):
    lines = ["# Errors on a device", "", f"Generated by `benchmark/gpu_run.py`. mseTm against {gpu_pieces.SPP} samples per pixel."]
    for key in dict.fromkeys((row["size"], row["backend"]) for row in errors):
        group = [row for row in errors if (row["size"], row["backend"]) == key]
        scenes = list(dict.fromkeys(row["scene"] for row in group))
        by_row = {}
        for row in group:
            by_row.setdefault(passes.label(row), {})[row["scene"]] = f"{row['errors']['mseTm']:.2e}"
        lines += ["", f"## {key[0]}, {key[1]}: {group[0]['device']} ({group[0]['driver']})", "",
                  *table(["technique, n, c or S", *scenes], [[name, *(found.get(scene, "–") for scene in scenes)]
                                                             for name, found in by_row.items()])]
    return "\n".join(lines) + "\n"


def merge(out, documents):
    """Writes what the pieces found to the folder of their device. Returns the folder."""
    timed = [row for row in results(out, "passes") if "passes" in row]
    errors = [row for row in results(out, "errors") if "mseTm" in row.get("errors", {})]
    tests = [row for row in results(out, "tests") if "tests" in row]
    unfinished = [path.stem for path in sorted((out / "tests").glob("*.json")) if "failure" in json.loads(path.read_text())]
    if not timed and not errors:
        sys.exit(f"gpu_run: {out} has no rendered rows.")
    folder = documents / slug((timed + errors)[0]["device"])
    folder.mkdir(parents=True, exist_ok=True)
    if timed:
        data = {"command": "benchmark/gpu_run.py", "note": "Medians of the frames of a run on this device alone.",
                "rows": timed}
        write_results(folder, "passes", data, passes.document(data))
    if errors:
        write_results(folder, "errors", {"rows": errors}, error_page(errors))
    if tests:
        write_results(folder, "tests", {"suites": tests, "unfinished": unfinished}, test_page(tests, unfinished))
    return folder


def main():
    parser = tool_parser(__doc__, scenes=True, backends=True, frames=101, harness=False)
    parser.add_argument("--out", type=pathlib.Path, help="folder of the pieces' results")
    parser.add_argument("--programs", type=pathlib.Path, default=HARNESS.parent, help="folder of the programs")
    parser.add_argument("--minutes", type=float, default=9, help="time of a call, 9 by default")
    parser.add_argument("--size", action="append", help="WxH, 1920x1080 and 2560x1440 by default; repeatable")
    parser.add_argument("--row", action="append", help="only this row, such as ssaa-8; repeatable")
    parser.add_argument("--group", action="append", choices=["tests", "passes", "errors"], help="only these pieces; repeatable")
    parser.add_argument("--jobs", type=int, default=max(1, (os.cpu_count() or 1) // 2), help="tests at once")
    parser.add_argument("--pack", type=pathlib.Path, metavar="FILE", help="pack the programs and end")
    parser.add_argument("--merge", action="store_true", help="write the documents from the results and end")
    parser.add_argument("--documents", type=pathlib.Path, default=ROOT / "docs" / "results", help="folder of the documents")
    arguments = parser.parse_args()
    if arguments.jobs < 1:
        parser.error("--jobs must be at least 1.")
    if arguments.pack:
        return pack(arguments.programs.resolve(), arguments.pack)
    if not arguments.out:
        parser.error("--out is required.")
    if arguments.merge:
        return print(f"Wrote {merge(arguments.out, arguments.documents)}.")
    if not (arguments.programs / "agaa-harness").exists():
        sys.exit(f"gpu_run: {arguments.programs / 'agaa-harness'} is not there; build it, or name its folder by --programs.")
    seconds = 60 * arguments.minutes
    end = time.monotonic() + seconds
    arguments.out.mkdir(parents=True, exist_ok=True)
    machine = gpu_pieces.Machine(arguments.programs, arguments.out, lambda: end - time.monotonic())
    remaining = run(pieces_of(machine, arguments), machine, arguments.out, seconds, arguments.jobs)
    print(f"{remaining} pieces remain; call again with the same --out." if remaining else "All pieces are done.")


if __name__ == "__main__":
    main()
