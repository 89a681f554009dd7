#!/usr/bin/env bash
# Looks at the source without running the tests: clang with warnings as errors, clang-tidy by .clang-tidy, cppcheck, and
# some tests of the C interface under valgrind. The last line is what was found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source tests/support/packages.sh

usage() {
  cat <<'USAGE'
Usage: bash tests/analysis/run.sh [clang] [tidy] [cppcheck] [valgrind]

  Without a name all four, which takes a quarter of an hour on two processors.

  PALPATE_JOBS   compilers and analyses at a time (2)

Builds in build/clang, and in build/release for valgrind. Exit 0 if nothing was found.
USAGE
}

python=/usr/bin/python3
export PALPATE_JOBS="${PALPATE_JOBS:-2}"
# Those that need no thread of their own and no large model: what valgrind slows down by fifty.
valgrind_tests='Misuse.*:DeviceMisuse.*:Triangles.*:LogTest.*:MaterialTest.*:QueryTest.*'

clang() {
  cmake --build --preset clang -j "$PALPATE_JOBS"
}

tidy() {
  "$python" -B tests/analysis/tidy.py build/clang
}

cppcheck_sources() {
  mkdir -p build/clang/cppcheck
  cppcheck --quiet --enable=warning,performance,portability --std=c++20 --language=c++ --error-exitcode=1 \
    -j "$PALPATE_JOBS" -I . -I capi/include --cppcheck-build-dir=build/clang/cppcheck \
    --suppressions-list=tests/analysis/cppcheck.txt engine capi/src assets samples
}

valgrind_subset() {
  cmake --preset release -DPython3_EXECUTABLE="$python"
  cmake --build --preset release -j "$PALPATE_JOBS" --target test_capi
  valgrind --quiet --error-exitcode=1 --leak-check=full --errors-for-leak-kinds=definite \
    build/release/tests/capi/test_capi --gtest_filter="$valgrind_tests" --gtest_brief=1
}

steps=()
for name in "$@"; do
  case "$name" in
    clang | tidy) steps+=("$name") ;;
    cppcheck) steps+=(cppcheck_sources) ;;
    valgrind) steps+=(valgrind_subset) ;;
    --help | -h) usage; exit 0 ;;
    *) echo "tests/analysis/run.sh: unknown argument $name" >&2; usage >&2; exit 2 ;;
  esac
done
((${#steps[@]})) || steps=(clang tidy cppcheck_sources valgrind_subset)

install_missing "${palpate_build_packages[@]}" "${palpate_viewer_packages[@]}" "${palpate_test_packages[@]}" \
  "${palpate_fuzz_packages[@]}" "${palpate_analysis_packages[@]}"
cmake --preset clang -DPython3_EXECUTABLE="$python"

found=()
for step in "${steps[@]}"; do
  echo "== $step"
  "$step" || found+=("$step")
done
echo "findings in: ${found[*]:-none}"
((${#found[@]} == 0))
