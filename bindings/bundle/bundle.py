#!/usr/bin/env python3
"""bundle.py LIBRARY FOLDER: copies the library and all that it needs beyond the C and C++ run-times into one folder, so
that it runs where Debian's packages are not installed. Each copy looks for the others beside itself.

Every copy's name ends in .so, because engines take no other for a plug-in."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

# What every Linux has, in a version at least that of the machine this runs on.
SYSTEM = re.compile(r"(linux-vdso|ld-linux-x86-64|libc|libm|libdl|libpthread|librt|libstdc\+\+|libgcc_s)\.so[.\d]*$")
NEEDED = re.compile(r"^\s*(\S+) => (\S+) \(0x[0-9a-f]+\)$", re.MULTILINE)


class BundleError(Exception):
    """The library cannot be bundled."""


def output_of(*command):
    try:
        return subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True).stdout
    except FileNotFoundError:
        raise BundleError(f"{command[0]} is not installed") from None
    except subprocess.CalledProcessError as error:
        raise BundleError(f"{' '.join(map(str, command))}: {error.stderr.strip()}") from None


def dependencies(library):
    """The path of everything that it needs and a system may lack, by the name that it is asked for."""
    listed = output_of("ldd", library)
    absent = re.findall(r"^\s*(\S+) => not found$", listed, re.MULTILINE)
    if absent:
        raise BundleError(f"{library} needs {', '.join(absent)}, which is not installed")
    return {name: Path(path).resolve() for name, path in NEEDED.findall(listed) if not SYSTEM.match(name)}


def plain_name(name):
    """libembree3.so for libembree3.so.3."""
    return name[:name.index(".so")] + ".so"


def bundle(library, folder):
    """Returns the paths of the originals, the library's own first."""
    library, folder = Path(library).resolve(), Path(folder)
    needed = dependencies(library)
    names = [plain_name(library.name)] + [plain_name(name) for name in needed]
    if len(set(names)) != len(names):
        raise BundleError(f"two of {', '.join(sorted(names))} have one name")
    folder.mkdir(parents=True, exist_ok=True)
    for original, name in zip([library, *needed.values()], names):
        copy = folder / name
        shutil.copyfile(original, copy)
        copy.chmod(0o755)
        output_of("strip", "--strip-unneeded", copy)
        # One change at a time: patchelf mixes up the values of several.
        output_of("patchelf", "--set-soname", name, copy)
        asked_for = output_of("patchelf", "--print-needed", copy).split()
        for other in filter(needed.__contains__, asked_for):
            output_of("patchelf", "--replace-needed", other, plain_name(other), copy)
        output_of("patchelf", "--set-rpath", "$ORIGIN", copy)
    return [library, *needed.values()]


def notices(originals):
    """The licences of what is not this project's own, under the names of their Debian packages, as Markdown."""
    texts = {}
    for original in originals[1:]:
        owner = output_of("dpkg", "-S", original).split(":")[0]
        texts[owner] = Path("/usr/share/doc", owner, "copyright").read_text()
    return "\n".join(f"# {name}\n\n```text\n{text}```\n" for name, text in sorted(texts.items()))


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        for original in bundle(*sys.argv[1:]):
            print(original)
    except BundleError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
