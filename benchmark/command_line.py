"""The command lines of the tools: options that several tools have, with one name and one meaning each."""
import argparse
import json
import pathlib
import sys

from runs import HARNESS

BACKENDS = ["vk", "gl"]


def tool_parser(description, out=None, size=None, scenes=False, backends=False, turns=None, frames=None, harness=True):
    """A parser with --harness and the options that are asked for. description: the first line of the text is used.

    out, size, turns, frames: defaults, with which the options exist; out="" requires --out. scenes and backends add
    repeatable options, which are None where they are not given.
    """
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    if harness:
        parser.add_argument("--harness", default=HARNESS, type=pathlib.Path, help="the program agaa-harness")
    if out is not None:
        parser.add_argument("--out", default=out or None, required=not out, type=pathlib.Path,
                            help="folder of the results")
    if size:
        parser.add_argument("--size", default=size, help=f"WxH, {size} by default")
    if scenes:
        parser.add_argument("--scene", action="append", help="only this scene; repeatable")
    if backends:
        parser.add_argument("--backend", action="append", choices=BACKENDS, help="only this one; repeatable")
    if turns:
        parser.add_argument("--turns", default=turns, type=int, help="measurements of each time")
    if frames:
        parser.add_argument("--frames", default=frames, type=int, help="frames of each measurement")
    return parser


def write_document(tool, description, make_document):
    """Runs a tool that writes a document from results of sweeps: RESULTS.json [MORE.json ...] OUT.md.

    make_document: from a list of results, which docs/sweep.md describes, to Markdown.
    """
    parser = tool_parser(description, harness=False)
    parser.add_argument("results", type=pathlib.Path, nargs="+")
    parser.add_argument("out", type=pathlib.Path)
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
