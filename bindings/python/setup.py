"""Puts the native library into the wheel, and all that it needs beyond the C and C++ run-times."""

import os
import shutil
import subprocess
import sys
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
# Set to 0 for the library alone: its wheel loads where the same Debian packages are installed.
BUNDLE = "PALPATE_BUNDLE"


def build_library(folder):
    """Builds the project that this folder is a part of."""
    if not (PROJECT / "capi").is_dir():
        raise SystemExit("palpate: no native library. Install from within the project, or name the file of the library "
                         "in the environment variable PALPATE_LIBRARY.")
    subprocess.run(["cmake", "-S", PROJECT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DPALPATE_BUILD_SAMPLES=OFF",
                    "-DPALPATE_BUILD_TESTS=OFF"], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "palpate", "--parallel", "2"], check=True)
    return Path(folder, "capi", "libpalpate.so")


def bundle_library(library, package):
    """With what it needs beside it, whose licences are told."""
    sys.path.insert(0, str(PROJECT / "bindings" / "bundle"))
    try:
        import bundle
    except ImportError:
        raise SystemExit(f"palpate: bindings/bundle is not there. Install from within the project, or set {BUNDLE}=0 to "
                         "take the library alone.") from None
    try:
        originals = bundle.bundle(library, package)
        (package / "THIRD_PARTY_NOTICES.md").write_text(bundle.notices(originals))
    except bundle.BundleError as error:
        raise SystemExit(f"palpate: {error}. With {BUNDLE}=0 the library is taken alone, which then needs the same "
                         "system packages wherever it is installed.") from None


class BuildWithLibrary(build_py):
    def run(self):
        super().run()
        package = Path("src" if self.editable_mode else self.build_lib, "palpate")
        with tempfile.TemporaryDirectory(prefix="palpate-build-") as folder:
            library = self.find_library(folder)
            # What is editable stays on this machine.
            if self.editable_mode or os.environ.get(BUNDLE) == "0":
                shutil.copyfile(library, package / PACKAGED_NAME)
            else:
                bundle_library(library, package)

    @staticmethod
    def find_library(folder):
        """From the environment, else from the release build, else built here and now."""
        named = os.environ.get("PALPATE_LIBRARY")
        if named or BUILT.exists():
            return Path(named or BUILT)
        return build_library(folder)


class PlatformWheel(bdist_wheel):
    """For one platform, but for every Python 3: nothing here is compiled against Python."""

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


class PlatformDistribution(Distribution):
    def has_ext_modules(self):
        return True


setup(distclass=PlatformDistribution, cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel})
