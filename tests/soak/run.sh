#!/usr/bin/env bash
# Installs what is missing, builds, and steps scenes in contact for an hour on two cores. The last line says how many
# ticks there were, and whether memory stayed flat and every force is that of a fresh scene.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source tests/support/packages.sh

usage() {
  cat <<'USAGE'
Usage: bash tests/soak/run.sh [--minutes M] [--threads N] [--seed S]

  --minutes M   how long (60)
  --threads N   at once (2)
  --seed S      of the ways that tools go (1)
  --help        this text

  PALPATE_JOBS   compilers at a time (2)

Builds in build/release. Exit 0 if it passed.
USAGE
}

for argument in "$@"; do
  case "$argument" in
    --help | -h) usage; exit 0 ;;
  esac
done

install_missing "${palpate_build_packages[@]}" "${palpate_test_packages[@]}"
cmake --preset release -DPython3_EXECUTABLE=/usr/bin/python3 >/dev/null
cmake --build --preset release -j "${PALPATE_JOBS:-2}" --target palpate-soak
exec build/release/tests/soak/palpate-soak "$@"
