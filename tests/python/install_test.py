"""The package as pip builds and installs it, offline."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
import venv
import zipfile
from pathlib import Path

LIBRARY = Path(os.environ["PALPATE_LIBRARY"])
MODELS = Path(os.environ["PALPATE_MODELS"])
SOURCES = Path(__file__).resolve().parents[2] / "bindings" / "python"
QUERY = """
import palpate
corners = [[x, y, z] for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]
triangles = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
             [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]]
box = palpate.Model.from_arrays(corners, triangles)
print(round(palpate.query(box, box, (1.1, 0, 0, 0, 0, 0, 1), 0.2).wrench.force[0], 6))
print(palpate._raw._library._name)
"""
# A project in place of the real one, which would take minutes: its target palpate is the library of this build.
CMAKE_LISTS = f"""cmake_minimum_required(VERSION 3.25)
project(palpate NONE)
add_custom_target(palpate COMMAND ${{CMAKE_COMMAND}} -E copy {LIBRARY} ${{CMAKE_BINARY_DIR}}/capi/libpalpate.so)
"""


def plain_environment(**changes):
    """Without what would find the package or its library in the tree, or slow down pip."""
    left_out = ("PALPATE_LIBRARY", "PYTHONPATH", "LD_PRELOAD")
    return {name: value for name, value in os.environ.items() if name not in left_out} | changes


class InstallTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """An environment with a pip of its own, and Debian's setuptools and wheel."""
        cls.environment = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        venv.create(cls.environment, with_pip=True, system_site_packages=True)
        cls.python = cls.environment / "bin" / "python"

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.tree = self.folder / "tree"
        shutil.copytree(SOURCES, self.tree / "bindings" / "python",
                        ignore=shutil.ignore_patterns("*.so*", "__pycache__", "build", "*.egg-info"))

    def pip_wheel(self, **environment):
        return subprocess.run(
            [self.python, "-m", "pip", "wheel", "--no-index", "--no-build-isolation", "--no-deps", "--wheel-dir",
             self.folder, self.tree / "bindings" / "python"],
            env=plain_environment(**environment), cwd=self.folder, capture_output=True, text=True)

    def assert_wheel_has_library(self, done):
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        wheel, = self.folder.glob("*.whl")
        with zipfile.ZipFile(wheel) as archive:
            self.assertEqual(archive.read("palpate/libpalpate.so"), LIBRARY.read_bytes())
            self.assertIn("palpate/py.typed", archive.namelist())
        return wheel

    def test_an_installed_package_works_away_from_the_tree(self):
        wheel = self.assert_wheel_has_library(self.pip_wheel(PALPATE_LIBRARY=str(LIBRARY)))
        self.assertRegex(wheel.name, r"^palpate-0\.1\.0-py3-none-linux_\w+\.whl$")
        shutil.rmtree(self.tree)
        subprocess.run([self.python, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", wheel],
                       env=plain_environment(), cwd=self.folder, check=True)
        preload = {name: os.environ[name] for name in ("LD_PRELOAD",) if name in os.environ}
        done = subprocess.run([self.python, "-c", QUERY], env=plain_environment(**preload), cwd=self.folder,
                              capture_output=True, text=True)
        force, name = done.stdout.split()
        self.assertEqual(float(force), 100.0, done.stderr)
        self.assertTrue(Path(name).is_relative_to(self.environment), name)
        self.assert_readme_example_runs(plain_environment(**preload))

    def assert_readme_example_runs(self, environment):
        """The example of README.md, in a folder with nothing but its two models."""
        program, said = re.search(r"^```python\n(.*?)^```\n\n```text\n(.*?)^```$",
                                  (SOURCES.parents[1] / "README.md").read_text(), re.DOTALL | re.MULTILINE).groups()
        clean = self.folder / "clean"
        clean.mkdir()
        for model in re.findall(r"\w+\.glb", program):
            shutil.copy(MODELS / model, clean)
        done = subprocess.run([self.python, "-c", program], env=environment, cwd=clean, capture_output=True, text=True)
        self.assertEqual(done.stdout, said, done.stderr)

    def test_the_release_build_is_taken(self):
        built = self.tree / "build" / "release" / "capi"
        built.mkdir(parents=True)
        shutil.copy(LIBRARY, built / "libpalpate.so")
        self.assert_wheel_has_library(self.pip_wheel())

    def test_without_a_build_the_project_is_built(self):
        (self.tree / "capi").mkdir()
        (self.tree / "CMakeLists.txt").write_text(CMAKE_LISTS)
        self.assert_wheel_has_library(self.pip_wheel())

    def test_without_a_project_the_error_says_what_to_do(self):
        done = self.pip_wheel()
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("PALPATE_LIBRARY", done.stdout + done.stderr)
