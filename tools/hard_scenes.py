#!/usr/bin/env python3
"""Keeps the table of whole-frame scenes in docs/numerics.md equal to docs/results/hard-scenes.json.

    tools/hard_scenes.py                     fails if the table is not current
    tools/hard_scenes.py --update            writes the table
    tools/hard_scenes.py --summarise FILE …  writes docs/results/hard-scenes.json from outputs of
                                             `agaa-harness hard-scenes --json` with one set of bounds, then the table
    tools/hard_scenes.py --add FILE …        adds outputs of configurations that the kept results lack
    tools/hard_scenes.py --bounds FILE …     prints bounds for samples/harness/hard/frames.cpp: twice the largest
                                             errors of such outputs
"""
import argparse
import json
import math
import pathlib
import re
import sys

CLASSES = "few samples", "every sample", "surfaces", "aggregates", "one aggregate", "one event"
BEGIN, END = "<!-- hard-scenes begin -->", "<!-- hard-scenes end -->"
PART = re.compile(f"{BEGIN}\n.*?{END}", re.DOTALL)


class Error(Exception):
    """One sentence for the user."""


def results_path(root):
    return root / "docs" / "results" / "hard-scenes.json"


def document_path(root):
    return root / "docs" / "numerics.md"


# ---- summary -------------------------------------------------------------------------------------

def configuration(row):
    name = f"{row['technique']} n={row['samples']}"
    if row["preset"]:
        name += f" {row['preset']}"
    elif row["aggregates"]:
        name += f" c={row['aggregates']}"
    if row["tier"] != "auto":
        name += f" {row['tier']}"
    return f"{name} {row['backend']}"


def rounded(value):
    return float(f"{value:.2e}") if isinstance(value, (int, float)) else value


def worst_of(rows, value, bound):
    """The row whose value is largest by its bound, and by itself where the bound is 0."""
    return max(rows, key=lambda row: (value(row) / bound(row) if bound(row) else value(row), value(row)))


def scene_summary(frame, rows):
    summary = dict(frame, rendered=len(rows), worst={})
    for name in CLASSES:
        members = [row for row in rows if row["shades"] == name]
        if members:
            error = worst_of(members, lambda row: row["mseTm"], lambda row: row["maxMseTm"])
            mean = worst_of(members, lambda row: row["meanError"], lambda row: row["maxMeanError"])
            summary["worst"][name] = {
                "mseTm": rounded(error["mseTm"]), "maxMseTm": rounded(error["maxMseTm"]),
                "configuration": configuration(error),
                "meanError": rounded(mean["meanError"]), "maxMeanError": rounded(mean["maxMeanError"]),
                "configurationOfMean": configuration(mean)}
    checked = [row for row in rows if "check" in row]
    if checked:
        worst = worst_of(checked, lambda row: row["check"]["value"], lambda row: row["check"]["bound"])
        summary["worstCheck"] = {"value": rounded(worst["check"]["value"]), "bound": rounded(worst["check"]["bound"]),
                                 "configuration": configuration(worst)}
    return summary


def summarise(paths):
    outputs = [json.loads(pathlib.Path(path).read_text()) for path in paths]
    frames, rows, devices, refusals = {}, {}, {}, {}
    for output in outputs:
        for device in output["devices"]:
            devices[device["backend"]] = device
        for frame in output["scenes"]:
            if frames.setdefault(frame["scene"], frame) != frame:
                raise Error(f"The bounds of {frame['scene']} differ between the files.")
        for row in output["results"]:
            rows[row["scene"], configuration(row)] = row
        for refusal in output["refusals"]:
            refusals.setdefault(refusal["reason"], set()).update(refusal["configurations"])
    bad = [f"{scene}, {name}: {row['exceeds']}" for (scene, name), row in rows.items() if row["exceeds"]]
    if bad:
        raise Error("Frames exceed their bounds: " + "; ".join(bad))
    by_scene = {}
    for (scene, _), row in rows.items():
        by_scene.setdefault(scene, []).append(row)
    return {"devices": [devices[name] for name in sorted(devices, reverse=True)],
            "configurations": len(rows),
            "frames": sum(row["frames"] for row in rows.values()),
            "nonFinite": sum(row["nonFinite"] for row in rows.values()),
            "sanitised": sum(row["sanitised"] for row in rows.values()),
            "lostFragments": sum(row["lostFragments"] for row in rows.values()),
            "scenes": [scene_summary(frame, by_scene[name]) for name, frame in frames.items() if name in by_scene],
            "refusals": [{"reason": reason, "configurations": sorted(names)}
                         for reason, names in sorted(refusals.items())]}


def nearer(kept, added, value, bound, name):
    """The one of two errors that is nearer to its bound."""
    error = added if worst_of([kept, added], lambda w: w[value], lambda w: w[bound]) is added else kept
    return {key: error[key] for key in (value, bound, name)}


