"""Makes the Unity package, unpacks it, compiles it as Unity would, assembly by assembly, and runs the tests."""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PLAIN = ROOT / "tests" / "csharp" / "plain"
GOLDEN = ROOT / "tests" / "golden"
sys.path += [str(ROOT / "tests" / "support"), str(GOLDEN)]

from commands import Failed, run  # noqa: E402  (its folder was not in the path before)
from vector_lines import vector_lines  # noqa: E402


def compile_sources(target, sources, references, *options):
    """With the oldest language version that Unity takes."""
    kind = "exe" if target.suffix == ".exe" else "library"
    run("mcs", "-langversion:7.2", "-warnaserror", f"-target:{kind}", f"-out:{target}",
        *[f"-r:{reference}" for reference in references], *options, *sources)
    return target


def compile_assembly(definition, folder, built):
    """The assembly of an .asmdef file: what lies beside it and below, but for what has an .asmdef of its own."""
    described = json.loads(definition.read_text())
    inner = [other.parent for other in definition.parent.rglob("*.asmdef") if other != definition]
    sources = [path for path in sorted(definition.parent.rglob("*.cs"))
               if not any(folder in path.parents for folder in inner)]
    references = [built[name] for name in described["references"]]
    if not described["noEngineReferences"]:
        references.append(built["UnityEngine"])
    options = ["-unsafe"] if described["allowUnsafeCode"] else []
    built[described["name"]] = compile_sources(folder / f"{described['name']}.dll", sources, references, *options)


def compile_package(package, folder):
    built = {"UnityEngine": compile_sources(folder / "UnityEngine.dll", sorted((HERE / "stub").glob("*.cs")), [])}
    for path in ("Runtime/Binding/Palpate.asmdef", "Runtime/Palpate.Haptics.asmdef", "Editor/Palpate.Haptics.Editor.asmdef"):
        compile_assembly(package / path, folder, built)
    sources = [*sorted((HERE / "src").glob("*.cs")), *sorted(PLAIN.glob("*.cs")), *sorted(GOLDEN.glob("*.cs")),
               *sorted((package / "Samples~").rglob("*.cs"))]
    return compile_sources(folder / "tests.exe", sources, built.values())


def unpack(library, folder):
    archive = folder / "package.tgz"
    run(sys.executable, "-B", ROOT / "bindings" / "unity" / "pack.py", library, archive)
    shutil.rmtree(folder / "package", ignore_errors=True)
    with tarfile.open(archive) as tar:
        tar.extractall(folder)
    return folder / "package"


def main():
    parser = argparse.ArgumentParser()
    for name in ("library", "models", "folder"):
        parser.add_argument(f"--{name}", type=lambda text: Path(text).resolve(), required=True)
    arguments = parser.parse_args()
    absent = [program for program in ("mcs", "mono", "patchelf") if not shutil.which(program)]
    if absent:
        print(f"Unity package under Mono: skipped: {absent[0]} is not installed")
        return 0
    arguments.folder.mkdir(parents=True, exist_ok=True)
    try:
        package = unpack(arguments.library, arguments.folder)
        program = compile_package(package, arguments.folder)
    except Failed as error:
        print(error)
        return 1
    vectors = arguments.folder / "vectors.txt"
    vectors.write_text(vector_lines())
    plugins = package / "Runtime" / "Plugins" / "x86_64"
    done = subprocess.run(["mono", program], text=True, stdout=subprocess.PIPE, env=dict(
        os.environ, LD_LIBRARY_PATH=str(plugins), PALPATE_TEST_MODELS=str(arguments.models),
        PALPATE_TEST_VECTORS=str(vectors)))
    # The runner's last line is its count.
    print(re.sub(r"^(?=\d+ passed, \d+ failed$)", "Unity package under Mono: ", done.stdout, flags=re.MULTILINE))
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
