#!/usr/bin/env python3
"""Compares what agaaChooseSettings chooses with what its choices reach, and with the fastest settings of the table that do.

For each scene and each target, `agaa-harness choose --observe` chooses by frames of `single`. All settings of the table are
rendered, and their errors measured against the reference. OUT/goals.json has all numbers; a table in Markdown is printed.
"""
import argparse
import json
import pathlib

from choice_rows import candidates
from runs import HARNESS, ROOT, Runs, find_scenes, view_options

SWEEP = ROOT / "docs/results/lavapipe/sweep/results.json"


def options(row):
    tier = ["--tier", f"generation={row.tier}"] if row.tier else []
    if row.preset:
        return ["--preset", row.preset, "--samples", row.samples, *tier]
    return ["--technique", row.technique, "--samples", row.samples, *(["--aggregates", row.aggregates] if row.aggregates else []),
            *tier]


class Scene:
    def __init__(self, runs, scene, size, spp):
        self.runs, self.name = runs, scene[0]
        self.view = view_options(scene[1], scene[2], size)
        self.reference = runs.work / f"{self.name}-reference.exr"
        runs.kept(f"{self.name}-reference", lambda: runs.call("reference", *self.view, "--spp", spp, "--exr", self.reference))

    def measure(self, name, settings):
        """Error and milliseconds of a frame."""
        def make():
            image = self.runs.work / f"{self.name}-{name}.exr"
            found = self.runs.call("render", *self.view, "--warmup", 1, "--frames", 5, "--no-counters", "--no-validation",
                                   "--exr", image, *settings)
            return {"error": self.runs.call("compare", self.reference, image)["mseTm"], "frameMs": found["frameMs"]["median"],
                    "passMs": sum((entry["ms"] or {"median": 0})["median"] for entry in found["passes"])}
        return self.runs.kept(f"{self.name}-{name}", make)

    def choose(self, target, sceneShare):
        return self.runs.kept(f"{self.name}-choice-{target}", lambda: self.runs.call(
            "choose", *self.view, "--max-error", target, "--scene-share", sceneShare, "--observe", "--no-validation"))


def compare(scene, rows, targets, sceneShare):
    measured = {row: scene.measure(row.name, options(row)) for row in rows}
    by_options = {tuple(map(str, options(row))): row for row in rows}
    single = next(measured[row]["error"] for row in rows if row.technique == "single")
    results = []
    for target in targets:
        choice = scene.choose(target, sceneShare)
        found = {tuple(sorted(key)): row for key, row in by_options.items()}
        row = found[tuple(sorted(choice["options"]))]
        reaching = [other for other in rows if measured[other]["error"] <= target * single]
        best = min(reaching, key=lambda other: measured[other]["passMs"]) if reaching else None
        results.append({"scene": scene.name, "target": target, "choice": row.name, "predictedError": choice["errorShare"],
                        "error": measured[row]["error"] / single, "predictedMs": choice["milliseconds"],
                        "ms": measured[row]["passMs"], "fastest": best.name if best else None,
                        "fastestMs": measured[best]["passMs"] if best else None, "missedLimits": choice["missedLimits"]})
    return results


def print_table(results):
    print("| scene | target | choice | error predicted | error reached | ms predicted | ms measured | fastest that reaches it | its ms |")
    print("|---|---:|---|---:|---:|---:|---:|---|---:|")
    for r in results:
        fastest = [r["fastest"], f"{r['fastestMs']:.0f}"] if r["fastest"] else ["none", ""]
        print(f"| {r['scene']} | {r['target']} | {r['choice']} | {r['predictedError']:.3f} | {r['error']:.3f} | "
              f"{r['predictedMs']:.0f} | {r['ms']:.0f} | {' | '.join(fastest)} |")
    held = sum(r["error"] <= r["target"] for r in results)
    both = [r["ms"] / r["fastestMs"] for r in results if r["fastest"] and r["error"] <= r["target"]]
    print(f"\n{held} of {len(results)} targets are reached.", end="")
    if both:
        print(f" Choices that reach theirs take {min(both):.2f} to {max(both):.2f} times the fastest settings' time.", end="")
    print()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--harness", default=HARNESS, type=pathlib.Path)
    parser.add_argument("--out", default="goals", type=pathlib.Path)
    parser.add_argument("--size", default="320x180")
    parser.add_argument("--spp", default=256, type=int, help="samples per pixel of the reference")
    parser.add_argument("--scene", action="append", help="only these; repeatable")
    parser.add_argument("--target", action="append", type=float, help="errors by that of single; repeatable")
    parser.add_argument("--scene-share", default=0.8, type=float, help="AgaaGoal::sceneShare")
    arguments = parser.parse_args()
    targets = arguments.target or [0.25, 0.1, 0.05, 0.02]
    rows = candidates(json.loads(SWEEP.read_text()))
    runs = Runs("goals", arguments.harness, arguments.out,
                {"size": arguments.size, "spp": arguments.spp, "share": arguments.scene_share})
    results = []
    for scene in find_scenes("goals", arguments.scene):
        results += compare(Scene(runs, scene, arguments.size, arguments.spp), rows, targets, arguments.scene_share)
    (arguments.out / "goals.json").write_text(json.dumps(results, indent=1) + "\n")
    print_table(results)


if __name__ == "__main__":
    main()
