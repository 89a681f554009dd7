"""The package as pip builds and installs it, offline."""

import importlib.util
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
BINDINGS = Path(__file__).resolve().parents[2] / "bindings"
# A sanitized library is for this machine, whose sanitizers it needs.
SANITIZED = "LD_PRELOAD" in os.environ
# What every Linux has, beside the loader and what Python itself brought.
SYSTEM = re.compile(r"(ld-linux-x86-64|libc|libm|libdl|libpthread|librt|libstdc\+\+|libgcc_s)[-.\d]*\.so[.\d]*$")
QUERY = """
import ctypes
try:
    import numpy
except ImportError:
    pass

def mapped():
    with open("/proc/self/maps") as maps:
        return {line.split()[5] for line in maps if ".so" in line}

before = mapped()
import palpate
corners = [[x, y, z] for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]
triangles = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
             [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]]
box = palpate.Model.from_arrays(corners, triangles)
print(round(palpate.query(box, box, (1.1, 0, 0, 0, 0, 0, 1), 0.2).wrench.force[0], 6))
print(palpate._raw._library._name)
scene = palpate.Scene(0.2)
scene.add(box)
scene.add(box, (1.1, 0, 0, 0, 0, 0, 1), "tool")
assert scene.step().set_count == 1
print(*sorted(mapped() - before), sep="\\n")
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
        for part in ("python", "bundle"):
            shutil.copytree(BINDINGS / part, self.tree / "bindings" / part,
                            ignore=shutil.ignore_patterns("*.so*", "__pycache__", "build", "*.egg-info"))

    def pip_wheel(self, bundle=not SANITIZED, **environment):
        """Bundled where that is looked at, because it takes a while."""
        environment |= {} if bundle else {"PALPATE_BUNDLE": "0"}
        return subprocess.run(
            [self.python, "-m", "pip", "wheel", "--no-index", "--no-build-isolation", "--no-deps", "--wheel-dir",
             self.folder, self.tree / "bindings" / "python"],
            env=plain_environment(**environment), cwd=self.folder, capture_output=True, text=True)

    def assert_wheel_has_library(self, done, bundle=not SANITIZED):
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        wheel, = self.folder.glob("*.whl")
        with zipfile.ZipFile(wheel) as archive:
            library, names = archive.read("palpate/libpalpate.so"), archive.namelist()
            self.assertIn("palpate/py.typed", names)
            if bundle:
                self.assertIn("palpate/libembree3.so", names)
                self.assertIn("# libembree", archive.read("palpate/THIRD_PARTY_NOTICES.md").decode())
            else:
                self.assertEqual(library, LIBRARY.read_bytes())
                self.assertNotIn("palpate/libembree3.so", names)
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
        self.assertEqual(done.returncode, 0, done.stderr)
        force, name, *mapped = done.stdout.split()
        self.assertEqual(float(force), 100.0)
        self.assertTrue(Path(name).is_relative_to(self.environment), name)
        if not SANITIZED:
            self.assert_libraries_stand_alone(Path(name).parent, mapped)
        self.assert_examples_run(plain_environment(**preload))

    def assert_libraries_stand_alone(self, package, mapped):
        """What the package loads is in it, or is a system's; so is what any of its libraries asks for."""
        self.assertIn(str(package / "libembree3.so"), mapped)
        outside = [path for path in mapped if not Path(path).is_relative_to(package) and "/lib-dynload/" not in path]
        self.assertEqual([path for path in outside if not SYSTEM.match(Path(path).name)], [])
        own = {path.name for path in package.glob("*.so")}
        for library in sorted(own):
            dynamic = subprocess.run(["readelf", "--dynamic", "--wide", package / library], check=True,
                                     capture_output=True, text=True).stdout
            for needed in re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic):
                self.assertTrue(needed in own or SYSTEM.match(needed), f"{library} needs {needed}")
            self.assertRegex(dynamic, r"\(RUNPATH\).*\[\$ORIGIN\]", library)

    def assert_examples_run(self, environment):
        """That of README.md, in a folder with nothing but its two models, and those that come with the package."""
        program, said = re.search(r"^```python\n(.*?)^```\n\n```text\n(.*?)^```$",
                                  (BINDINGS.parent / "README.md").read_text(), re.DOTALL | re.MULTILINE).groups()
        clean = self.folder / "clean"
        clean.mkdir()
        models = re.findall(r"\w+\.glb", program)
        for model in models:
            shutil.copy(MODELS / model, clean)

        def printed(*command):
            done = subprocess.run([self.python, *command], env=environment, cwd=clean, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            return done.stdout

        self.assertEqual(printed("-c", program), said)
        examples = {"force_along_path.py": r"^strongest after \d+\.\d mm: \S+ \S+ \S+ N$"}
        if importlib.util.find_spec("scipy"):
            examples["let_go.py"] = r"^after 0\.4 s it has slid to \S+ \S+ \S+ mm, \S+ mm from the nearest of [1-9]"
        for example, expected in examples.items():
            shutil.copy(BINDINGS / "python" / "examples" / example, clean)
            self.assertRegex(printed(example, *models), expected)

    def test_the_release_build_is_taken(self):
        built = self.tree / "build" / "release" / "capi"
        built.mkdir(parents=True)
        shutil.copy(LIBRARY, built / "libpalpate.so")
        self.assert_wheel_has_library(self.pip_wheel(bundle=False), bundle=False)

    def test_without_a_build_the_project_is_built(self):
        (self.tree / "capi").mkdir()
        (self.tree / "CMakeLists.txt").write_text(CMAKE_LISTS)
        self.assert_wheel_has_library(self.pip_wheel(bundle=False), bundle=False)

    @unittest.skipIf(SANITIZED, "a sanitized library is not bundled")
    def test_without_the_tools_to_bundle_the_error_says_what_to_do(self):
        empty = self.folder / "empty"
        empty.mkdir()
        done = self.pip_wheel(True, PALPATE_LIBRARY=str(LIBRARY), PATH=str(empty))
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stdout + done.stderr, "is not installed. With PALPATE_BUNDLE=0")

    def test_without_a_project_the_error_says_what_to_do(self):
        done = self.pip_wheel()
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("PALPATE_LIBRARY", done.stdout + done.stderr)
