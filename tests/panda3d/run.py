"""Runs panda_test.py in an environment that has Panda3D from PyPI and is kept from one run to the next."""

import argparse
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.append(str(ROOT / "tests" / "support"))

from pip_environment import Unavailable, pip_environment  # noqa: E402  (its folder was not in the path before)

PACKAGES = ("panda3d==1.10.16", "panda3d-gltf==1.3.0")


def main():
    parser = argparse.ArgumentParser()
    for name in ("library", "palpate", "make-motion", "models", "folder"):
        parser.add_argument(f"--{name}", type=lambda text: Path(text).resolve(), required=True)
    arguments = parser.parse_args()
    try:  # Debian's numpy serves
        python = pip_environment(arguments.folder / "env", PACKAGES, venv_options=["--system-site-packages"])
    except Unavailable as error:
        print(f"Panda3D: skipped: {error}")
        return 0
    return subprocess.run([python, "-B", HERE / "panda_test.py"], env=dict(
        os.environ, PYTHONPATH=str(ROOT / "bindings" / "python" / "src"), PALPATE_LIBRARY=str(arguments.library),
        PALPATE_CLI=str(arguments.palpate), PALPATE_MAKE_MOTION=str(arguments.make_motion),
        PALPATE_MODELS=str(arguments.models))).returncode


if __name__ == "__main__":
    sys.exit(main())
