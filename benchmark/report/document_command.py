"""The command line of a tool that writes a document from sweeps' results."""

import argparse
import json
import sys
from pathlib import Path


def run(tool, description, make_document):
    """make_document: from a list of results, as docs/sweep.md describes them, to Markdown."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("results", type=Path, nargs="+")
    parser.add_argument("out", type=Path)
    arguments = parser.parse_args()
    if arguments.out.suffix == ".json":
        sys.exit(f"{tool}: {arguments.out}: would be written over; the document's name comes last.")
    try:
        sweeps = [json.loads(results.read_text(encoding="utf-8")) for results in arguments.results]
        text = make_document(sweeps).rstrip() + "\n"
    except OSError as problem:
        sys.exit(f"{tool}: {problem}")
    except (KeyError, TypeError, AttributeError, ValueError, ZeroDivisionError) as problem:
        named = ", ".join(map(str, arguments.results))
        sys.exit(f"{tool}: {named}: not of a sweep, or of another schema: {problem!r}")
    try:
        arguments.out.write_text(text, encoding="utf-8")
    except OSError as problem:
        sys.exit(f"{tool}: {problem}")
