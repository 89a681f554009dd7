"""check_readme.py CHECK --root ROOT --library FILE --models FOLDER: one check of README.md.

An example is a code block of one language followed by a block of text that shows what it prints."""

import argparse
import os
import re
import shutil
import sys
import tempfile
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "support"))

from commands import run  # noqa: E402  (its folder was not in the path before)

FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\[[^\]]*\]\(([^)#:]+)\)")
COMMANDS = ("bash samples/run.sh", "bash tests/run.sh")


def examples(readme, language):
    """Pairs of a program and what it is said to print."""
    blocks = FENCE.findall(readme)
    found = [(code, following) for (name, code), (following_name, following) in zip(blocks, blocks[1:])
             if name == language and following_name == "text"]
    assert found, f"README.md has no {language} example"
    return found


def expect_output(printed, said):
    assert printed == said, f"README.md says:\n{said}\nbut the example prints:\n{printed}"


def c(arguments, readme, folder):
    program = folder / "example"
    for code, said in examples(readme, "c"):
        (folder / "example.c").write_text(code)
        run("cc", "-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror", *arguments.compiler_flags.split(),
            folder / "example.c", "-o", program, "-I", arguments.root / "capi" / "include", arguments.library,
            f"-Wl,-rpath,{arguments.library.parent}")
        expect_output(run(program, cwd=arguments.models), said)


def python_environment(arguments):
    """Where the package and its library are; a sanitized library needs its run-time before Python's own start."""
    environment = dict(os.environ, PYTHONPATH=str(arguments.root / "bindings" / "python" / "src"),
                       PALPATE_LIBRARY=str(arguments.library))
    if "-fsanitize=address" in arguments.compiler_flags:
        runtime = run("cc", "-print-file-name=libasan.so").strip()
        # Python keeps what it allocates for modules until it ends: leaks are looked for in the tests of the C interface.
        environment.update(LD_PRELOAD=runtime, ASAN_OPTIONS="detect_leaks=0")
    return environment


def python(arguments, readme, folder):
    for code, said in examples(readme, "python"):
        (folder / "example.py").write_text(code)
        expect_output(run(sys.executable, "-B", folder / "example.py", cwd=arguments.models,
                          env=python_environment(arguments)), said)


def csharp(arguments, readme, folder):
    """From the installed sources and library, in a folder with nothing but the program and its models."""
    if not (shutil.which("mcs") and shutil.which("mono")):
        print("C# of README.md: skipped: mcs or mono is not installed")
        return
    binding = sorted((arguments.prefix / "share" / "palpate" / "csharp").glob("*.cs"))
    library, = arguments.prefix.glob("lib*/**/libpalpate.so")
    for code, said in examples(readme, "csharp"):
        (folder / "Example.cs").write_text(code)
        for model in re.findall(r"\w+\.glb", code):
            shutil.copy(arguments.models / model, folder)
        run("mcs", "-langversion:7.2", "-unsafe", "-warnaserror", "-out:example.exe", *binding, "Example.cs", cwd=folder)
        expect_output(run("mono", "example.exe", cwd=folder, env=dict(os.environ, LD_LIBRARY_PATH=str(library.parent))),
                      said)


def commands(arguments, readme, folder):
    """The two commands stand in the first block, and their scripts are there."""
    first = FENCE.search(readme).group(2)
    for command in COMMANDS:
        assert command in first, f"the first block of README.md lacks: {command}"
        run("bash", arguments.root / command.split()[1], "--help")


def links(arguments, readme, folder):
    targets = LINK.findall(readme)
    assert targets, "README.md has no links"
    missing = [target for target in targets if not (arguments.root / target).exists()]
    assert not missing, f"README.md links to what is not there: {missing}"


CHECKS = {check.__name__: check for check in (c, csharp, python, commands, links)}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("check", choices=CHECKS)
    parser.add_argument("--root", type=Path, required=True)
    parser.add_argument("--library", type=Path, required=True)
    parser.add_argument("--models", type=Path, required=True)
    parser.add_argument("--prefix", type=Path, help="of an installed Palpate")
    parser.add_argument("--compiler-flags", default="")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="palpate-readme-") as folder:
        CHECKS[arguments.check](arguments, (arguments.root / "README.md").read_text(), Path(folder))


if __name__ == "__main__":
    main()
