#!/usr/bin/env bash
# Installs what is missing, builds, and measures Palpate beside its peers. Results go to one CSV; a full run also
# draws the figures in assets/bench. The last lines are the ratios.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source tests/support/packages.sh

usage() {
  cat <<'USAGE'
Usage: bash tests/bench/run.sh [--quick] [--long] [--only NAME]

  --quick       about a minute: fewer poses, scenes and sizes
  --long        also models of ten million triangles, which take some gigabytes
  --only NAME   one of kernels, build, pairs, growth, bodies
  --help        this text

  PALPATE_DATA   folder of the large meshes; their scenes are left out without it
  PALPATE_JOBS   compilers at a time (2)

Builds in build/bench; the CSV is build/bench/results.csv. Keep the machine quiet meanwhile.
USAGE
}

options=()
draw=1
while (($#)); do
  case "$1" in
    --quick) options+=(--quick); draw=0 ;;
    --long) options+=(--long) ;;
    --only) options+=(--only "${2:?--only needs a name}"); draw=0; shift ;;
    --help | -h) usage; exit 0 ;;
    *) echo "tests/bench/run.sh: unknown option $1" >&2; usage >&2; exit 2 ;;
  esac
  shift
done

python=/usr/bin/python3
install_missing "${palpate_build_packages[@]}" "${palpate_test_packages[@]}" "${palpate_bench_packages[@]}"
cmake --preset bench -DPython3_EXECUTABLE="$python" >/dev/null
cmake --build --preset bench -j "${PALPATE_JOBS:-2}" --target palpate-bench

csv=build/bench/results.csv
commit="$(git describe --always --dirty 2>/dev/null || echo unknown)"
build/bench/tests/bench/palpate-bench --out "$csv" --commit "$commit" "${options[@]}"
if ((draw)); then
  "$python" -B tests/bench/figures.py "$csv" assets/bench
fi
"$python" -B tests/bench/ratios.py "$csv"
