#!/usr/bin/env python3
"""Renders scenes with three techniques, compares them and writes a page (report/demo_report.py)."""
import argparse
import json
import pathlib
import subprocess
import sys
import time

RUNS = [("single", 1, 1), ("ssaa", 8, 1), ("agaa", 8, 2)]  # technique, n, c
REFERENCE = "ssaa"


class Demo:
    def __init__(self, harness, out):
        self.harness = harness
        self.out = out
        self.timings = []
        self.commands = []
        self.names = []  # of scenes, each once
        self.device = self.driver = ""

    def call(self, step, arguments):
        """Runs the harness and returns its JSON; prints the step and its seconds."""
        print(f"{step} ...", end=" ", flush=True)
        begin = time.monotonic()
        result = subprocess.run([self.harness, *arguments, "--json"], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)
        seconds = time.monotonic() - begin
        print(f"{seconds:.1f} s")
        if result.returncode != 0:
            sys.exit(f"demo: {step} failed: {result.stderr.strip()}")
        self.timings.append({"step": step, "seconds": round(seconds, 2)})
        self.commands.append("agaa-harness " + " ".join(arguments))
        return json.loads(result.stdout)

    def render(self, scene, name, technique, n, c):
        stem = f"{name}-{technique}-{n}-{c}"
        data = self.call(f"rendering {name} with {technique}",
                         ["render", "--scene", scene, "--technique", technique,
                          "--samples", str(n), "--aggregates", str(c), "--size", "640x360",
                          "--frames", "3", "--warmup", "1", "--no-validation",
                          "--png", str(self.out / f"{stem}.png"),
                          "--exr", str(self.out / f"{stem}.exr")])
        self.device, self.driver = data["device"], data["driver"]
        label = technique if technique == "single" else f"{technique} n={n}"
        if technique == "agaa":
            label += f" c={c}"
        keys = ("shadingEventsPerPixel", "bytesPerPixel", "driverBytes", "frameMs", "passes",
                "counters")
        run = {"label": label, "technique": technique, "samples": n, "aggregates": c,
               "png": f"{stem}.png", "difference": None, "metrics": None}
        run.update({key: data.get(key) for key in keys})
        return stem, run

    def scene(self, scene):
        name = stem = pathlib.Path(scene).stem
        while name in self.names:
            name = f"{stem}-{len(self.names) + 1}"
        self.names.append(name)
        rendered = [self.render(scene, name, *run) for run in RUNS]
        reference = next(stem for stem, run in rendered if run["technique"] == REFERENCE)
        for stem, run in rendered:
            if stem == reference:
                continue
            difference = f"{stem}-difference.png"
            run["metrics"] = self.call(
                f"comparing {run['label']}",
                ["compare", str(self.out / f"{reference}.exr"), str(self.out / f"{stem}.exr"),
                 "--difference", str(self.out / difference), "--gain", "4"])
            run["difference"] = difference
        return {"name": name, "size": "640x360", "runs": [run for _, run in rendered]}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--harness", required=True)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("scenes", nargs="+")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    demo = Demo(arguments.harness, arguments.out)
    begin = time.monotonic()
    scenes = [demo.scene(scene) for scene in arguments.scenes]
    page = {"title": "AGAA SDK: one frame, three techniques", "device": demo.device,
            "driver": demo.driver, "commands": demo.commands, "scenes": scenes,
            "timings": demo.timings}
    data = arguments.out / "demo.json"
    data.write_text(json.dumps(page, indent=1))
    report = pathlib.Path(__file__).parent / "report" / "demo_report.py"
    subprocess.run([sys.executable, str(report), "--out", str(arguments.out), str(data)],
                   check=True)
    print(f"The pictures took {time.monotonic() - begin:.0f} s; the page is "
          f"{(arguments.out / 'index.html').resolve()}")


if __name__ == "__main__":
    main()
