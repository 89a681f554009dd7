"""Fails unless header, version script and library name the same functions."""

import re
import subprocess
import sys
from pathlib import Path


def declared(header):
    return set(re.findall(r"^PLP_API [^(]*?\b(plp_\w+)\(", header.read_text(), re.MULTILINE))


def mapped(version_script):
    return set(re.findall(r"^\s+(plp_\w+);", version_script.read_text(), re.MULTILINE))


def exported(library):
    command = ["nm", "--dynamic", "--defined-only", "--format=posix", library]
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    # The version's own name is the one absolute symbol.
    return {line.split("@")[0].split()[0] for line in lines if line.split()[1] != "A"}


def main(header, version_script, library):
    names = declared(Path(header))
    for origin, others in (("version script", mapped(Path(version_script))), ("library", exported(library))):
        if others != names:
            return f"header and {origin} differ: {sorted(names ^ others)}"
    return 0 if names else "the header declares nothing"


sys.exit(main(*sys.argv[1:]))
