#!/usr/bin/env python3
"""Checks whether two builds render the same bits: images, plans, bytes and counters of all techniques, on both APIs.

Run it on one build with --out and on the other with --against. It names each difference, and fails if there is one.
"""
import hashlib
import json
import pathlib
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

from command_line import tool_parser
from runs import Runs, require_harness

SCENES = ["foliage", "city"]  # masks and textures; emission and normal maps
TIERS = ["post-depth-atomics", "per-sample", "gbuffer", "ids"]
SAMPLES = [1, 2, 4, 8, 16, 32]


def configurations():
    """Lists of options of `agaa-harness render`."""
    plain = [["single"], ["fxaa"], ["smaa"], ["taa"], *(["msaa", n] for n in (2, 4, 8, 32))]
    plain += [[technique, n] for technique in ("ssaa", "visibility", "simple_complex") for n in SAMPLES]
    for technique, *samples in plain:
        yield ["--technique", technique, *(["--samples", samples[0]] if samples else [])]
    for n in SAMPLES:
        for surfaces in (1, 2, 4, 6):
            yield ["--technique", "sbaa", "--samples", n, "--aggregates", surfaces]
        for c in (1, 2, 3, 4):
            for tier in TIERS:
                yield ["--samples", n, "--aggregates", c, "--tier", f"generation={tier}"]
    for n in (1, 4, 8, 9, 16, 32):
        for extra in ([], ["--tier", "generation=ids"], ["--printed-metric", "--in-order", "--equal-weights", "--loop"],
                      ["--sorted"], ["--tile-maximum"], ["--printed-metric", "--count-background"], ["--target-events", 2],
                      ["--count-memory", 0.5]):
            yield ["--technique", "adaptive", "--samples", n, *extra]
    for n in (32, 64, 128):
        for tier in ("lists", "material-lists"):
            for extra in ([], ["--exact"], ["--merge", "paper"], ["--merge", "color"], ["--reverse-order"]):
                yield ["--technique", "dcaa", "--samples", n, "--aggregates", 4, "--tier", f"generation={tier}", *extra]
            yield ["--technique", "sgbc", "--samples", n, "--aggregates", 4, "--tier", f"generation={tier}"]
        yield ["--technique", "agaa", "--samples", n, "--tier", "generation=fragments"]
    for technique in ("ssaa", "agaa", "sbaa", "adaptive"):
        for extra in ([], ["--no-culling"]):
            yield ["--technique", technique, "--samples", 4, "--lights", 64, *extra]
    for preset in ("paper", "fast", "balanced", "accurate"):
        yield ["--preset", preset]
        yield ["--preset", preset, "--tier", "generation=gbuffer"]
    for tier in TIERS:
        for extra in (["--layout", "paper16"], ["--split-surfaces"], ["--reversed-z", 0], ["--no-stencil"],
                      ["--buffered"], ["--brdf", "blinn-phong"], ["--ndf", "lean"], ["--seeds", "sum-of-squares"]):
            if extra != ["--buffered"] or tier in ("gbuffer", "ids"):
                yield ["--tier", f"generation={tier}", *extra]
    for extra in (["--first-sample-routing"], ["--shadow-along-depth"], ["--no-shadow-filter"], ["--no-diffuse-filter"],
                  ["--shadow-covariance"], ["--light-directions"], ["--depth-planes"],
                  ["--tier", "generation=post-depth-atomics", "--stored-depth"], ["--diffuse-filter", "mises-fisher"], ["--diffuse-filter", "sggx"],
                  ["--tier", "generation=ids", "--unfetched-every", 3], ["--tier", "generation=ids", "--lit"],
                  ["--without", "specular"], ["--without", "shadows"], ["--alpha-points", 4], ["--dither-frame", 7]):
        yield extra
    for view in ("events", "aggregates", "clusters", "primitives", "lit", "widened", "tier"):
        yield ["--tier", "generation=ids", "--view", view]


def digest(data):
    return hashlib.sha256(data).hexdigest()[:16]


def plan_arguments(arguments):
    """The arguments without the options that `plan` does not take, and without their values."""
    dropped = ("--backend", "--alpha-points", "--dither-frame", "--lights")
    kept = iter(arguments)
    return [text for text in kept if text not in dropped or next(kept) is None]


def fingerprint(runs, work, backend, scene, options, size):
    name = " ".join([backend, scene, *map(str, options)])
    image = work / f"{digest(name.encode())}.exr"
    arguments = ["--backend", backend, "--scene", scene, "--size", size, *options]
    try:
        report = runs.call("render", *arguments, "--exr", image)
    except SystemExit as refused:  # a refusal is a result, too
        return name, {"refused": str(refused).split(": ", 2)[-1]}
    plan = runs.call("plan", *plan_arguments(arguments))
    facts = {key: report[key] for key in ("bytesPerPixel", "memoryBytes", "peakBytes", "tiers", "geometryPasses",
                                          "counters", "apiMessages")}
    facts["passes"] = [one["name"] for one in report["passes"]]
    facts["image"] = digest(image.read_bytes())
    facts["plan"] = digest(json.dumps(plan, sort_keys=True).encode())
    image.unlink()
    return name, facts


def differences(before, after):
    for name in sorted(set(before) | set(after)):
        if name not in before or name not in after:
            yield f"{name}: only {'before' if name in before else 'after'}"
            continue
        for key in sorted(set(before[name]) | set(after[name])):
            a, b = before[name].get(key), after[name].get(key)
            if a != b:
                yield f"{name}: {key} was {a}, is {b}"


def main():
    parser = tool_parser(__doc__, size="96x64", backends=True)
    parser.add_argument("--scene", action="append", help=f"repeatable; none: {', '.join(SCENES)}")
    parser.add_argument("--out", type=pathlib.Path, help="file for the fingerprints, as JSON")
    parser.add_argument("--against", type=pathlib.Path, help="fingerprints of another build")
    arguments = parser.parse_args()
    require_harness("fingerprint", arguments.harness)
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        runs = Runs("fingerprint", arguments.harness, work, {})
        tasks = [(backend, scene, options) for backend in arguments.backend or ["vk", "gl"] for scene in arguments.scene or SCENES
                 for options in configurations()]
        found = {}
        with ThreadPoolExecutor(2) as pool:
            for done, (name, facts) in enumerate(pool.map(
                    lambda task: fingerprint(runs, work, *task, arguments.size), tasks), 1):
                found[name] = facts
                if done % 50 == 0:
                    print(f"{done} of {len(tasks)}", flush=True)
    refused = sum("refused" in facts for facts in found.values())
    print(f"{len(found)} fingerprints, {refused} of them of refusals")
    if arguments.out:
        arguments.out.write_text(json.dumps(found, indent=1, sort_keys=True) + "\n")
    if arguments.against:
        found_differences = list(differences(json.loads(arguments.against.read_text()), found))
        print("\n".join(found_differences) if found_differences else "no difference")
        sys.exit(1 if found_differences else 0)


if __name__ == "__main__":
    main()
