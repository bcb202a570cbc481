"""Shared by the tools: the scenes, calls of the sample engine, and intermediate results."""
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
HARNESS = ROOT / "build" / "bin" / "agaa-harness"
BUILTIN = ["bamboo", "foliage", "furball", "metal", "city"]
CAMERAS = {  # of the shared scenes
    "stk_gran_paradiso": "132.1,8.5,-86.8,150,8.0,-70,60",
    "stk_ravenbridge_mansion": "-4.7,1.8,75.8,-8,1.5,65,60",
    "fg_carrier": "40,40,20,86,50,-25,35",
    "sh3d_foliage": "1,1.8,12,0.5,4,0,50",
    "khronos_flight_helmet": "0.5,0.5,0.8,0,0.35,0,35",
}


def find_scenes(tool, wanted=None):
    """Name, argument of --scene and camera ("": the scene's own) of all scenes, or of the wanted ones.

    The shared scenes are below $AGAA_SCENES, or beside the source tree. If they are missing, a line says so.
    """
    named = os.environ.get("AGAA_SCENES")
    folder = pathlib.Path(named) if named else ROOT.parent / "shared" / "scenes"
    files = {name: folder / name / f"{name}.glb" for name in CAMERAS}
    missing = [name for name, file in files.items() if not file.exists()]
    unknown = set(wanted or ()) - set(BUILTIN) - set(CAMERAS)
    if unknown:
        sys.exit(f"{tool}: no scene is called {', '.join(sorted(unknown))}; there are "
                 + ", ".join([*BUILTIN, *CAMERAS]) + ".")
    if missing and (named or set(missing) & set(wanted or ())):
        sys.exit(f"{tool}: {folder} lacks {', '.join(missing)}.")
    if missing:
        print(f"Left out, for $AGAA_SCENES does not name their folder: {', '.join(missing)}.", flush=True)
    scenes = [(name, name, "") for name in BUILTIN]
    scenes += [(name, str(files[name]), camera) for name, camera in CAMERAS.items() if name not in missing]
    return [scene for scene in scenes if not wanted or scene[0] in wanted]


def require_harness(tool, harness):
    if not harness.exists():
        sys.exit(f"{tool}: {harness} is not there; run scripts/build first.")


def ask_json(harness, *arguments):
    """The JSON that a command of the sample engine prints. Raises if the command fails."""
    done = subprocess.run([harness, *arguments, "--json"], check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


def write_json(path, value):
    path.write_text(json.dumps(value, indent=1) + "\n")


def write_results(out, name, data, text):
    """Writes OUT/NAME.json and OUT/NAME.md."""
    write_json(out / f"{name}.json", data)
    (out / f"{name}.md").write_text(text)


class Runs:
    """Calls of the sample engine, with results in OUT/work. An interrupted run continues with the kept results.

    The folder belongs to the settings of a run; a run with other settings is refused.
    """

    def __init__(self, tool, harness, out, settings):
        require_harness(tool, harness)
        self.tool = tool
        self.harness = harness
        self.work = out / "work"
        self.work.mkdir(parents=True, exist_ok=True)
        settings = json.loads(json.dumps(settings))  # tuples become lists, as in the loaded file
        if any(self.work.glob("*.json")) and self.load("settings") != settings:
            sys.exit(f"{tool}: {self.work} is of other settings; take another folder.")
        self.store("settings", settings)

    def run(self, arguments):
        """The finished process, and the last line of its messages."""
        done = subprocess.run([self.harness, *map(str, arguments), "--json"], capture_output=True, text=True)
        return done, (done.stderr.strip().splitlines()[-1:] or ["no message"])[0]

    def fail(self, arguments, done, message):
        sys.exit(f"{self.tool}: {' '.join(map(str, arguments))}: exit status {done.returncode}: {message}")

    def call(self, *arguments):
        """The JSON that a command of the sample engine prints."""
        done, message = self.run(arguments)
        if done.returncode != 0:
            self.fail(arguments, done, message)
        return json.loads(done.stdout)

    def refusal(self, *arguments):
        """The reason for which the SDK refuses the arguments of a command, or None."""
        done, message = self.run(arguments)
        if done.returncode not in (0, 1):
            self.fail(arguments, done, message)
        return message if done.returncode == 1 else None

    def load(self, name):
        path = self.work / f"{name}.json"
        return json.loads(path.read_text()) if path.exists() else None

    def store(self, name, value):
        part = self.work / f"{name}.part"  # moved when it is complete
        part.write_text(json.dumps(value))
        part.rename(self.work / f"{name}.json")

    def kept(self, name, make):
        """The kept result of this name. Calls make() for it if there is none."""
        value = self.load(name)
        if value is None:
            value = make()
            self.store(name, value)
        return value


def view_options(source, camera, size):
    return ["--scene", source, "--size", size] + ([f"--camera={camera}"] if camera else [])
