#!/usr/bin/env python3
"""Keeps the column "tests" of docs/numerics.md equal to the tests that cite a case.

    tools/hard_cases.py            fails if the column is not current, or if a file cites a case that the list lacks
    tools/hard_cases.py --update   writes the column

A test cites case 12 by "HardCase12" in its name. Any file cites cases by "hard case 12", "hard cases 12, 13 and 15 to
17", "docs/numerics.md, case 12" or "case 12 of docs/numerics.md".
"""
import argparse
import pathlib
import re
import sys

CITING = "src", "include", "samples", "conformance", "tests", "benchmark", "tools"
SUFFIXES = ".h", ".c", ".cpp", ".inc", ".glsl", ".comp", ".py"
ROW = re.compile(r"^\| (\d+) \| (.*) \| ([^|]*) \|$", re.MULTILINE)
NAME = re.compile(r"HardCase0?(\d+)(?:And0?(\d+))?")
REMARK = r" ?\([^()]*\)"
NUMBERS = rf"cases? ((?:\d+(?:{REMARK})?(?:,? and |, | to )?)+)"
LIST = re.compile(rf"(?:[Hh]ard|numerics\.md,?) {NUMBERS}")
LIST_FIRST = re.compile(rf"{NUMBERS}(?:in|of) docs/numerics\.md".replace(r"to )?)+", r"to | )?)+"))
COMMENT_MARK = re.compile(r"\s*\n\s*(?://|\*|#)?\s*")


class Error(Exception):
    """One sentence for the user."""


def cited(text):
    """Numbers of the cases that a text cites."""
    cases = {int(number) for match in NAME.finditer(text) for number in match.groups() if number}
    flat = COMMENT_MARK.sub(" ", text)
    for found in LIST.findall(flat) + LIST_FIRST.findall(flat):
        plain = re.sub(REMARK, "", found)
        cases |= {int(number) for number in re.findall(r"\d+", plain)}
        for first, last in re.findall(r"(\d+) to (\d+)", plain):
            cases |= set(range(int(first), int(last) + 1))
    return cases


def citations(root):
    """Files by case, as paths from the root."""
    found = {}
    for folder in CITING:
        for path in sorted((root / folder).rglob("*")):
            name = path.relative_to(root).as_posix()
            if path.suffix in SUFFIXES and name not in ("tools/hard_cases.py", "tests/docs/test_docs.py"):
                for case in cited(path.read_text()):
                    found.setdefault(case, []).append(name)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).parents[1])
    arguments = parser.parse_args()
    document = arguments.root / "docs" / "numerics.md"
    text = document.read_text()
    found = citations(arguments.root)
    listed = [int(row[1]) for row in ROW.finditer(text)]
    if listed != list(range(1, len(listed) + 1)):
        raise Error(f"{document} does not number its cases from 1.")
    unknown = [f"{case} ({found[case][0]})" for case in sorted(set(found) - set(listed))]
    if unknown:
        raise Error(f"{document} lacks cases that files cite: {', '.join(unknown)}.")

    def current(row):
        tests = [f"`{path}`" for path in found.get(int(row[1]), []) if path.startswith("tests/")]
        return f"| {row[1]} | {row[2]} | {', '.join(tests) or 'none'} |"

    new = ROW.sub(current, text)
    if arguments.update:
        document.write_text(new)
    elif new != text:
        stale = [row[1] for row in ROW.finditer(text) if current(row) != row[0]]
        raise Error(f"Cases whose tests are not current (tools/hard_cases.py --update repairs it): {', '.join(stale)}.")


if __name__ == "__main__":
    try:
        main()
    except Error as error:
        print(error, file=sys.stderr)
        sys.exit(1)
