#!/usr/bin/env bash
# Installs what is missing, builds, runs every test, and runs them again under the address and undefined-behaviour
# sanitizers. Tests in other languages are counted for each runtime. The last line is the sum of what ctest ran in both:
# "N passed, N failed, N skipped".
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/packages.sh

usage() {
  cat <<'USAGE'
Usage: bash tests/run.sh [--quick] [-- CTEST_ARGUMENTS...]

  --quick   leave out the run under the sanitizers; so does PALPATE_QUICK=1
  --help    this text
  --        what follows goes to ctest, such as: -- -R snch

  PALPATE_DATA   folder of the large meshes; tests that need them are skipped without it
  PALPATE_JOBS   compilers and tests at a time (2)

Builds in build/release and build/asan-ubsan. Exit 0 if nothing failed.
USAGE
}

presets=(release asan-ubsan)
ctest_arguments=()
jobs="${PALPATE_JOBS:-2}"
[[ "${PALPATE_QUICK:-0}" != 1 ]] || presets=(release)
while (($#)); do
  case "$1" in
    --quick) presets=(release) ;;
    --help | -h) usage; exit 0 ;;
    --) shift; ctest_arguments=("$@"); break ;;
    *) echo "tests/run.sh: unknown option $1" >&2; usage >&2; exit 2 ;;
  esac
  shift
done

# The Python that the Debian packages belong to; another one may come first in PATH.
python=/usr/bin/python3

test_preset() {
  local preset="$1" report="build/$1/tests.xml"
  rm -f "$report"
  cmake --preset "$preset" -DPython3_EXECUTABLE="$python" &&
    cmake --build --preset "$preset" -j "$jobs" &&
    ctest --preset "$preset" -j "$jobs" --no-tests=error --test-output-size-passed 65536 \
      --output-junit "$PWD/$report" "${ctest_arguments[@]}"
}

if ! install_missing "${palpate_build_packages[@]}" "${palpate_viewer_packages[@]}" \
    "${palpate_test_packages[@]}"; then
  echo "0 passed, 1 failed, 0 skipped"
  exit 1
fi

status=0
reports=()
for preset in "${presets[@]}"; do
  echo "== $preset"
  reports+=("build/$preset/tests.xml")
  test_preset "$preset" || status=1
  "$python" -B tests/support/count_runtimes.py "build/$preset/tests.xml"
done

# A preset that did not get as far as a report counts as one failure.
read -r passed failed skipped < <("$python" -B tests/support/count_tests.py "${reports[@]}")
((failed == 0)) || status=1
echo "$passed passed, $failed failed, $skipped skipped"
exit "$status"
