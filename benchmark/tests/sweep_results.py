"""Synthetic results of a sweep in the format of docs/sweep.md, with small images."""

import base64
import json
import math
import struct
import subprocess
import sys
import zlib
from pathlib import Path

TOOL = Path(__file__).resolve().parents[2] / "benchmark" / "report" / "sweep_report.py"
WIDTH, HEIGHT = 96, 54


def write_png(path, pixel):
    """Writes a picture of pixel(x, y) -> (r, g, b), with weak compression."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data
                + struct.pack(">I", zlib.crc32(kind + data)))

    rows = b"".join(b"\0" + bytes(value for x in range(WIDTH) for value in pixel(x, y))
                    for y in range(HEIGHT))
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(b"\x89PNG\r\n\x1a\n"
                     + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows, 0)) + chunk(b"IEND", b""))


def error(mse_tm):
    return {"mse": 2 * mse_tm, "mseTm": mse_tm, "relMse": 3 * mse_tm,
            "psnr": -10 * math.log10(2 * mse_tm) if mse_tm > 0 else None, "psnrPeak": 1,
            "flip": 1.6 * math.sqrt(mse_tm), "flipP95": 5 * math.sqrt(mse_tm)}


def configurations():
    yield from [("single", 1, 0), ("fxaa", 1, 0)]
    for n in (4, 8, 16, 32):
        yield from [("msaa", n, 0), ("ssaa", n, 0), ("simple_complex", n, 0)]
        yield from [("sbaa", n, s) for s in (1, 2, 4, 6)]
        yield from [("agaa", n, c) for c in (1, 2, 3, 4)]


def make_row(scene, technique, n, c, cost, speed):
    """A row of plausible numbers. Only rows of the first lighting cost have images."""
    dense = {"bamboo": 1.0, "metal": 1.6}.get(scene, 0.7)
    share = {"single": 1, "fxaa": 1, "msaa": 1.3, "ssaa": n,
             "simple_complex": 1 + 0.75 * dense * (n - 1) / 1.6}.get(technique, 0)
    share = share or 1 + 0.35 * dense * max(0, c - 1) ** 0.7
    merged = {"sbaa": 2.6e-3 / max(1, c) ** 2.2, "agaa": 9e-4 / max(1, c) ** 2, "msaa": 4e-4,
              "simple_complex": 2e-7}.get(technique, 0) * dense * (1 if n > 4 else 0.7)
    aliasing = 6.5e-3 * dense / n ** 1.35 * (0.7 if technique == "fxaa" else 1)
    stages = {"prepass": 1.1 + 0.2 * n, "definition": 0.1 * n if technique in ("agaa", "sbaa") else 0,
              "generation": 0.5 + (0.28 * n if technique != "msaa" else 0),
              "shading": 2.2 * share * cost, "other": 0.4}
    if (scene, technique, n, c) == ("metal", "agaa", 8, 2):
        stages["shading"] *= 6  # this scene contradicts claims of the paper
    stages = {stage: ms * speed for stage, ms in stages.items()}
    frame = 1.04 * sum(stages.values())
    size = {"agaa": 16 * c + 6 * n + n * max(0, math.ceil(math.log2(c or 1))) / 8,
            "sbaa": 9 * n + 14 * c, "msaa": 8 * n, "single": 16, "fxaa": 20}.get(technique, 16 * n)
    stem = f"images/{scene}-{technique}-{n}-{c}"
    first = cost == 1
    return {
        "technique": technique, "n": n, "c": c, "shadingCost": cost, "preset": "",
        "tiers": {"visibility": "scaled-target", "generation": "post-depth-atomics"}
        if technique == "agaa" else {"visibility": "scaled-target"},
        "frameMs": {"median": frame, "p95": 1.1 * frame, "low": 0.9 * frame, "high": 1.2 * frame,
                    "confidence": 0.984375, "frames": 7},
        "passes": [{"name": stage, "stage": stage, "ms": {"median": ms, "p95": ms}}
                   for stage, ms in stages.items()],
        "stageMs": stages, "geometryPasses": 2 if technique in ("agaa", "sbaa") else 1,
        "bytesPerPixel": size, "peakBytesPerPixel": 0.9 * size,
        "eventsPerPixel": share * 0.66, "eventsPerCoveredPixel": share,
        "shadowTapsPerPixel": 4 * share, "aggregatesPerPixel": 1.5 * share,
        "errorSameSamples": error(merged) if n > 1 and technique != "ssaa" else None,
        "errorReference": error(aliasing + merged + 2e-5),
        "temporal": {"frames": 6, "referenceMseTm": 2.5e-6, "biasSquared": 0.4 * aliasing + merged,
                     "variance": 0.6 * aliasing, "flicker": 1 + 150 * aliasing}
        if first and n in (1, 8) else None,
        "path": {"frames": 6, "biasSquared": 0.1 * aliasing + merged,
                 "variance": 0.9 * aliasing, "flicker": 1 + 20 * aliasing}
        if first and n in (1, 8) else None,
        "image": stem + ".png" if first else None,
        "difference": stem + "-diff.png" if first else None,
        "heat": stem + "-events.png" if first and technique in ("agaa", "simple_complex") else None,
    }


def one_pass_row(name, tier, preset, cost, speed):
    """A row of agaa n=8 with one geometry pass, and with up to four aggregates if it has a preset."""
    row = make_row(name, "agaa", 8, 4 if preset else 2, cost, speed)
    row.update(preset=preset, tiers={"visibility": "scaled-target", "generation": tier}, geometryPasses=1,
               bytesPerPixel=64 if tier == "ids" else 160, primitivesPerPixel=2.5 if tier == "ids" else 0,
               materialsPerPixel=2.5 if tier == "ids" else 0)
    row["frameMs"] = {**row["frameMs"], "median": 0.7 * row["frameMs"]["median"], "p95": 0.8 * row["frameMs"]["median"]}
    for key in ("image", "difference", "heat"):
        row[key] = row[key] and row[key].replace("agaa-8-", f"agaa-8-{tier}{preset}-")
    return row


def make_scene(name, speed, folder):
    rows = [make_row(name, technique, n, c, cost, speed) for cost in (1, 4, 16)
            for technique, n, c in configurations()]
    rows += [one_pass_row(name, tier, preset, cost, speed) for cost in (1, 4)
             for tier, preset in (("gbuffer", ""), ("ids", ""), ("ids", "accurate"))]
    scene = {"name": name, "build": "0.1.0-1234abcdef", "triangles": 31000, "lights": 17,
             "stresses": "Stalks and leaves thinner than a pixel, with specular highlights.",
             "pixelsPerDegree": 67.0, "reference": {"spp": 512, "splitHalfMseTm": 1.8e-6},
             "rows": rows, "referenceImage": f"images/{name}-reference.png",
             "ablation": [
                 {"effect": effect, "n": 8, "c": 2, "preset": preset, "calledFor": called,
                  "on": {"frameMs": {"median": 10.4, "p95": 11, "low": 10.1, "high": 11, "frames": 4}, "mseTm": 4e-4},
                  "off": {"frameMs": {"median": 9.1, "p95": 10, "low": 9, "high": 10 if called else 10.2, "frames": 4},
                          "mseTm": off}}
                 for effect, preset, called, off in [("shadow-filter", "", name == "bamboo", 9e-4),
                                                     ("ndf-widening", "accurate", name != "bamboo", 4.05e-4)]]}

    def stripes(width, tint):
        return lambda x, y: tuple(min(255, int(40 + tint * 40 + 150 * max(
            0, min(1, 0.5 + (math.sin((x + y / 3) / 2.5)) * width)) + 20 * channel))
            for channel in range(3))

    write_png(folder / scene["referenceImage"], stripes(0.5, 0))
    for row in rows:
        if row["image"] and not (folder / row["image"]).exists():
            write_png(folder / row["image"], stripes(0.5 + 4 / row["n"], 0.02 * row["c"]))
        if row["heat"] and not (folder / row["heat"]).exists():
            write_png(folder / row["heat"], lambda x, y: (min(255, 9 * (x % 32)), 60, 120))
    return scene


def make_results(folder):
    """The results of a sweep of two backends, whose images are written below the folder."""
    backends = [
        {"backend": "vk", "device": "llvmpipe (LLVM 15.0.6, 256 bits)", "driver": "lavapipe",
         "passTimes": "device",
         "scenes": [make_scene(name, 1, folder) for name in ("bamboo", "metal")]},
        {"backend": "gl", "device": "llvmpipe", "driver": "Mesa 22.3.6", "passTimes": "none",
         "scenes": [make_scene("metal", 1.3, folder)]},
    ]
    # The second backend has no pass times, and a scene of a quick sweep lacks most members.
    for row in backends[1]["scenes"][0]["rows"]:
        row.update(stageMs=None, passes=None, temporal=None, path=None, heat=None)
    plain = {**backends[0]["scenes"][1], "name": "metal-plain", "plain": True}
    plain["rows"] = [row for row in plain["rows"] if (row["technique"], row["n"], row["c"]) == ("agaa", 8, 2)][:1]
    plain["ablation"] = [{**entry, "calledFor": False, "off": entry["on"]} for entry in plain["ablation"]]
    backends[0]["scenes"].append(plain)
    backends[1]["scenes"].append({
        "name": "quick <b>", "rows": [
            {"technique": "agaa", "n": 8, "c": 2, "shadingCost": 1, "frameMs": {"median": 3.5},
             "errorReference": {"mseTm": 1e-3}, "image": "images/none.png"},
            {"technique": "newcomer", "n": 4, "frameMs": None, "errorReference": None},
            {}, None]})
    return {"schema": 3, "quick": False, "size": "640x360", "backends": backends}


def write_results(folder, results):
    path = folder / "results.json"
    path.write_text(json.dumps(results), encoding="utf-8")
    return path


def write_motion(folder):
    """Results of benchmark/motion.py; the first of two motions has an image of one pixel."""
    def row(i, has_ghosts):
        ghosting = 0.02 / (1 + i) if has_ghosts else None
        return {"name": ("single", "taa", "agaa 8")[i], "error": 0.01 / (1 + i), "flicker": 0.05, "ghosting": ghosting, "sharpness": 0.9,
                "frameMs": 10.0 + i, "bytesPerPixel": 20.0, "errors": [0.01]}

    views = [{"backend": backend, "name": name, "motion": motion, "device": "llvmpipe", "frames": 40, "spp": 32, "referenceMseTm": 1e-5,
              "rows": [row(i, motion == "walk") for i in range(3)]}
             for backend, name, motion in (("vk", "city", "walk"), ("gl", "metal", "light"))]
    folder.mkdir(exist_ok=True)
    (folder / "motion.json").write_text(json.dumps({"size": "320x180", "views": views}))
    (folder / "vk-city-walk.webp").write_bytes(base64.b64decode("UklGRiQAAABXRUJQVlA4IBgAAAAwAQCdASoBAAEAAwA0JaQAA3AA/vuUAAA="))
    return folder


def gpu_row(scene, technique, samples, aggregates, tier, *ms, backend="vk", preset="", way=""):
    """A row of the results of benchmark/gpu_run.py, with passes of these times."""
    return {"backend": backend, "device": "a GPU", "scene": scene, "size": "1920x1080", "technique": technique, "samples": samples,
            "aggregates": aggregates, "preset": preset, "way": way, "tiers": {"generation": tier} if tier else {},
            "passes": [{"ms": {"median": each}} for each in ms]}


def write_gpu(path, rows):
    path.write_text(json.dumps({"command": "benchmark/gpu_run.py", "rows": rows}))
    return path


def run_tool(*arguments):
    return subprocess.run([sys.executable, "-B", str(TOOL), *map(str, arguments)],
                          capture_output=True, text=True, check=False)
