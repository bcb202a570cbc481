#!/usr/bin/env python3
"""Keeps the tables of docs/numerics.md equal to the tests of hard cases and to the figures that they print.

    tools/hard_cases.py                   fails if the tables are not current, if a case lacks a test by number or
                                          figures, or if a file cites a case that the tables lack
    tools/hard_cases.py --update          writes the columns behind "code"
    tools/hard_cases.py --measure BUILD   runs the tests of a build folder, writes docs/results/hard-cases.json and the
                                          columns
    tools/hard_cases.py --compare BUILD   runs the tests and fails if the kept figures are not those that they print,
                                          up to a factor of 10

A test cites case 12 by "HardCase12" in its name. Any file cites cases by "hard case 12", "hard cases 12, 13 and 15 to
17", "docs/numerics.md, case 12" or "case 12 of docs/numerics.md".

To add a case:
  1. Add a row with the next number at the end of docs/numerics.md: "| 60 | failure | stable form | code |", with the
     stable form as one sentence and the main files as code. Numbers must be contiguous.
  2. Write a test HardCase60_Name in a file tests/math/hard_cases_*.cpp, or in tests/core/hard_cases_test.cpp for C++
     code, which has one HardCaseFigures (tests/math/hard_case_figures.h). The test fails if the naive form stays within
     the bound, if the SDK's form exceeds it, or if there are fewer than 100,000 inputs. A program that is not in
     PROGRAMS below must be added there.
  3. Build, and run tools/hard_cases.py --measure BUILD.
"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys

CITING = "src", "include", "samples", "conformance", "tests", "benchmark", "tools"
SUFFIXES = ".h", ".c", ".cpp", ".inc", ".glsl", ".comp", ".py"
PROGRAMS = "bin/test_math_numeric", "bin/test_core_unit"
FILTER = "*HardCase*"
# The entries of the column "APIs" for tests below a folder, in their order there.
APIS = {"tests/math/": ("math",), "tests/core/": ("core",), "tests/vk/": ("Vulkan",), "tests/gl/": ("OpenGL",),
        "tests/stages_support/": ("Vulkan", "OpenGL"), "tests/scenes_support/": ("Vulkan", "OpenGL")}
# The first four cells of a row are written by hand, the others by this tool.
ROW = re.compile(r"^\| (\d+) \|([^|\n]*\|[^|\n]*\|[^|\n]*) \|(.*)$", re.MULTILINE)
TITLES = "case | failure | stable form | code | error | naive | ours | bound | inputs | APIs | tests"
HEADER = re.compile(r"^\| case \|.*\n\|[-|]+$", re.MULTILINE)
NAME = re.compile(r"HardCase0?(\d+)(?:And0?(\d+))?")
REMARK = r" ?\([^()]*\)"
NUMBERS = rf"cases? ((?:\d+(?:{REMARK})?(?:,? and |, | to )?)+)"
LIST = re.compile(rf"(?:[Hh]ard|numerics\.md,?) {NUMBERS}")
LIST_FIRST = re.compile(rf"{NUMBERS}(?:in|of) docs/numerics\.md".replace(r"to )?)+", r"to | )?)+"))
COMMENT_MARK = re.compile(r"\s*\n\s*(?://|\*|#)?\s*")
PRINTED = re.compile(r"^\[hard case\] (.*)$", re.MULTILINE)
NOT_FINITE = "not finite"


class Error(Exception):
    """One sentence for the user."""


# ---- citations -----------------------------------------------------------------------------------

def named(text):
    """Numbers of the cases in the names of tests."""
    return {int(number) for match in NAME.finditer(text) for number in match.groups() if number}


def cited(text):
    """Numbers of the cases that a text cites."""
    cases = named(text)
    flat = COMMENT_MARK.sub(" ", text)
    for found in LIST.findall(flat) + LIST_FIRST.findall(flat):
        plain = re.sub(REMARK, "", found)
        cases |= {int(number) for number in re.findall(r"\d+", plain)}
        for first, last in re.findall(r"(\d+) to (\d+)", plain):
            cases |= set(range(int(first), int(last) + 1))
    return cases


def citations(root):
    """Files that cite a case, as paths from the root, and the cases that tests have in their names."""
    found, tested = {}, set()
    for folder in CITING:
        for path in sorted((root / folder).rglob("*")):
            name = path.relative_to(root).as_posix()
            if path.suffix in SUFFIXES and name not in ("tools/hard_cases.py", "tests/docs/test_docs.py"):
                text = path.read_text()
                for case in cited(text):
                    found.setdefault(case, []).append(name)
                if name.startswith("tests/"):
                    tested |= named(text)
    return found, tested


# ---- figures -------------------------------------------------------------------------------------

def figures_path(root):
    return root / "docs" / "results" / "hard-cases.json"


def kept_figures(root):
    path = figures_path(root)
    return {row["case"]: row for row in json.loads(path.read_text())} if path.exists() else {}


def rounded(value):
    """Two significant digits, so that compilers and libraries seldom change them."""
    return value if value == NOT_FINITE else float(f"{value:.1e}")


def printed_figures(build):
    figures = {}
    for program in PROGRAMS:
        path = build / program
        if not path.exists():
            raise Error(f"{path} is not there: build it first.")
        run = subprocess.run([path, f"--gtest_filter={FILTER}"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             text=True)
        if run.returncode != 0:
            raise Error(f"{path} failed:\n{run.stdout[-2000:]}")
        for line in PRINTED.findall(run.stdout):
            row = json.loads(line)
            if row["case"] in figures:
                raise Error(f"Case {row['case']} has the figures of two tests.")
            figures[row["case"]] = row | {name: rounded(row[name]) for name in ("naive", "ours")}
    return figures


def write_figures(root, figures):
    path = figures_path(root)
    path.parent.mkdir(parents=True, exist_ok=True)
    rows = ",\n ".join(json.dumps(figures[case], ensure_ascii=False) for case in sorted(figures))
    path.write_text(f"[{rows}]\n")


def is_near(a, b, negligible):
    if NOT_FINITE in (a, b):
        return a == b
    if max(abs(a), abs(b)) <= negligible:
        return True
    return a * b > 0 and abs(math.log10(a / b)) <= 1


def compare(kept, printed):
    differing = [str(case) for case in sorted(kept.keys() | printed.keys())
                 if case not in kept or case not in printed
                 or any(kept[case][name] != printed[case][name] for name in ("measure", "bound"))
                 or any(not is_near(kept[case][name], printed[case][name], 0.01 * kept[case]["bound"])
                        for name in ("naive", "ours", "inputs"))]
    if differing:
        raise Error(f"Cases whose kept figures are not what the tests print (tools/hard_cases.py --measure BUILD "
                    f"repairs it): {', '.join(differing)}.")


def number(value):
    if value == NOT_FINITE:
        return value
    text = f"{value:.0f}" if 100 <= abs(value) < 1e6 else f"{value:.4g}"
    return re.sub(r"e([+-])0*(\d+)", lambda m: f"e{'-' if m[1] == '-' else ''}{m[2]}", text)


# ---- tables --------------------------------------------------------------------------------------

def generated(case, found, figures):
    """The cells behind "code"."""
    tests = [path for path in found.get(case, []) if path.startswith("tests/")]
    apis = {api for path in tests for folder, runs in APIS.items() if path.startswith(folder) for api in runs}
    order = [api for runs in APIS.values() for api in runs]
    cells = ["none", "", "", "", ""]
    if case in figures:
        row = figures[case]
        cells = [row["measure"], number(row["naive"]), number(row["ours"]), number(row["bound"]), f"{row['inputs']:,}"]
    cells.append(", ".join(dict.fromkeys(api for api in order if api in apis)))
    cells.append(", ".join(f"`{path}`" for path in tests) or "none")
    return " | ".join(cells)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--measure", type=pathlib.Path, metavar="BUILD")
    parser.add_argument("--compare", type=pathlib.Path, metavar="BUILD")
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).parents[1])
    arguments = parser.parse_args()
    root = arguments.root
    document = root / "docs" / "numerics.md"
    text = document.read_text()
    found, tested = citations(root)
    listed = [int(row[1]) for row in ROW.finditer(text)]
    if listed != list(range(1, len(listed) + 1)):
        raise Error(f"{document} does not number its cases from 1.")
    unknown = [f"{case} ({found[case][0]})" for case in sorted(set(found) - set(listed))]
    if unknown:
        raise Error(f"{document} lacks cases that files cite: {', '.join(unknown)}.")
    if arguments.compare:
        compare(kept_figures(root), printed_figures(arguments.compare))
        return
    if arguments.measure:
        write_figures(root, printed_figures(arguments.measure))
    figures = kept_figures(root)

    def current(row):
        return f"| {row[1]} |{row[2]} | {generated(int(row[1]), found, figures)} |"

    new = ROW.sub(current, HEADER.sub(f"| {TITLES} |\n|{'---|' * (TITLES.count('|') + 1)}", text))
    if arguments.update or arguments.measure:
        document.write_text(new)
    elif new != text:
        stale = [row[1] for row in ROW.finditer(text) if current(row) != row[0]] or ["the titles"]
        raise Error(f"Cases whose columns are not current (tools/hard_cases.py --update repairs it): "
                    f"{', '.join(stale)}.")
    for missing, what in ((set(listed) - tested, "a test by number"), (set(listed) - set(figures), "figures")):
        if missing:
            raise Error(f"Cases without {what}: {', '.join(map(str, sorted(missing)))}.")
    if set(figures) - set(listed):
        raise Error(f"{figures_path(root)} has cases that the tables lack.")


if __name__ == "__main__":
    try:
        main()
    except Error as error:
        print(error, file=sys.stderr)
        sys.exit(1)
