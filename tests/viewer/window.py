"""Runs agaa-viewer in a virtual display, with real keys and clicks."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

VIEWER = os.environ["AGAA_VIEWER"]
HARNESS = os.environ["AGAA_HARNESS"]
SKIPPED = 77  # exit status


def run(*command, timeout=None):
    return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          timeout=timeout)


def state(backend, scene="hard-railings", size="160x90", options=None, **members):
    """A state of the viewer that loads fast."""
    return {"viewerState": 1, **members,
            "options": {"--backend": backend, "--scene": scene, "--size": size, "--no-validation": True,
                        **(options or {})}}


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def write(self, name, content):
        path = self.folder / name
        path.write_text(content if isinstance(content, str) else json.dumps(content))
        return path


class Viewer:
    """A window with a person before it."""

    def __init__(self, case, content, *arguments):
        self.case = case
        self.trace = case.folder / "trace.json"
        self.saved = case.folder / "saved.json"
        self.errors = open(case.folder / "stderr", "w+")
        self.process = subprocess.Popen(
            [VIEWER, "--state", case.write("state.json", content), "--trace", self.trace, "--save-state", self.saved,
             "--window", "1000x700", *arguments], stderr=self.errors)
        case.addCleanup(self.stop)
        self.wait(lambda seen: seen["settled"])
        found = self.xdotool("search", "--sync", "--name", "AGAA viewer").split()
        self.window = found[0]
        self.xdotool("windowfocus", "--sync", self.window)

    def stop(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.errors.close()

    def xdotool(self, *words):
        result = run("xdotool", *words)
        self.case.assertEqual(result.returncode, 0, f"xdotool {words}: {result.stderr}")
        return result.stdout

    def seen(self):
        return json.loads(self.trace.read_text()) if self.trace.exists() else None

    def wait(self, condition, seconds=100):
        """Waits until the trace satisfies the condition, and returns it."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.process.poll() is not None:
                self.errors.seek(0)
                self.case.fail(f"The viewer ended with {self.process.returncode}: {self.errors.read()}")
            seen = self.seen()
            if seen and condition(seen):
                return seen
            time.sleep(0.02)
        seen = self.seen()
        if seen:
            seen.pop("places")
        self.case.fail(f"The viewer did not get there: {seen}")

    def key(self, *names):
        self.xdotool("key", *names)

    def move(self, x, y):
        """Moves the mouse, and waits until a frame of the window has seen it."""
        self.xdotool("mousemove", "--window", self.window, str(x), str(y))
        self.wait(lambda seen: seen["mouse"] == [x, y])

    def hold(self, isDown):
        self.xdotool("mousedown" if isDown else "mouseup", "1")
        self.wait(lambda seen: seen["isMouseDown"] == isDown)

    def move_to(self, place):
        """Moves the mouse to a button, which may still move in the first frames of a list."""
        at = None
        while at != (found := self.wait(lambda seen: place in seen["places"])["places"][place]):
            at = found
            self.move(*at)
        return at

    def click(self, place):
        self.move_to(place)
        self.hold(True)
        self.hold(False)

    def drag(self, place, dx, dy):
        x, y = self.move_to(place)
        self.hold(True)
        self.move(x + dx // 2, y + dy // 2)
        self.move(x + dx, y + dy)
        self.hold(False)

    def type(self, text):
        """Types a path into the dialogue."""
        self.wait(lambda seen: "path" in seen["places"])
        self.xdotool("type", "--delay", "30", text)
        self.wait(lambda seen: seen["file"] == text)

    def end(self):
        """Quits by the keyboard and returns the saved state."""
        self.key("ctrl+q")
        self.case.assertEqual(self.process.wait(timeout=60), 0)
        return json.loads(self.saved.read_text())


def start_window_manager(case):
    """Starts a window manager, without which windows cannot be minimised, for a test."""
    if not shutil.which("twm"):
        case.skipTest("twm is not installed")
    settings = case.write("twmrc", "RandomPlacement\nNoTitle\nBorderWidth 0\n")
    manager = subprocess.Popen(["twm", "-f", settings], stderr=subprocess.DEVNULL)
    case.addCleanup(manager.wait)
    case.addCleanup(manager.terminate)


def start_display():
    """Starts a virtual display for this process and its children, and returns its process."""
    reading, writing = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x1024x24", "-nolisten", "tcp",
                               "-noreset"], pass_fds=[writing], stderr=subprocess.DEVNULL)
    os.close(writing)
    with os.fdopen(reading) as pipe:
        number = pipe.readline().strip()  # it has found a free one
    if not number:
        sys.exit("Xvfb could not start a display.")
    os.environ["DISPLAY"] = f":{number}"
    os.environ.pop("WAYLAND_DISPLAY", None)
    return server


def main():
    """Runs the tests in a virtual display, or skips them."""
    for program in ("Xvfb", "xdotool"):
        if not shutil.which(program):
            print(f"skipped: {program} is not installed")
            sys.exit(SKIPPED)
    server = start_display()
    try:
        unittest.main(verbosity=2)
    finally:
        server.terminate()
        server.wait()
