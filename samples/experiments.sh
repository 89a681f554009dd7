#!/usr/bin/env bash
# Runs the experiments of [JW04] as the viewer has them, without a window, and draws their graphs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/packages.sh

usage() {
  cat <<'USAGE'
Usage: bash samples/experiments.sh [FOLDER] [VIEWER_ARGUMENTS...]

Builds in build/samples and writes NAME.svg and NAME.csv of each experiment to FOLDER (build/samples/experiments). A
simulated hand moves one model over the other for eight seconds, eight times: a tick's times are the least. Further
arguments go to the viewer, such as --mode certified --law smooth; without them it is local descent and the law of
springs. The horse and the bunny are run if PALPATE_DATA names their folder, the organic bodies in any case.
USAGE
}

if [[ "${1:-}" == --help || "${1:-}" == -h ]]; then
  usage
  exit 0
fi
folder="${1:-build/samples/experiments}"
(($# == 0)) || shift

{
  install_missing "${palpate_build_packages[@]}" "${palpate_viewer_packages[@]}"
  cmake --preset samples
  cmake --build --preset samples -j "${PALPATE_JOBS:-2}"
} >&2

experiments=(crankshaft-gear spring-teapot organic helicopter)
[[ -z "${PALPATE_DATA:-}" ]] || experiments+=(horse-bunny)
mkdir -p "$folder"
for experiment in "${experiments[@]}"; do
  echo "== $experiment"
  build/samples/samples/viewer/palpate-viewer --headless --experiment "$experiment" --frames 500 --runs 8 \
    --graphs "$folder/$experiment.svg" --log "$folder/$experiment.csv" "$@"
done
