#!/usr/bin/env bash
# Installs what is missing, builds, and runs shapes and poses at which numbers fail for as long as it is told. The last
# lines are tables: of every family, of FCL beside Palpate, and of simulated hands.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source tests/support/packages.sh

usage() {
  cat <<'USAGE'
Usage: bash tests/stress/run.sh [--minutes M] [--seed S] [--only TEXT] [--case N]

  --minutes M   all together (50)
  --seed S      a whole number that names the run (1)
  --only TEXT   the families and scenes whose name holds it
  --case N      the one case of each family whose number is N, as faults tell it
  --help        this text

  PALPATE_JOBS   compilers and threads at a time (2)

Builds in build/release; the tables are in build/release/stress.md, too. Exit 1 if anything was wrong.
USAGE
}

minutes=50
options=()
while (($#)); do
  case "$1" in
    --minutes)
      minutes="${2:-}"
      [[ "$minutes" =~ ^[1-9][0-9]*$ ]] || { echo "tests/stress/run.sh: --minutes takes a whole number" >&2; exit 2; }
      shift
      ;;
    --seed | --only | --case) options+=("$1" "${2:?$1 needs a value}"); shift ;;
    --help | -h) usage; exit 0 ;;
    *) echo "tests/stress/run.sh: unknown option $1" >&2; usage >&2; exit 2 ;;
  esac
  shift
done

jobs="${PALPATE_JOBS:-2}"
install_missing "${palpate_build_packages[@]}" "${palpate_test_packages[@]}" "${palpate_stress_packages[@]}"
cmake --preset release -DPython3_EXECUTABLE=/usr/bin/python3 >/dev/null
cmake --build --preset release -j "$jobs" --target palpate-stress
build/release/tests/stress/palpate-stress --minutes "$minutes" --jobs "$jobs" --out build/release/stress.md "${options[@]}"
