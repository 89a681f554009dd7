"""tidy.py BUILD [FOLDER...]: runs clang-tidy by .clang-tidy over what a build of clang compiles, or what of it is below
the folders. Prints the findings; exit 1 if there are any."""

import argparse
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from units import FOLDERS, units

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = "clang-tidy-14"


def look_at(unit, file):
    """What clang-tidy says of the unit, "" if nothing."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("".join(f'#include "{source}"\n' for source in unit.sources))
    # That a unit includes sources is no finding.
    command = [PROGRAM, "--quiet", f"--config-file={ROOT / '.clang-tidy'}", "--checks=-bugprone-suspicious-include",
               str(file), "--", *unit.flags]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.stdout if done.returncode == 0 or done.stdout else done.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path)
    parser.add_argument("folders", nargs="*", default=FOLDERS)
    arguments = parser.parse_args()
    chosen = units(ROOT, arguments.build, arguments.folders)
    if not chosen:
        return f"{arguments.build} compiles nothing of that"
    jobs = int(os.environ.get("PALPATE_JOBS", "2"))
    clean = True
    with ThreadPoolExecutor(jobs) as pool:
        files = [arguments.build / "analysis" / f"unit_{i}.cpp" for i in range(len(chosen))]
        for unit, said in zip(chosen, pool.map(look_at, chosen, files)):
            print(f"{unit.part}: {len(unit.sources)} files: {'findings' if said else 'clean'}", flush=True)
            print(said, end="", flush=True)
            clean = clean and not said
    return 0 if clean else 1


if __name__ == "__main__":
    sys.exit(main())
