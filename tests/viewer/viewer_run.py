"""How the tests run the viewer."""

import os
import subprocess
import sys

VIEWER, CLI, MODELS = (os.environ[name] for name in ("PALPATE_VIEWER", "PALPATE_CLI", "PALPATE_MODELS"))
LEFT_PANEL, RIGHT_PANEL = 272, 268


def run(*arguments, program=VIEWER):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=120)


def skip(why):
    """The whole test, by its name."""
    print(f"skipped: {why}")
    sys.exit(0)
