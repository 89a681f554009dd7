"""How the native library is found, each in a process of its own."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

LIBRARY = Path(os.environ["PALPATE_LIBRARY"])
PACKAGE = Path(os.environ["PYTHONPATH"]) / "palpate"
REPORT = "import palpate; print(palpate.version(), palpate._raw._library._name)"


class LibraryTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.package = self.folder / "palpate"
        shutil.copytree(PACKAGE, self.package, ignore=shutil.ignore_patterns("*.so*", "__pycache__"))

    def load(self, **environment):
        kept = {name: value for name, value in os.environ.items() if name != "PALPATE_LIBRARY"}
        return subprocess.run([sys.executable, "-B", "-c", REPORT], cwd=self.folder, capture_output=True, text=True,
                              env=kept | {"PYTHONPATH": str(self.folder)} | environment)

    def assert_loaded(self, done, name):
        self.assertEqual(done.stdout.split(), ["0.1.0", str(name)], done.stderr)

    def test_the_environment_comes_first(self):
        shutil.copy(LIBRARY, self.package / "libpalpate.so")
        self.assert_loaded(self.load(PALPATE_LIBRARY=str(LIBRARY)), LIBRARY)

    def test_then_the_packages_own_folder(self):
        shutil.copy(LIBRARY, self.package / "libpalpate.so")
        self.assert_loaded(self.load(), self.package / "libpalpate.so")

    def test_then_the_loader(self):
        self.assert_loaded(self.load(LD_LIBRARY_PATH=str(LIBRARY.parent)), "libpalpate.so.0")

    def test_a_library_that_the_environment_names_wrongly_is_not_replaced(self):
        shutil.copy(LIBRARY, self.package / "libpalpate.so")
        done = self.load(PALPATE_LIBRARY="/nowhere/libpalpate.so")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("ImportError", done.stderr)
        self.assertIn("/nowhere/libpalpate.so", done.stderr)

    def test_another_library_is_refused(self):
        done = self.load(PALPATE_LIBRARY="libm.so.6")
        self.assertIn("ImportError: libm.so.6 is of another version", done.stderr)
