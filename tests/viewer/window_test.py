"""The viewer in a real window, on a display of its own: keys move the tool, a slider changes the stiffness, files fall
on it, a key ends it."""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from png import Picture, is_hue
from viewer_run import LEFT_PANEL, MODELS, RIGHT_PANEL, VIEWER, run, skip

WIDTH, HEIGHT = 960, 600
TOOL_HUE = (25, 42, 0.6)
PNG_END = b"IEND\xaeB`\x82"
PATIENCE = 60.0  # s


class Display:
    """An X server without a screen."""

    def __init__(self):
        numbers, write = os.pipe()
        # It would begin anew when its last client leaves, and take the viewer's connection along.
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x1024x24", "-noreset",
                                        "-nolisten", "tcp"], pass_fds=(write,), stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(numbers) as pipe:
            self.name = f":{pipe.readline().strip()}"

    def close(self):
        self.server.terminate()
        self.server.wait()


class Window(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="palpate-window-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        display = Display()
        self.addCleanup(display.close)
        self.environment = dict(os.environ, DISPLAY=display.name)
        self.environment.pop("WAYLAND_DISPLAY", None)

    def start(self, *arguments):
        viewer = subprocess.Popen([VIEWER, *map(str, arguments)], env=self.environment, cwd=self.folder,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(viewer.communicate)
        self.addCleanup(viewer.kill)
        return viewer

    def xdotool(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, capture_output=True,
                              text=True, timeout=30).stdout.strip()

    def within(self, seconds, condition):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            outcome = condition()
            if outcome:
                return outcome
            time.sleep(0.1)
        return None

    def wait(self, what, condition):
        return self.within(PATIENCE, condition) or self.fail(f"{what} did not come about")

    def focus(self):
        window = self.wait("a window", lambda: self.xdotool("search", "--onlyvisible", "--name", "^Palpate$"))
        window = window.split()[0]
        self.xdotool("windowmove", window, 0, 0)
        self.xdotool("windowfocus", "--sync", window)
        return window

    def press(self, key):
        # Longer than a frame may take, so that no press is lost between two.
        self.xdotool("keydown", key)
        time.sleep(0.2)
        self.xdotool("keyup", key)

    def picture(self):
        path = self.folder / "palpate-viewer.png"
        path.unlink(missing_ok=True)
        for _ in range(3):
            # A key that is pressed before the window has come to life is lost.
            self.press("f")
            if self.within(PATIENCE / 3, lambda: path.exists() and path.read_bytes().endswith(PNG_END)):
                return Picture(path)
        return self.fail("a screenshot did not come about")

    def tool_middle(self, picture):
        places = [(x, y) for x, y, colour in picture.pixels(LEFT_PANEL, 0, WIDTH - RIGHT_PANEL, HEIGHT, 3)
                  if is_hue(colour, *TOOL_HUE)]
        return len(places), sum(x for x, _ in places) / max(1, len(places))

    def test_keys_move_the_tool_and_a_slider_the_stiffness(self):
        viewer = self.start(f"{MODELS}/box.glb", f"{MODELS}/icosphere.glb", "--size", WIDTH, HEIGHT)
        self.focus()
        before = self.wait("the tool", lambda: self.shown())
        self.xdotool("keydown", "d")
        time.sleep(1.5)
        self.xdotool("keyup", "d")
        after = self.picture()
        self.assertEqual((after.width, after.height), (WIDTH, HEIGHT))
        self.assertGreater(self.tool_middle(after)[1], self.tool_middle(before)[1] + 10)

        stiffness = (12, 340, 160, 358)  # the slider's place in the panel
        self.xdotool("mousemove", 130, 349, "mousedown", 1)
        time.sleep(0.5)
        self.xdotool("mouseup", 1)
        changed = self.picture()
        self.assertNotEqual(list(after.pixels(*stiffness)), list(changed.pixels(*stiffness)))
        self.press("c")
        log = self.folder / "palpate-viewer.csv"
        self.wait("a log", lambda: log.exists() and log.stat().st_size > 0)
        self.press("Escape")
        self.assertEqual(viewer.wait(PATIENCE), 0)

    def shown(self):
        """A picture once the models are loaded."""
        picture = self.picture()
        return picture if self.tool_middle(picture)[0] > 60 else None

    def test_files_are_opened_by_their_paths(self):
        viewer = self.start("--size", WIDTH, HEIGHT)
        self.focus()
        self.picture()
        for name in ("box.glb", "icosphere.glb"):
            self.xdotool("mousemove", 100, 76, "click", 1)
            time.sleep(0.3)
            self.xdotool("type", "--delay", 30, f"{MODELS}/{name}")
            self.press("Return")
        self.wait("the tool", lambda: self.shown())
        self.press("Escape")
        self.assertEqual(viewer.wait(PATIENCE), 0)

    def drop(self, window, *files):
        done = subprocess.run([sys.executable, "-B", Path(__file__).with_name("drop.py"), window, *map(str, files)],
                              env=self.environment, capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 0, done.stderr)

    @unittest.skipUnless(importlib.util.find_spec("Xlib"), "python3-xlib is not installed")
    def test_files_are_dropped(self):
        spaced = self.folder / "a scene.glb"
        shutil.copy(f"{MODELS}/box.glb", spaced)
        viewer = self.start("--size", WIDTH, HEIGHT)
        window = self.focus()
        self.picture()
        self.drop(window, spaced, f"{MODELS}/icosphere.glb")
        self.wait("the tool", lambda: self.shown())
        self.press("Escape")
        self.assertEqual(viewer.wait(PATIENCE), 0)
        self.assertEqual(viewer.stderr.read(), "")

    def test_the_window_lives_while_models_are_loaded_and_what_is_felt_is_recorded(self):
        viewer = self.start(f"{MODELS}/helicopter_113k.glb", f"{MODELS}/gear_6k.glb", "--tool-scale", 0.5, "--up", "z",
                            "--size", WIDTH, HEIGHT)
        self.focus()
        self.wait("the tool", lambda: self.shown())
        trace = self.folder / "palpate-viewer.plptrace"
        self.press("t")
        self.wait("a trace", lambda: trace.exists())
        time.sleep(0.5)
        self.press("Escape")
        self.assertEqual(viewer.wait(PATIENCE), 0)
        said = viewer.stdout.read()
        self.assertRegex(said, r"the servo ran \d+ steps at [\d.]+ a second beside the pictures, \d+ of them too long")
        frames, while_loading = map(int, re.search(r"(\d+) frames were drawn, (\d+) of them while", said).groups())
        print(f"{while_loading} of {frames} frames while models were loaded")
        self.assertGreaterEqual(while_loading, 3)
        replayed = run("--headless", f"{MODELS}/helicopter_113k.glb", f"{MODELS}/gear_6k.glb", "--tool-scale", 0.5,
                       "--replay", trace)
        self.assertRegex(replayed.stdout, r"^[1-9]\d* ticks")

    def test_a_device_that_is_not_there_is_told(self):
        viewer = self.start(f"{MODELS}/box.glb", f"{MODELS}/icosphere.glb", "--device", "sim:nothing")
        self.focus()
        self.wait("the tool", lambda: self.shown())
        self.press("Escape")
        self.assertEqual(viewer.wait(PATIENCE), 0)
        self.assertRegex(viewer.stderr.read(), r"^palpate-viewer: [^\n]*sim:nothing[^\n]*\n$")

    def test_a_missing_file_is_told_and_the_window_stays(self):
        viewer = self.start(self.folder / "no_such.glb", "--size", WIDTH, HEIGHT)
        self.focus()
        picture = self.picture()
        self.assertIsNone(viewer.poll())
        red = sum(is_hue(colour, 0, 12, 0.45) for _, _, colour in
                  picture.pixels(LEFT_PANEL, HEIGHT - 80, WIDTH, HEIGHT))
        self.assertGreater(red, 40)
        self.press("Escape")
        self.assertEqual(viewer.wait(PATIENCE), 0)
        self.assertRegex(viewer.stderr.read(), r"^palpate-viewer: [^\n]*no_such\.glb[^\n]*\n$")


class NoDisplay(unittest.TestCase):
    def test_without_a_display_one_sentence_says_so(self):
        environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        done = subprocess.run([VIEWER], env=environment, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"^palpate-viewer: [^\n]*--headless[^\n]*\n$")


if __name__ == "__main__":
    for program in ("Xvfb", "xdotool"):
        if not shutil.which(program):
            skip(f"{program} is not installed")
    unittest.main(verbosity=2)
