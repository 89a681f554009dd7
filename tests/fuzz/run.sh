#!/usr/bin/env bash
# Fuzzes the C ABI with libFuzzer under the address and undefined-behaviour sanitizers. What it finds lies in
# build/fuzz/found; an input that broke something belongs into tests/fuzz/corpus once that is mended.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source tests/support/packages.sh

usage() {
  cat <<'USAGE'
Usage: bash tests/fuzz/run.sh [--minutes N] [TARGET...]

  --minutes N   for each target (30)
  --help        this text
  TARGET        of gltf, gltf_scene, triangles, calls, trace, hid: all without any

Prints each target's executions, coverage and findings. Exit 1 if anything was found.
USAGE
}

minutes=30
targets=()
while (($#)); do
  case "$1" in
    --minutes)
      minutes="${2:-}"
      [[ "$minutes" =~ ^[1-9][0-9]*$ ]] || { echo "tests/fuzz/run.sh: --minutes takes a whole number" >&2; exit 2; }
      shift
      ;;
    --help | -h) usage; exit 0 ;;
    gltf | gltf_scene | triangles | calls | trace | hid) targets+=("$1") ;;
    *) echo "tests/fuzz/run.sh: unknown argument $1" >&2; usage >&2; exit 2 ;;
  esac
  shift
done
((${#targets[@]})) || targets=(gltf gltf_scene triangles calls trace hid)

install_missing "${palpate_build_packages[@]}" "${palpate_test_packages[@]}" "${palpate_fuzz_packages[@]}"
cmake --preset fuzz -DPython3_EXECUTABLE=/usr/bin/python3
cmake --build --preset fuzz -j "${PALPATE_JOBS:-2}"

status=0
for target in "${targets[@]}"; do
  found="build/fuzz/found/$target"
  mkdir -p "$found" "build/fuzz/corpus/$target"
  options=(-max_total_time="$((60 * minutes))" -max_len=8192 -rss_limit_mb=4000 -timeout=30 -print_final_stats=1)
  seeds="${target%_scene}"
  [[ ! -f "tests/fuzz/$seeds.dict" ]] || options+=(-dict="tests/fuzz/$seeds.dict")
  echo "== $target: $minutes minutes"
  log="build/fuzz/$target.log"
  "build/fuzz/tests/fuzz/fuzz_$target" "${options[@]}" -artifact_prefix="$found/" \
    "build/fuzz/corpus/$target" "tests/fuzz/corpus/$seeds" >"$log" 2>&1 || status=1
  grep -E "^stat::number_of_executed_units|what\(\)|SUMMARY" "$log" || true
  grep -oE "cov: [0-9]+ ft: [0-9]+" "$log" | tail -1
  echo "$(find "$found" -type f | wc -l) inputs found that break something"
done
exit "$status"
