"""newer_header.py FILE: palpate.h as a later version may have it: every struct that may grow is longer."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings" / "gen"))
sys.path.insert(0, str(ROOT / "tests" / "abi"))

import description  # noqa: E402

TAIL = "  uint64_t later;\n  double later_still[5];\n"


def growing(baseline):
    return [about[1] for about, says in baseline.items() if about[0] == "struct" and " grows " in says]


def lengthen(header, names):
    for name in names:
        header, count = re.subn(rf"^}} {name};", f"{TAIL}}} {name};", header, flags=re.MULTILINE)
        if count != 1:
            raise ValueError(f"{name} is not in the header")
    return header


if __name__ == "__main__":
    baseline = description.parse((ROOT / "capi/baseline/interface.txt").read_text())
    Path(sys.argv[1]).write_text(
        lengthen((ROOT / "capi/include/palpate/palpate.h").read_text(), growing(baseline)))
