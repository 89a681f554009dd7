"""The sources of a build in units: files of one part of the project that are looked at together, because most of the time of an
analysis goes into the headers that they share."""

import json
import re
import shlex
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

FOLDERS = ("engine", "capi", "assets", "samples")
NAMELESS = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
# The name that a line at the margin of a nameless namespace defines.
DEFINED = re.compile(r"^(?! )(?:(?:class|struct|enum class|using) (\w+)|[\w:<>,*& ]*?\b(\w+)\s*[(={\[;])", re.MULTILINE)
# What a header gives to all: a source's own function of that name would be taken for it, or not, in a unit.
SHARED = re.compile(r"^inline [\w:<>,*& ]*?\b(\w+)\(", re.MULTILINE)
# Compiled again and again for each instruction set, by including itself.
ALONE = "foreach_target.h"
KEPT_FLAGS = re.compile(r"-(I|D|std=|f|W(?!error))")


@dataclass
class Unit:
    """Sources, and all flags that they are compiled with."""

    part: str
    sources: list[Path]
    flags: list[str]


def own_names(text):
    """What a source defines for itself: two with one name cannot be in one unit."""
    return {first or second for block in NAMELESS.findall(text) for first, second in DEFINED.findall(block)}


def _flags(command):
    words = iter(shlex.split(command))
    kept = []
    for word in words:
        if word == "-isystem":
            kept += [word, next(words)]
        elif KEPT_FLAGS.match(word):
            kept.append(word)
    return kept


def shared_names(folder):
    return {name for header in folder.rglob("*.h") for name in SHARED.findall(header.read_text())}


def _units_of_part(part, entries, shared=frozenset()):
    """First fit: few units, in each of which no two sources define the same name, nor one that `shared` has."""
    found, taken = [], []
    for source, flags in entries:
        text = source.read_text()
        own = own_names(text)
        alone = ALONE in text or own & shared
        fits = [i for i, names in enumerate(taken) if names is not None and not names & own]
        if alone or not fits:
            found.append(Unit(part, [source], flags))
            taken.append(None if alone else own)
        else:
            unit = found[fits[0]]
            unit.sources.append(source)
            unit.flags += [flag for flag in flags if flag not in unit.flags]
            taken[fits[0]] |= own
    return found


def _part(folder):
    """The engine is one; elsewhere each folder may have a program of its own."""
    return "engine" if folder.parts[0] == "engine" else str(folder)


def units(root, build, folders=FOLDERS):
    """The units of what the build compiles of the project below the folders."""
    parts = defaultdict(list)
    for entry in json.loads((build / "compile_commands.json").read_text()):
        source = Path(entry["file"])
        if source.suffix != ".cpp" or not source.is_relative_to(root):
            continue
        relative = source.relative_to(root)
        if any(relative.is_relative_to(folder) for folder in folders):
            parts[_part(relative.parent)].append((source, _flags(entry["command"])))
    shared = shared_names(root / "engine")
    return [unit for part in sorted(parts) for unit in _units_of_part(part, parts[part], shared)]
