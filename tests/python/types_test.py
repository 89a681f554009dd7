"""The package's annotations, as mypy reads them: its own code, and a program that uses it."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[2] / "bindings" / "python"
# Of two Pythons, the one that runs this may have no mypy where Debian's has.
PYTHONS = [sys.executable, "/usr/bin/python3"]
GOOD = """
import palpate

scene = palpate.Scene(0.01)
bodies: list[palpate.Body] = scene.load_gltf("scene.glb", tool="probe")
x, y, z = scene.step().wrench.force
name: str = bodies[0].info.name
"""
WRONG = """
import palpate

palpate.Scene("far").load_gltf(7)
"""


def python_with_mypy():
    for python in PYTHONS:
        if Path(python).exists() and subprocess.run([python, "-c", "import mypy"], capture_output=True).returncode == 0:
            return python
    return None


@unittest.skipUnless(python_with_mypy(), "mypy is not installed")
class TypesTest(unittest.TestCase):
    def mypy(self, *arguments):
        return subprocess.run([python_with_mypy(), "-m", "mypy", "--cache-dir", "/dev/null", *arguments], cwd=PACKAGE,
                              capture_output=True, text=True,
                              env={name: value for name, value in os.environ.items() if name != "LD_PRELOAD"})

    def check(self, program):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "program.py"
            path.write_text(program)
            return self.mypy("--strict", path)

    def test_the_package_keeps_its_own_annotations(self):
        done = self.mypy()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_program_is_checked_against_them(self):
        done = self.check(GOOD)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        done = self.check(WRONG)
        self.assertEqual(done.stdout.count("[arg-type]"), 2, done.stdout + done.stderr)
