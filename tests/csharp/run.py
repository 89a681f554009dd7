"""run.py RUNTIME: compiles the C# binding and its tests, runs them under one runtime, and prints the count.

Under Mono NUnit's own runner runs them. Ahead of time and under CoreCLR the same tests run with a small one."""

import argparse
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BINDING = ROOT / "bindings" / "csharp" / "src"
GOLDEN = ROOT / "tests" / "golden"
sys.path += [str(ROOT / "tests" / "support"), str(GOLDEN)]

from commands import Failed, run  # noqa: E402  (its folder was not in the path before)
from pip_environment import Unavailable, pip_environment  # noqa: E402
from vector_lines import vector_lines  # noqa: E402

COUNT = re.compile(r"^(\d+) passed, (\d+) failed$", re.MULTILINE)
# Compiled in earnest from the first call on, so that times mean something.
RUNTIME_CONFIG = """{"runtimeOptions": {"tfm": "netcoreapp3.1",
  "framework": {"name": "Microsoft.NETCore.App", "version": "3.1.0"},
  "configProperties": {"System.Runtime.TieredCompilation": false}}}
"""
# What the sources need of CoreCLR's class library.
CORE_ASSEMBLIES = ("System.Private.CoreLib", "System.Runtime", "System.Runtime.Extensions", "System.Console",
                   "System.Collections", "System.IO.FileSystem")
# Debian has no CoreCLR; this wheel is one without a compiler.
CORE_PACKAGE = "dotnetcore2==3.1.23"


class Missing(Exception):
    """A runtime, or what it needs, is not there."""


def require(*programs):
    for program in programs:
        if not shutil.which(program):
            raise Missing(f"{program} is not installed")


def compile_sources(target, sources, *options):
    """C# 7.2, as the oldest host compiles it."""
    require("mcs")
    run("mcs", "-langversion:7.2", "-unsafe", "-warnaserror", f"-out:{target}", *options, *sources)
    return target


def sources(*folders):
    return [path for folder in folders for path in sorted(folder.glob("*.cs"))]


def compile_binding(folder, *options):
    """With its documentation, so that a comment that is not well-formed is an error."""
    return compile_sources(folder / "Palpate.dll", sources(BINDING), "-target:library", f"-doc:{folder / 'Palpate.xml'}",
                           "-nowarn:1573,1591", *options)


def compile_all(folder, *options):
    """The binding, and the tests as a program that runs them."""
    binding = compile_binding(folder, *options)
    return compile_sources(folder / "tests.exe", sources(HERE / "src", HERE / "plain", GOLDEN), f"-r:{binding}", *options)


def environment(arguments, **changes):
    """What the tests are given."""
    layout, reference, vectors = (arguments.folder / name for name in ("layout.txt", "reference.bin", "vectors.txt"))
    layout.write_text(run(arguments.layout))
    vectors.write_text(vector_lines())
    run(arguments.reference, arguments.models, reference)
    return dict(os.environ, LD_LIBRARY_PATH=str(arguments.library.parent), PALPATE_TEST_LAYOUT=str(layout),
                PALPATE_TEST_REFERENCE=str(reference), PALPATE_TEST_MODELS=str(arguments.models),
                PALPATE_TEST_VECTORS=str(vectors), **changes)


def run_plain(arguments, *command, **changes):
    """The number of tests that passed and that failed, and what was printed."""
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True,
                          env=environment(arguments, **changes))
    counts = COUNT.findall(done.stdout)
    if not counts or (done.returncode != 0) != (counts[-1][1] != "0"):
        raise Failed(f"exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return *map(int, counts[-1]), COUNT.sub("", done.stdout)


def mono(arguments):
    require("mono", "nunit-console")
    binding = compile_binding(arguments.folder)
    tests = compile_sources(arguments.folder / "tests.dll", sources(HERE / "src", HERE / "domains", GOLDEN), "-target:library",
                            f"-r:{binding}", "-pkg:nunit")
    report = arguments.folder / "report.xml"
    report.unlink(missing_ok=True)
    command = ["nunit-console", "-nologo", "-nodots", "-noshadow", "-domain:None", f"-result:{report}", tests]
    done = subprocess.run(command, capture_output=True, text=True, env=environment(arguments), cwd=arguments.folder)
    if not report.exists():
        raise Failed(done.stdout + done.stderr)
    cases = [case.get("result") for case in ElementTree.parse(report).getroot().iter("test-case")]
    passed = cases.count("Success")
    failed = len(cases) - passed
    if (done.returncode != 0) != (failed != 0):
        raise Failed(f"exit code {done.returncode}\n{done.stdout}{done.stderr}")
    timed = [line for line in done.stdout.splitlines() if line.startswith("ns: ")]
    return passed, failed, done.stdout + done.stderr if failed else "\n".join(timed)


def core_folder(arguments):
    """Of the runtime."""
    try:
        python = pip_environment(arguments.folder / "env", [CORE_PACKAGE], pip_options=["--no-deps"])
    except Unavailable as error:
        raise Missing(str(error)) from None
    folder, = python.parents[1].glob("lib/python3*/site-packages/dotnetcore2/bin")
    return folder


def coreclr(arguments):
    runtime = core_folder(arguments)
    framework, = runtime.glob("shared/Microsoft.NETCore.App/3.1.*")
    references = [f"-r:{framework / name}.dll" for name in CORE_ASSEMBLIES]
    program = compile_all(arguments.folder, "-nostdlib", "-noconfig", *references)
    config = arguments.folder / "tests.runtimeconfig.json"
    config.write_text(RUNTIME_CONFIG)
    return run_plain(arguments, runtime / "dotnet", "exec", "--runtimeconfig", config, program,
                     DOTNET_SYSTEM_GLOBALIZATION_INVARIANT="1")


def class_library(folder):
    """Mono's own, compiled ahead of time beside a copy of it; that is kept until Mono changes."""
    installed = Path("/usr/lib/mono/4.5/mscorlib.dll")
    if not installed.exists():
        raise Missing(f"{installed} is not there")
    copy = folder / installed.name
    compiled = folder / f"{installed.name}.so"
    if not (compiled.exists() and copy.read_bytes() == installed.read_bytes()):
        shutil.copy(installed, copy)
        compile_ahead(copy)


def compile_ahead(assembly):
    run("mono", "--aot=full", assembly.name, cwd=assembly.parent, env=dict(os.environ, MONO_PATH=str(assembly.parent)))


def full_aot(arguments):
    """Nothing is compiled at run time, as on Unity's IL2CPP."""
    require("mono", "as", "ld")
    class_library(arguments.folder)
    program = compile_all(arguments.folder)
    for assembly in (arguments.folder / "Palpate.dll", program):
        compile_ahead(assembly)
    return run_plain(arguments, "mono", "--full-aot", program, MONO_PATH=str(arguments.folder))


RUNTIMES = {"mono": (mono, "Mono with NUnit"), "coreclr": (coreclr, "CoreCLR"),
            "full_aot": (full_aot, "Mono ahead of time")}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("runtime", choices=RUNTIMES)
    for name in ("library", "layout", "reference", "models", "folder"):
        parser.add_argument(f"--{name}", type=lambda text: Path(text).resolve(), required=True)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    run_tests, title = RUNTIMES[arguments.runtime]
    try:
        passed, failed, printed = run_tests(arguments)
    except Missing as missing:
        print(f"C# under {title}: skipped: {missing}")
        return 0
    except Failed as error:
        print(error)
        return 1
    print(f"C# under {title}: {passed} passed, {failed} failed")
    print(printed.strip())
    return 0 if passed and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
