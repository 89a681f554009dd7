"""check_install.py CHECK --prefix PREFIX --models FOLDER [--compiler-flags FLAGS]: one check of an installed Palpate."""

import argparse
import json
import math
import os
import re
import subprocess
import tempfile
from pathlib import Path

CONSUMER = Path(__file__).parent / "consumer"
# A pose at which several places of the two models are within the cutoff.
MODELS = ("crankshaft_45k.glb", "gear_6k.glb")
OFFSET = ("-0.01", "0.098", "0.02")
CUTOFF = "0.01"
RELATIVE_TOLERANCE = 1e-12


class Installed:
    """The parts of an installed tree."""

    def __init__(self, prefix):
        self.prefix = prefix
        self.library = next(prefix.glob("lib*/**/libpalpate.so"))
        self.tool = prefix / "bin" / "palpate"
        self.viewer = prefix / "bin" / "palpate-viewer"
        self.include = prefix / "include"
        self.header = self.include / "palpate" / "palpate.h"
        self.environment = dict(os.environ, LD_LIBRARY_PATH=str(self.library.parent),
                                PKG_CONFIG_PATH=str(self.library.parent / "pkgconfig"))


def run(command, **options):
    """The standard output; an error with both outputs if the command fails."""
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **options)
    if done.returncode:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def agree(left, right):
    scale = max(map(abs, left + right))
    return all(abs(x - y) <= RELATIVE_TOLERANCE * scale for x, y in zip(left, right, strict=True))


def expect_same_contacts(installed, models, program):
    """The program finds what the installed tool finds, and that is something."""
    pair = [models / name for name in MODELS]
    found = json.loads(run([program, *pair, *OFFSET, CUTOFF], env=installed.environment))
    # The tool must find the library by itself, hence without the changed environment.
    told = json.loads(run([installed.tool, "query", *pair, "--pose", *OFFSET, "0", "0", "0", "1",
                           "--cutoff", CUTOFF, "--json"]))
    assert found["points"] == len(told["lmds"]) > 0, (found, told)
    assert found["sets"] == 1 + max(lmd["set"] for lmd in told["lmds"]) > 1, (found, told)
    for part in ("force", "torque"):
        assert all(map(math.isfinite, found[part])) and any(found[part]), found
        assert agree(found[part], told["wrench"][part]), (found, told)


def find_package(installed, arguments, folder):
    run(["cmake", "-S", CONSUMER, "-B", folder, f"-DCMAKE_PREFIX_PATH={installed.prefix}",
         f"-DCMAKE_C_FLAGS={arguments.compiler_flags}"])
    run(["cmake", "--build", folder])
    expect_same_contacts(installed, arguments.models, folder / "consumer")


def pkg_config(installed, arguments, folder):
    flags = run(["pkg-config", "--cflags", "--libs", "palpate"], env=installed.environment).split()
    program = folder / "consumer"
    run(["cc", "-std=c99", *arguments.compiler_flags.split(), CONSUMER / "main.c", "-o", program, *flags])
    expect_same_contacts(installed, arguments.models, program)


def viewer(installed, arguments, folder):
    """Without a display; what it logs is what the tool finds on the same pose. Skipped where it was not built."""
    if not installed.viewer.exists():
        return print("skipped: the viewer was not built")
    pair, pose = [arguments.models / name for name in MODELS], [*OFFSET, "0", "0", "0", "1"]
    poses, picture, log = folder / "poses.csv", folder / "picture.png", folder / "ticks.csv"
    poses.write_text("t,px,py,pz,qx,qy,qz,qw\n" + ",".join(["0", *pose]) + "\n")
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    environment["ASAN_OPTIONS"] = "detect_leaks=0"  # what Mesa keeps until the process ends
    run([installed.viewer, "--headless", *pair, "--replay", poses, "--cutoff", CUTOFF, "--stiffness", "1000", "--law",
         "springs", "--screenshot", picture, "--log", log], env=environment)
    assert picture.read_bytes().startswith(b"\x89PNG"), picture
    names, numbers = (line.split(",") for line in log.read_text().splitlines())
    tick = dict(zip(names, map(float, numbers)))
    told = json.loads(run([installed.tool, "query", *pair, "--pose", *pose, "--cutoff", CUTOFF, "--stiffness", "1000",
                           "--json"]))
    assert tick["lmds"] == 1 + max(lmd["set"] for lmd in told["lmds"]) > 1, (tick, told)
    assert any(tick[axis] for axis in ("fx", "fy", "fz")), tick


def soname(installed, arguments, folder):
    dynamic = run(["readelf", "--dynamic", "--wide", installed.library])
    names = re.findall(r"\(SONAME\).*\[(.*)\]", dynamic)
    assert names == ["libpalpate.so.0"], names
    assert (installed.library.parent / names[0]).resolve() == installed.library.resolve()


def exported_symbols(installed, arguments, folder):
    """What the header declares is what the library exports."""
    table = run(["nm", "--dynamic", "--defined-only", "--format=posix", installed.library])
    kinds = dict(line.split()[:2] for line in table.splitlines())
    exported = {name.split("@")[0] for name, kind in kinds.items() if kind != "A"}
    declared = set(re.findall(r"^PLP_API [^(]*?\b(plp_\w+)\(", installed.header.read_text(), re.MULTILINE))
    assert exported == declared and declared, (exported - declared, declared - exported)


def compile_header(installed, folder, compiler, standard, suffix):
    source = folder / f"include{suffix}"
    source.write_text("#include <palpate/palpate.h>\nint main(void) { return plp_version() == 0; }\n")
    run([compiler, f"-std={standard}", "-Wall", "-Wextra", "-pedantic", "-Werror", f"-I{installed.include}",
         "-fsyntax-only", source])


def header_c99(installed, arguments, folder):
    compile_header(installed, folder, "cc", "c99", ".c")


def header_cxx17(installed, arguments, folder):
    compile_header(installed, folder, "c++", "c++17", ".cpp")


CHECKS = (find_package, pkg_config, viewer, soname, exported_symbols, header_c99, header_cxx17)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("check", choices=[check.__name__ for check in CHECKS])
    parser.add_argument("--prefix", type=Path, required=True)
    parser.add_argument("--models", type=Path, required=True)
    parser.add_argument("--compiler-flags", default="")
    arguments = parser.parse_args()
    check = next(check for check in CHECKS if check.__name__ == arguments.check)
    # The consumers are built away from the tree, so that nothing of it is found by accident.
    with tempfile.TemporaryDirectory(prefix="palpate-install-") as folder:
        check(Installed(arguments.prefix), arguments, Path(folder))


if __name__ == "__main__":
    main()
