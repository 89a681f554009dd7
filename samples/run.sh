#!/usr/bin/env bash
# Installs what is missing, builds library, tool and models, and finds every contact between a crankshaft and a gear.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/packages.sh

usage() {
  cat <<'USAGE'
Usage: bash samples/run.sh [PALPATE_ARGUMENTS...]

Builds in build/samples. Without arguments it describes two models, a crankshaft and a gear, and prints the local
minimum distances between them and the wrench on the gear. With arguments it runs the tool with them in the folder of
the built models, such as: bash samples/run.sh query teapot_5600.glb torus.glb --pose 0.2 0 0 0 0 0 1 --cutoff 0.05

  --help         this text; palpate's own: bash samples/run.sh query --help
  PALPATE_JOBS   compilers at a time (2)
USAGE
}

if [[ "${1:-}" == --help || "${1:-}" == -h ]]; then
  usage
  exit 0
fi

# What it takes to build goes to the error output: the output is the tool's.
{
  install_missing "${palpate_build_packages[@]}"
  cmake --preset samples
  cmake --build --preset samples -j "${PALPATE_JOBS:-2}"
} >&2

palpate="$PWD/build/samples/samples/cli/palpate"
cd build/samples/assets
if (($#)); then
  exec "$palpate" "$@"
fi

for model in crankshaft_45k.glb gear_6k.glb; do
  echo "== $model"
  "$palpate" info "$model"
done
echo "== the gear over two webs of the crankshaft; cutoff 3 mm, 1 % of the crankshaft's diagonal"
"$palpate" query crankshaft_45k.glb gear_6k.glb --pose -0.005 0.0703 -0.02 -0.5 0 0 0.866 --cutoff 0.003
