"""A runtime that is not there is named by the tests that need it, and its tests do not pass silently."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import count_runtimes

TESTS = Path(__file__).resolve().parents[1]
# What each asks for; it is not looked at before the runtime is.
OPTIONS = {
    "csharp": ("library", "layout", "reference", "models", "folder"),
    "unity": ("library", "models", "folder"),
    "godot": ("plugin", "palpate", "make-motion", "models", "folder"),
    "panda3d": ("library", "palpate", "make-motion", "models", "folder"),
}
MISSING = {
    ("csharp", "mono"): "C# under Mono with NUnit: skipped: mono is not installed",
    ("csharp", "full_aot"): "C# under Mono ahead of time: skipped: mono is not installed",
    ("csharp", "coreclr"): "C# under CoreCLR: skipped: dotnetcore2",
    ("unity",): "Unity package under Mono: skipped: mcs is not installed",
    ("godot",): "Godot: skipped: godot3-server is not installed",
    ("panda3d",): "Panda3D: skipped: panda3d",
}


class MissingRuntimes(unittest.TestCase):
    def test_each_is_named(self):
        for (part, *runtime), wanted in MISSING.items():
            with self.subTest(part=part, runtime=runtime), tempfile.TemporaryDirectory() as folder:
                options = [f"--{name}={folder}" for name in OPTIONS[part]]
                # No program and no index of packages.
                environment = dict(os.environ, PATH=folder, PIP_INDEX_URL="http://127.0.0.1:9/", PIP_NO_CACHE_DIR="1")
                done = subprocess.run([sys.executable, "-B", TESTS / part / "run.py", *runtime, *options],
                                      env=environment, capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                told = count_runtimes.summary([done.stdout])
                self.assertEqual(len(told), 1, done.stdout)
                self.assertTrue(told[0].startswith(wanted), told)


if __name__ == "__main__":
    unittest.main()
