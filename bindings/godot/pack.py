#!/usr/bin/env python3
"""pack.py PLUGIN FOLDER: makes FOLDER/addons/palpate, which a project of Godot 3 takes as it is: the plug-in and all
that it needs beside it."""

import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE.parent / "bundle"))

import bundle  # noqa: E402  (its folder was not in the path before)


def pack(plugin, folder):
    """Returns the folder of the add-on."""
    addon = Path(folder, "addons", "palpate")
    shutil.rmtree(addon, ignore_errors=True)
    addon.mkdir(parents=True)
    for path in (HERE / "addon").iterdir():
        shutil.copyfile(path, addon / path.name)
    shutil.copyfile(HERE / "README.md", addon / "README.md")
    shutil.copyfile(ROOT / "LICENSE", addon / "LICENSE.md")
    originals = bundle.bundle(plugin, addon)
    others = [path for path in originals if not path.name.startswith("libpalpate.so")]
    (addon / "Third Party Notices.md").write_text(bundle.notices(others))
    return addon


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        print(pack(*sys.argv[1:]))
    except (bundle.BundleError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
