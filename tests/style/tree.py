"""The files of the project that the rules look at."""

import os
from pathlib import Path

CPP_SUFFIXES = {".c", ".h", ".cpp", ".hpp", ".cc"}
TEXT_SUFFIXES = CPP_SUFFIXES | {".cmake", ".cs", ".in", ".json", ".map", ".md", ".py", ".sh", ".svg", ".toml", ".txt"}


def ignored_folders(root):
    """Folders that .gitignore names from the root, such as /build/, and git's own."""
    lines = (root / ".gitignore").read_text().splitlines() if (root / ".gitignore").exists() else []
    rooted = {line.strip("/") for line in lines if line.startswith("/") and line.endswith("/")}
    return rooted | {".git", ".cache"}


def files(root, suffixes, folders=("",)):
    """Every file below the given folders of root with one of the suffixes, in order."""
    ignored = ignored_folders(root)
    found = []
    for folder in folders:
        for path, subfolders, names in os.walk(root / folder):
            relative = Path(path).relative_to(root)
            subfolders[:] = sorted(s for s in subfolders if str(relative / s) not in ignored and s != "__pycache__")
            found += [relative / name for name in names if Path(name).suffix in suffixes]
    return sorted(set(found))


def numbered_lines(root, path):
    return enumerate((root / path).read_text(encoding="utf-8", errors="replace").splitlines(), start=1)


def matches(root, paths, pattern, complaint):
    """One message for each line that the pattern is found in."""
    return [f"{path}:{number}: {complaint}" for path in paths for number, line in numbered_lines(root, path)
            if pattern.search(line)]
