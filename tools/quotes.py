#!/usr/bin/env python3
"""Keeps what documents quote of source files equal to the source.

    tools/quotes.py DOCUMENT.md …            exit status 1 where a quote is not current
    tools/quotes.py --update DOCUMENT.md …   rewrites the quotes

A document quotes a definition by a line <!-- quote FILE NAME --> before a fenced block; FILE is seen from the
project's root. What is quoted is the paragraph of the source, from empty line to empty line, that defines
NAME: a function, a constant, a struct or a macro, with the comment above it.
"""
import argparse
import pathlib
import re
import sys

QUOTE = re.compile(r"^(<!-- quote (\S+) (\w+) -->\n```\w*\n)(.*?)(^```$)", re.MULTILINE | re.DOTALL)
DEFINITION = r"^(?:(?:\w[^;\n]*\b{0}(?:\(|\[| = )|#define {0}\b|struct {0} {{)[^;\n]*|\w[^;\n]*\b{0}\[\w*\] = \".*)$"


class Error(Exception):
    """One sentence for the user."""


class Sources:
    def __init__(self, root):
        self.root = root

    def definition(self, source, name):
        try:
            paragraphs = re.split(r"\n{2,}", (self.root / source).read_text())
        except FileNotFoundError:
            raise Error(f"{source} is not there.") from None
        pattern = re.compile(DEFINITION.format(re.escape(name)), re.MULTILINE)
        found = [paragraph for paragraph in paragraphs if pattern.search(paragraph)]
        if len(found) != 1:
            raise Error(f"{source} defines \"{name}\" {len(found)} times.")
        return found[0].strip("\n") + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).parents[1])
    parser.add_argument("documents", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    sources = Sources(arguments.root)
    stale = []
    for document in arguments.documents:
        text = document.read_text()
        if len(QUOTE.findall(text)) != text.count("<!-- quote "):
            raise Error(f"{document} has a quote without a fenced block.")
        current = QUOTE.sub(lambda q: q[1] + sources.definition(q[2], q[3]) + q[5], text)
        for old, new in zip(QUOTE.finditer(text), QUOTE.finditer(current)):
            if old[0] != new[0]:
                stale.append(f"{document}: \"{old[3]}\" of {old[2]}")
        if arguments.update and current != text:
            document.write_text(current)
    if stale and not arguments.update:
        raise Error("Not current (tools/quotes.py --update repairs it): " + ", ".join(stale) + ".")


if __name__ == "__main__":
    try:
        main()
    except Error as error:
        print(error, file=sys.stderr)
        sys.exit(1)