def merge_scene(kept, added):
    for name, worst in kept["worst"].items():  # kept bounds include the error of the reference
        for bound in "maxMseTm", "maxMeanError":
            worst[bound] = rounded(worst[bound] + added["bounds"][name][bound] - kept["bounds"][name][bound])
            if worst[bound[3].lower() + bound[4:]] > worst[bound]:
                raise Error(f"{kept['scene']}, {name}: a kept error exceeds the new {bound}.")
    for name, worst in added["worst"].items():
        same = kept["worst"].get(name, worst)
        kept["worst"][name] = {**nearer(same, worst, "mseTm", "maxMseTm", "configuration"),
                               **nearer(same, worst, "meanError", "maxMeanError", "configurationOfMean")}
    if "worstCheck" in added:
        kept["worstCheck"] = nearer(kept.get("worstCheck", added["worstCheck"]), added["worstCheck"], "value", "bound", "configuration")
    kept["bounds"] = added["bounds"]
    kept["rendered"] += added["rendered"]


def add(summary, paths):
    """Adds outputs to a summary. Bounds may differ from those of the summary, and become those of the outputs."""
    added = summarise(paths)
    scenes = {scene["scene"]: scene for scene in summary["scenes"]}
    unknown = {scene["scene"] for scene in added["scenes"]} - set(scenes)
    if unknown:
        raise Error(f"The kept results lack {', '.join(sorted(unknown))}; summarise all outputs anew.")
    for scene in added["scenes"]:
        merge_scene(scenes[scene["scene"]], scene)
    refusals = {refusal["reason"]: set(refusal["configurations"]) for refusal in summary["refusals"]}
    for refusal in added["refusals"]:
        refusals.setdefault(refusal["reason"], set()).update(refusal["configurations"])
    summary["refusals"] = [{"reason": reason, "configurations": sorted(names)} for reason, names in sorted(refusals.items())]
    for key in "configurations", "frames", "nonFinite", "sanitised", "lostFragments":
        summary[key] += added[key]
    return summary


# ---- bounds --------------------------------------------------------------------------------------

def above(value, least):
    """Twice the value, rounded up to two digits."""
    if 2 * value <= least:
        return least
    unit = 10 ** (math.floor(math.log10(2 * value)) - 1)
    return math.ceil(2 * value / unit - 1e-9) * unit


def print_bounds(paths):
    errors = {}
    for path in paths:
        for row in json.loads(pathlib.Path(path).read_text())["results"]:
            errors.setdefault(row["scene"], []).append(row)
    for scene, rows in errors.items():
        for value, bound, least in ("mseTm", "maxMseTm", 1e-6), ("meanError", "maxMeanError", 1e-3):
            largest = [max((row[value] for row in rows if row["shades"] == name), default=0) for name in CLASSES]
            print(f"{scene}: .{bound} = bounds({', '.join(f'{above(error, least):.2g}' for error in largest)})")


# ---- table ---------------------------------------------------------------------------------------

def number(value):
    if value == 0:
        return "0"
    text = f"{value:.1e}" if abs(value) < 0.01 or abs(value) >= 1000 else f"{value:.2g}"
    return text.replace("e-0", "e-").replace("e+0", "e")


def cell(worst):
    return f"{number(worst['mseTm'])} of {number(worst['maxMseTm'])}" if worst else "–"


def table(summary):
    rows = [["scene", "cases", *CLASSES, "nearest to its bound", "check"], []]
    for scene in summary["scenes"]:
        worst = scene["worst"]
        nearest = worst_of(worst.values(), lambda w: w["mseTm"], lambda w: w["maxMseTm"])["configuration"] if worst else "–"
        check = scene.get("worstCheck")
        rows.append([f"`{scene['scene']}`", scene["cases"], *(cell(worst.get(name)) for name in CLASSES), nearest,
                     f"{scene['check']}: {number(check['value'])} of {number(check['bound'])}" if check else ""])
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    lines[1] = "|" + "---|" * len(rows[0])
    devices = " and ".join(f"{d['driver']} ({d['backend']})" for d in summary["devices"])
    return "\n".join([
        f"{summary['configurations']:,} combinations of a scene, a configuration and an API took {summary['frames']:,} "
        f"frames, which have {summary['nonFinite']} non-finite",
        f"channels, {summary['sanitised']} sanitised materials and {summary['lostFragments']} lost fragments. The devices "
        f"are", f"{devices}.", "", *lines])


def updated(text, summary):
    if not PART.search(text):
        raise Error(f"docs/numerics.md has no lines {BEGIN} and {END}.")
    return PART.sub(lambda _: f"{BEGIN}\n{table(summary)}\n{END}", text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[1])
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--summarise", nargs="+", metavar="FILE")
    parser.add_argument("--add", nargs="+", metavar="FILE")
    parser.add_argument("--bounds", nargs="+", metavar="FILE")
    arguments = parser.parse_args()
    root = arguments.root
    try:
        if arguments.bounds:
            return print_bounds(arguments.bounds)
        if arguments.summarise or arguments.add:
            summary = (summarise(arguments.summarise) if arguments.summarise else
                       add(json.loads(results_path(root).read_text()), arguments.add))
            results_path(root).write_text(json.dumps(summary, indent=1, ensure_ascii=False) + "\n")
        summary = json.loads(results_path(root).read_text())
        document = document_path(root)
        text = document.read_text()
        current = updated(text, summary)
        if arguments.summarise or arguments.add or arguments.update:
            document.write_text(current)
        elif text != current:
            raise Error("The table of scenes in docs/numerics.md is not current: run tools/hard_scenes.py --update.")
    except Error as error:
        sys.exit(f"tools/hard_scenes.py: {error}")


if __name__ == "__main__":
    main()
