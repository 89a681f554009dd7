"""baseline.py check|renew: compares the interface of a build with its baseline, or writes the baseline anew.

Both refuse what breaks programs that were built with the baseline; `check` refuses additions, too, until the baseline
has them."""

import argparse
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings" / "gen"))

import compatibility  # noqa: E402
import description  # noqa: E402
import header  # noqa: E402

BASELINE = ROOT / "capi" / "baseline" / "interface.txt"
RELEASE = re.compile(r"^## \[(\d+\.\d+)\.\d+\]", re.MULTILINE)
RENEW = "cmake --build --preset release --target renew_abi_baseline"


def released_versions(changelog):
    """The symbol versions of the releases that the changelog lists."""
    return {f"PALPATE_{version}" for version in RELEASE.findall(changelog)}


def described(arguments):
    interface = header.parse((ROOT / "capi/include/palpate/palpate.h").read_text())
    structs = (ROOT / "capi/src/structs.h").read_text()
    return description.describe(interface, arguments.layout, arguments.library, structs)


def check(old, new, broken):
    if broken:
        return "\n".join([*broken, "This breaks programs that were built before: see capi/ABI.md."])
    added = compatibility.additions(old, new)
    if added or old != new:
        return "\n".join([*added, f"If this is meant, renew the baseline: {RENEW}"])
    return 0


def renew(new, broken):
    if broken:
        return "\n".join([*broken, "The baseline stays: this takes another soname, see capi/ABI.md."])
    BASELINE.write_text(description.render(new))
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("action", choices=("check", "renew"))
    parser.add_argument("--layout", type=Path, required=True, help="test_abi_layout of the build")
    parser.add_argument("--library", type=Path, required=True)
    arguments = parser.parse_args()
    new = described(arguments)
    old = description.parse(BASELINE.read_text()) if BASELINE.exists() else new
    broken = compatibility.breaks(old, new, released_versions((ROOT / "CHANGELOG.md").read_text()))
    return check(old, new, broken) if arguments.action == "check" else renew(new, broken)


if __name__ == "__main__":
    sys.exit(main())
