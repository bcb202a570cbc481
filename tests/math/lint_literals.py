#!/usr/bin/env python3
"""Finds floating-point literals outside real( ) and other slips in the shared shader mathematics.

A bare literal is a double in C++: it compiles, runs in double precision on the CPU and hides the
error that the GPU makes. Usage: lint_literals.py DIRECTORY, exit status 1 if anything is found;
lint_literals.py --self-test checks the rules themselves."""

import pathlib
import re
import sys

LITERAL = re.compile(r"(?<![\w.])(?:\d+\.\d*|\.\d+|\d+(?=[eE][+-]?\d))(?:[eE][+-]?\d+)?[fF]?(?!\w)")
REAL_LITERAL = re.compile(r"\breal\(\s*-?\s*(?:\d+\.\d*|\.\d+|\d+)(?:[eE][+-]?\d+)?\s*\)")
SWIZZLE = re.compile(r"\.(?:[xyzw]{2,4}|[rgba]{1,4}|[stpq]{1,4})\b(?!\()")
FUNCTION = re.compile(r"^(?:real|rvec[234]|uvec[234]|uint|bool|void|agaa_\w+)\s+(\w+)\s*\(", re.M)


def without_comments(text):
    blank = lambda m: re.sub(r"[^\n]", " ", m.group(0))
    return re.sub(r"//[^\n]*|/\*.*?\*/", blank, text, flags=re.S)


def findings(text):
    code = re.sub(r"^\s*#\s*include[^\n]*", "", without_comments(text), flags=re.M)
    result = []
    bare = REAL_LITERAL.sub(lambda m: " " * len(m.group(0)), code)
    for pattern, what, where in ((LITERAL, "literal outside real()", bare),
                                 (SWIZZLE, "swizzle", bare)):
        for match in pattern.finditer(where):
            line = where.count("\n", 0, match.start()) + 1
            result.append((line, f"{what}: {match.group(0)}"))
    for match in FUNCTION.finditer(code):
        if not match.group(1).startswith("agaa_"):
            line = code.count("\n", 0, match.start()) + 1
            result.append((line, f"name without agaa_: {match.group(1)}"))
    return result


def self_test():
    bad = ["x = 0.5;", "x = 1.;", "x = .5 * y;", "x = 1e-3;", "y = 2.0f;", "y = v.xy;",
           "real f(real x) {", "c.rgb"]
    good = ["x = real(0.5);", "x = real(-1.0);", "x = real(1e-3);", "i = 3u;", "v.x + v.y;",
            "// 0.5", "real agaa_f(real x) {", "#include \"a.glsl\"", "0x7F800000u", "a.count"]
    for text in bad:
        assert findings(text), text
    for text in good:
        assert not findings(text), (text, findings(text))


def main():
    self_test()
    if sys.argv[1:] == ["--self-test"]:
        return 0
    files = sorted(pathlib.Path(sys.argv[1]).glob("*.glsl"))
    if not files:
        print(f"no .glsl files in {sys.argv[1]}", file=sys.stderr)
        return 1
    status = 0
    for file in files:
        for line, what in findings(file.read_text()):
            print(f"{file}:{line}: {what}", file=sys.stderr)
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
