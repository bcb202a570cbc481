#!/usr/bin/env python3
"""Keeps the passages of source files that documents quote equal to the source.

    tools/quotes.py DOCUMENT.md …            exit status 1 where a quote is not current
    tools/quotes.py --update DOCUMENT.md …   rewrites the quotes

A passage stands in a source file between the lines /* [name] */ and /* [/name] */. A document quotes it by
a line <!-- quote FILE name --> before a fenced block; FILE is seen from the project's root.
"""
import argparse
import pathlib
import re
import sys
import textwrap

QUOTE = re.compile(r"^(<!-- quote (\S+) (\w+) -->\n```\w*\n)(.*?)(^```$)", re.MULTILINE | re.DOTALL)
MARK = re.compile(r"^[ \t]*/\* \[(/?)(\w+)\] \*/\n", re.MULTILINE)


class Error(Exception):
    """One sentence for the user."""


def passages(text, source):
    """Text by name; marks of passages inside a passage are no part of it."""
    found, begins = {}, {}
    for mark in MARK.finditer(text):
        is_end, name = mark.groups()
        if not is_end and (name in begins or name in found):
            raise Error(f"{source} has two passages \"{name}\".")
        if is_end and name not in begins:
            raise Error(f"{source} ends a passage \"{name}\" that does not begin.")
        if is_end:
            found[name] = textwrap.dedent(MARK.sub("", text[begins.pop(name):mark.start()]))
        else:
            begins[name] = mark.end()
    if begins:
        raise Error(f"{source} does not end the passage \"{next(iter(begins))}\".")
    return found


class Sources:
    def __init__(self, root):
        self.root = root
        self.files = {}
        self.quoted = set()

    def passage(self, source, name):
        if source not in self.files:
            try:
                self.files[source] = passages((self.root / source).read_text(), source)
            except FileNotFoundError:
                raise Error(f"{source} is not there.") from None
        if name not in self.files[source]:
            raise Error(f"{source} has no passage \"{name}\".")
        self.quoted.add((source, name))
        return self.files[source][name]

    def check_all_are_quoted(self):
        for source, found in self.files.items():
            for name in found:
                if (source, name) not in self.quoted:
                    raise Error(f"The passage \"{name}\" of {source} is quoted nowhere.")


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
        current = QUOTE.sub(lambda q: q[1] + sources.passage(q[2], q[3]) + q[5], text)
        for old, new in zip(QUOTE.finditer(text), QUOTE.finditer(current)):
            if old[0] != new[0]:
                stale.append(f"{document}: \"{old[3]}\" of {old[2]}")
        if arguments.update and current != text:
            document.write_text(current)
    sources.check_all_are_quoted()
    if stale and not arguments.update:
        raise Error("Not current (tools/quotes.py --update repairs it): " + ", ".join(stale) + ".")


if __name__ == "__main__":
    try:
        main()
    except Error as error:
        print(error, file=sys.stderr)
        sys.exit(1)
