#!/usr/bin/env python3
"""Writes from palpate.h what must say the same: the raw layers of the bindings and the linker's version script."""

import argparse
import difflib
import sys
from pathlib import Path

import csharp_errors
import csharp_raw
import header
import layout_program
import python_raw
import version_script
from lexer import HeaderError

ROOT = Path(__file__).resolve().parents[2]
HEADER = "capi/include/palpate/palpate.h"
OUTPUTS = {
    "bindings/csharp/src/Raw.cs": csharp_raw.emit,
    "bindings/csharp/src/Exceptions.cs": csharp_errors.emit,
    "bindings/python/src/palpate/_raw.py": python_raw.emit,
    "capi/palpate.map": version_script.emit,
}


def drift(path, made):
    """How the file differs from what the header says; "" if it does not."""
    kept = path.read_text() if path.exists() else ""
    return "".join(difflib.unified_diff(kept.splitlines(True), made.splitlines(True), str(path), "from the header"))


def check(root, interface):
    differences = [drift(root / path, emit(interface)) for path, emit in OUTPUTS.items()]
    sys.stdout.writelines(differences)
    return any(differences)


def write(root, interface):
    for path, emit in OUTPUTS.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(emit(interface))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing; fail if a file is not what it would be")
    parser.add_argument("--layout", type=Path, metavar="FILE", help="write only a C program that prints the layout")
    parser.add_argument("--root", type=Path, default=ROOT, help="of the project")
    arguments = parser.parse_args()
    try:
        interface = header.parse((arguments.root / HEADER).read_text())
        if arguments.layout:
            arguments.layout.write_text(layout_program.emit(interface))
        elif arguments.check:
            return "These files are not what the header says; run bindings/gen/generate.py." if check(
                arguments.root, interface) else 0
        else:
            write(arguments.root, interface)
    except (HeaderError, csharp_raw.Unsupported) as error:
        return f"{HEADER}: {error}"
    return 0


if __name__ == "__main__":
    sys.exit(main())
