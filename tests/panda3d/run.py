"""Runs panda_test.py in an environment that has Panda3D from PyPI and is kept from one run to the next."""

import argparse
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PACKAGES = ("panda3d==1.10.16", "panda3d-gltf==1.3.0")


def make_environment(folder):
    """Its Python; None with the last line that pip said if the packages cannot be had. Debian's numpy serves."""
    python, made = folder / "bin" / "python", folder / "made"
    if made.exists():
        return python, ""
    for command in ([sys.executable, "-m", "venv", "--clear", "--system-site-packages", folder],
                    [folder / "bin" / "pip", "install", "--quiet", "--retries", "1", "--timeout", "20", *PACKAGES]):
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            return None, (done.stderr.strip() or done.stdout.strip() or "venv failed").splitlines()[-1]
    made.touch()
    return python, ""


def main():
    parser = argparse.ArgumentParser()
    for name in ("library", "palpate", "make-motion", "models", "folder"):
        parser.add_argument(f"--{name}", type=lambda text: Path(text).resolve(), required=True)
    arguments = parser.parse_args()
    python, why = make_environment(arguments.folder / "env")
    if python is None:
        print(f"Panda3D: skipped: {' and '.join(PACKAGES)} cannot be had ({why})")
        return 0
    return subprocess.run([python, "-B", HERE / "panda_test.py"], env=dict(
        os.environ, PYTHONPATH=str(ROOT / "bindings" / "python" / "src"), PALPATE_LIBRARY=str(arguments.library),
        PALPATE_CLI=str(arguments.palpate), PALPATE_MAKE_MOTION=str(arguments.make_motion),
        PALPATE_MODELS=str(arguments.models))).returncode


if __name__ == "__main__":
    sys.exit(main())
