"""Which folder may include which."""

import re
from pathlib import PurePosixPath

import tree

# Direct permissions; a folder may also include what those may.
BELOW = {
    "engine/base": (),
    "engine/math": ("engine/base",),
    "engine/mesh": ("engine/math",),
    "engine/gltf": ("engine/mesh",),
    "engine/kernel": ("engine/math",),
    "engine/snch": ("engine/mesh", "engine/kernel"),
    "engine/descent": ("engine/snch", "engine/kernel"),
    "engine/contact": ("engine/math",),
    "engine/scene": ("engine/descent", "engine/contact"),
    "engine/exchange": ("engine/base",),
    "engine/runtime": ("engine/scene", "engine/descent", "engine/exchange", "engine/device",
                       "engine/trace"),
    "engine/device": ("engine/math", "engine/exchange"),
    "engine/trace": ("engine/exchange",),
}
# What may be seen outside the engine. The samples stand on the public header alone, as any program of a user does.
OUTER = {
    "capi": ("engine", "capi", "palpate"),
    "samples": ("samples", "palpate"),
    "assets": ("assets", "engine"),
    "bindings": ("bindings", "palpate"),
}
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
LINKED_LAYER = re.compile(r"\bpalpate_(\w+)")


def all_below(layer):
    found = {layer}
    for lower in BELOW[layer]:
        found |= all_below(lower)
    return found


def folder_of(path):
    """engine/mesh for a file of that layer, otherwise the top-level folder."""
    parts = PurePosixPath(path).parts
    return "/".join(parts[:2]) if parts[0] == "engine" and len(parts) > 2 else parts[0]


def project_path(root, includer, quote, name):
    """The path below the root that an include names; None for a file of another project."""
    if PurePosixPath(name).parts[0] in ("engine", "capi", "samples", "assets", "tests", "palpate"):
        return name
    beside = (root / includer).parent / name
    if quote == '"' and beside.exists():
        return str(beside.resolve().relative_to(root.resolve()))
    return None


def may_include(includer, included):
    layer = folder_of(includer)
    if layer in BELOW:
        return folder_of(included) in all_below(layer)
    return layer in OUTER and PurePosixPath(included).parts[0] in OUTER[layer]


def include_violations(root, path):
    found = []
    for number, line in tree.numbered_lines(root, path):
        include = INCLUDE.match(line)
        included = include and project_path(root, path, *include.groups())
        if included and not may_include(str(path), included):
            found.append(f"{path}:{number}: {folder_of(path)} may not include {included}")
    return found


def link_violations(root, layer):
    """A layer's CMakeLists.txt names no layer that its sources may not include."""
    path = f"{layer}/CMakeLists.txt"
    if not (root / path).exists():
        return []
    return [f"{path}:{number}: {layer} may not link {name}" for number, line in tree.numbered_lines(root, path)
            for name in LINKED_LAYER.findall(line)
            if f"engine/{name}" in BELOW and f"engine/{name}" not in all_below(layer)]


def violations(root):
    sources = tree.files(root, tree.CPP_SUFFIXES, ("assets", "bindings", "capi", "engine", "samples"))
    found = [message for path in sources for message in include_violations(root, path)]
    return found + [message for layer in BELOW for message in link_violations(root, layer)]
