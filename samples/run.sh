#!/usr/bin/env bash
# Installs what is missing, builds library, tools and models, and shows a gear that a hand presses on a crankshaft.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/packages.sh

usage() {
  cat <<'USAGE'
Usage: bash samples/run.sh [--headless] [PALPATE_ARGUMENTS...]

Builds in build/samples. Without arguments it describes two models, a crankshaft and a gear, prints the local minimum
distances between them and the wrench on the gear, and opens the viewer on them; without a display, or with --headless,
the viewer writes a picture, a log of forces and graphs instead and says where.

With arguments it runs the command-line tool with them in the folder of the built models, such as:
  bash samples/run.sh query teapot_5600.glb torus.glb --pose 0.2 0 0 0 0 0 1 --cutoff 0.05
or the viewer, if the first one is `viewer`:
  bash samples/run.sh viewer helicopter_113k.glb l_bracket.glb --tool-scale 0.5 --up z
  bash samples/run.sh viewer --experiment spring-teapot

  --headless     open no window
  --help         this text; palpate's own: bash samples/run.sh query --help
  PALPATE_JOBS   compilers at a time (2)
USAGE
}

if [[ "${1:-}" == --help || "${1:-}" == -h ]]; then
  usage
  exit 0
fi
headless=0
[[ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]] || headless=1
if [[ "${1:-}" == --headless ]]; then
  headless=1
  shift
fi

# What it takes to build goes to the error output: the output is the tool's.
{
  install_missing "${palpate_build_packages[@]}" "${palpate_viewer_packages[@]}"
  cmake --preset samples
  cmake --build --preset samples -j "${PALPATE_JOBS:-2}"
} >&2

palpate="$PWD/build/samples/samples/cli/palpate"
viewer="$PWD/build/samples/samples/viewer/palpate-viewer"
shown="$PWD/build/samples/shown"
mkdir -p "$shown"
cd build/samples/assets

view() {
  if ((headless)); then
    "$viewer" --headless --screenshot "$shown/viewer.png" --log "$shown/ticks.csv" --graphs "$shown/graphs.svg" "$@"
  else
    "$viewer" "$@"
  fi
}

if [[ "${1:-}" == viewer ]]; then
  shift
  view "$@"
  exit
fi
if (($#)); then
  exec "$palpate" "$@"
fi

for model in crankshaft_45k.glb gear_6k.glb; do
  echo "== $model"
  "$palpate" info "$model"
done
echo "== the gear over two webs of the crankshaft; cutoff 3 mm, 1 % of the crankshaft's diagonal"
"$palpate" query crankshaft_45k.glb gear_6k.glb --pose -0.005 0.0703 -0.02 -0.5 0 0 0.866 --cutoff 0.003
echo "== a simulated hand slides the gear over the crankshaft"
view --experiment crankshaft-gear --mode certified --law smooth
