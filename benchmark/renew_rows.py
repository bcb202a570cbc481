#!/usr/bin/env python3
"""Replaces rows of a sweep by those of a later one, which measured few rows again, and adds rows that it lacks.

usage: renew_rows.py RESULTS.json LATER.json ROW... OUT.json

The sweeps are of the same scenes, size, references and devices. Times of the later rows are scaled by the frame of `single`
in both, so that rows of one scene compare. A row of the later sweep names its build. Its images are copied from the folder of LATER
to that of OUT.
"""
import json
import shutil
import sys
from pathlib import Path

from runs import write_json

STATISTICS = ("median", "p95", "low", "high")


def name_of(row):
    """The name that agaa-sweep has for the row, without its tier; rows that differ in their tiers have several."""
    cost = f"-cost{row['shadingCost']}" if row["shadingCost"] > 1 else ""
    kind = row["preset"] or (row["c"] if row["c"] else "")
    return f"{row['technique']}-{row['n']}" + (f"-{kind}" if kind else "") + cost


def is_named(row, name):
    """A name may end in the tier of generation."""
    return name in (name_of(row), f"{name_of(row)}-{(row['tiers'] or {}).get('generation', '')}")


def scaled(times, factor):
    return {key: value * factor if key in STATISTICS else [each * factor for each in value] if key == "turns" else value
            for key, value in times.items()}


def renewed(row, factor, build):
    passes = row["passes"] and [{**each, "ms": scaled(each["ms"], factor)} for each in row["passes"]]
    stages = row["stageMs"] and {stage: ms * factor for stage, ms in row["stageMs"].items()}
    return {**row, "frameMs": scaled(row["frameMs"], factor), "passes": passes, "stageMs": stages, "build": build}


def single_ms(scene):
    found = [row["frameMs"]["median"] for row in scene["rows"] if name_of(row) == "single-1"]
    if len(found) != 1:
        raise ValueError(f"{scene['name']} has {len(found)} rows of single; one is needed")
    return found[0]


def check_alike(what, first, later, members):
    for member in members:
        if first.get(member) != later.get(member):
            raise ValueError(f"{what}: {member} differs, {first.get(member)} and {later.get(member)}")


def renew_scene(scene, later, names):
    check_alike(scene["name"], scene, later, ("camera", "lights", "triangles"))
    check_alike(scene["name"], scene["reference"], later["reference"], ("spp",))
    factor = single_ms(scene) / single_ms(later)
    for name in names:
        old = [i for i, row in enumerate(scene["rows"]) if is_named(row, name)]
        new = [row for row in later["rows"] if is_named(row, name)]
        if len(old) > 1 or len(new) != 1:
            raise ValueError(f"{scene['name']} has {len(old)} rows of the name {name}, and {len(new)} later ones; at most one and one are needed")
        row = renewed(new[0], factor, later.get("build"))
        at = old[0] if old else len(scene["rows"])
        scene["rows"][at:at + 1] = [row]
        yield row


def renew(results, later, names):
    """Replaces or adds the rows, and returns the new ones."""
    check_alike("the sweep", results, later, ("size",))
    rows = []
    for backend in results["backends"]:
        others = next((each for each in later["backends"] if each["backend"] == backend["backend"]), {"scenes": []})
        by_name = {scene["name"]: scene for scene in others["scenes"]}
        for scene in backend["scenes"]:
            if scene["name"] not in by_name:
                raise ValueError(f"the later sweep lacks {scene['name']} ({backend['backend']})")
            check_alike(backend["backend"], backend, others, ("device", "driver"))
            count = len(scene["rows"])
            rows += renew_scene(scene, by_name[scene["name"]], names)
            if results.get("rows"):  # empty: all rows of agaa-sweep
                added = [name for name in names if any(is_named(row, name) for row in scene["rows"][count:])]
                results["rows"] += [name for name in added if name not in results["rows"]]
    return rows


def copy_images(rows, source, target):
    for path in (row[kind] for row in rows for kind in ("image", "difference", "heat") if row.get(kind)):
        if (source / path).exists() and source.resolve() != target.resolve():
            (target / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source / path, target / path)


def main(arguments):
    if len(arguments) < 4 or arguments[0].startswith("-"):
        sys.exit(__doc__)
    first, later, *names, out = arguments
    try:
        results = json.loads(Path(first).read_text())
        rows = renew(results, json.loads(Path(later).read_text()), names)
        copy_images(rows, Path(later).parent, Path(out).parent)
    except (OSError, ValueError) as error:
        sys.exit(f"renew_rows: {error}.")
    write_json(Path(out), results)


if __name__ == "__main__":
    main(sys.argv[1:])
