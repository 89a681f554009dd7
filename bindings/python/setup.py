"""Puts the native library into the wheel."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70.1
    from wheel.bdist_wheel import bdist_wheel

PROJECT = Path(__file__).resolve().parents[2]
BUILT = PROJECT / "build" / "release" / "capi" / "libpalpate.so"
# The name that the package looks for, without the links that a wheel cannot hold.
PACKAGED_NAME = "libpalpate.so"


def build_library(folder):
    """Builds the project that this folder is a part of."""
    if not (PROJECT / "capi").is_dir():
        raise SystemExit("palpate: no native library. Install from within the project, or name the file of the library "
                         "in the environment variable PALPATE_LIBRARY.")
    subprocess.run(["cmake", "-S", PROJECT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DPALPATE_BUILD_SAMPLES=OFF",
                    "-DPALPATE_BUILD_TESTS=OFF"], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "palpate", "--parallel", "2"], check=True)
    return Path(folder, "capi", "libpalpate.so")


def copy_library(target):
    """From the environment, else from the release build, else built here and now."""
    named = os.environ.get("PALPATE_LIBRARY")
    if named or BUILT.exists():
        shutil.copyfile(named or BUILT, target)
        return
    with tempfile.TemporaryDirectory(prefix="palpate-build-") as folder:
        shutil.copyfile(build_library(folder), target)


class BuildWithLibrary(build_py):
    def run(self):
        super().run()
        package = Path("src") if self.editable_mode else Path(self.build_lib)
        copy_library(package / "palpate" / PACKAGED_NAME)


class PlatformWheel(bdist_wheel):
    """For one platform, but for every Python 3: nothing here is compiled against Python."""

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


class PlatformDistribution(Distribution):
    def has_ext_modules(self):
        return True


setup(distclass=PlatformDistribution, cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel})
