"""The examples of the package, run as a reader would run them."""

import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "bindings" / "python" / "examples"
MODELS = Path(os.environ["PALPATE_MODELS"])
PAIR = [MODELS / "crankshaft_45k.glb", MODELS / "gear_6k.glb"]


def is_missing(module):
    return importlib.util.find_spec(module) is None


class ExamplesTest(unittest.TestCase):
    def run_example(self, name, *arguments):
        done = subprocess.run([sys.executable, "-B", EXAMPLES / name, *PAIR, *arguments], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_force_along_a_path(self):
        printed = self.run_example("force_along_path.py")
        self.assertRegex(printed, r"^strongest after \d+\.\d mm: \S+ \S+ \S+ N$")
        force = [float(part) for part in printed.split()[-4:-1]]
        self.assertGreater(sum(part * part for part in force), 1.0)

    @unittest.skipIf(is_missing("matplotlib"), "matplotlib is not installed")
    def test_force_along_a_path_is_plotted(self):
        with tempfile.TemporaryDirectory() as folder:
            image = Path(folder) / "force.png"
            self.run_example("force_along_path.py", "--plot", image)
            self.assertEqual(image.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    @unittest.skipIf(is_missing("scipy"), "SciPy is not installed")
    def test_let_go(self):
        printed = self.run_example("let_go.py")
        found = re.fullmatch(r"after 0\.4 s it has slid to (\S+) (\S+) (\S+) mm, (\S+) mm from the nearest of (\d+) "
                             r"contacts\n", printed)
        self.assertIsNotNone(found, printed)
        height, gap, contacts = float(found[2]), float(found[4]), int(found[5])
        self.assertTrue(0 < height < 75 and 0 < gap < 3 and contacts > 0, printed)
