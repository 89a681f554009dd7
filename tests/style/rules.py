"""The rules. Each takes the root of a tree and returns a list of violations."""

import re
import shutil
import subprocess

import layers
import tree

CODE_FOLDERS = ("assets", "bindings", "capi", "engine", "samples", "tests")
TOP_LEVEL = {"CMakeLists.txt", "CMakePresets.json", "README.md", "LICENSE", "CHANGELOG.md",
             "capi", "engine", "bindings", "samples", "tests", "assets"}
# clang-format's output changes between major versions; Debian 12 has this one.
CLANG_FORMAT_MAJOR = "14"

ATOMIC = re.compile(r"std::atomic|\bmemory_order\b|<atomic>|<stdatomic\.h>|\b_Atomic\b|\b__atomic_|\b__sync_")
UNFINISHED = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X)\b")
TAB = re.compile(r"\t")


def atomics(root):
    """Every atomic lives in engine/exchange, where each names its order and why."""
    sources = tree.files(root, tree.CPP_SUFFIXES, ("assets", "bindings", "capi", "engine", "samples"))
    outside = [path for path in sources if path.parts[:2] != ("engine", "exchange")]
    return tree.matches(root, outside, ATOMIC, "an atomic outside engine/exchange")


def includes(root):
    """Folders include, and link, only what is below them."""
    return layers.violations(root)


def unfinished(root):
    return tree.matches(root, tree.files(root, tree.TEXT_SUFFIXES), UNFINISHED, "unfinished work")


def tabs(root):
    return tree.matches(root, tree.files(root, tree.TEXT_SUFFIXES), TAB, "a tab")


def top_level(root):
    """Nothing but the known names beside dot-files and what .gitignore names."""
    ignored = tree.ignored_folders(root)
    return [f"{entry.name}: not a known top-level entry" for entry in sorted(root.iterdir())
            if entry.name not in TOP_LEVEL | ignored and not entry.name.startswith(".")]


def clang_format():
    for name in (f"clang-format-{CLANG_FORMAT_MAJOR}", "clang-format"):
        program = shutil.which(name)
        if program and f"version {CLANG_FORMAT_MAJOR}." in subprocess.run(
                [program, "--version"], capture_output=True, text=True, check=True).stdout:
            return program
    return None


def formatting(root):
    """Every C and C++ file is as clang-format would write it."""
    program = clang_format()
    if not program:
        return [f"clang-format {CLANG_FORMAT_MAJOR} is not installed"]
    sources = tree.files(root, tree.CPP_SUFFIXES, CODE_FOLDERS)
    if not sources:
        return ["no sources found"]
    run = subprocess.run([program, "--style=file", "--dry-run", "-Werror", "--ferror-limit=1", *map(str, sources)],
                         cwd=root, capture_output=True, text=True)
    complaints = [line for line in run.stderr.splitlines() if "error:" in line]
    return complaints if run.returncode == 0 or complaints else [run.stderr]
