#!/usr/bin/env bash
# Installs what is missing, builds the library, the plug-in and the models, and opens the sample in Godot 3.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source tests/support/packages.sh

usage() {
  cat <<'USAGE'
Usage: bash samples/godot/run.sh [ARGUMENTS...]

Makes the project build/godot, in which a gear slides over a crankshaft, and runs it. The arguments are the sample's:

  --frames=N         end after N frames, and tell the forces of each
  --screenshot=FILE  save the last one
  --help             this text
  PALPATE_JOBS       compilers at a time (2)
USAGE
}

if [[ "${1:-}" == --help || "${1:-}" == -h ]]; then
  usage
  exit 0
fi
{
  install_missing "${palpate_build_packages[@]}" "${palpate_package_packages[@]}" godot3-runner
  cmake --preset samples
  cmake --build --preset samples -j "${PALPATE_JOBS:-2}" --target palpate_godot assets
  mkdir -p build/godot
  cp samples/godot/*.gd samples/godot/*.tscn samples/godot/project.godot build/godot
  /usr/bin/python3 -B bindings/godot/pack.py build/samples/bindings/godot/libpalpate_godot.so build/godot
} >&2
exec godot3-runner --path build/godot --models="$PWD/build/samples/assets" "$@"
