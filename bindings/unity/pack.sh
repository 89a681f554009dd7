#!/usr/bin/env bash
# Builds the library and makes build/com.palpate.haptics-VERSION.tgz, which Unity's package manager installs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source tests/support/packages.sh
install_missing "${palpate_build_packages[@]}" "${palpate_package_packages[@]}"
python=/usr/bin/python3
version="$("$python" -c 'import json; print(json.load(open("bindings/unity/package.json"))["version"])')"
cmake --preset release
cmake --build --preset release --target palpate
"$python" -B bindings/unity/pack.py build/release/capi/libpalpate.so "build/com.palpate.haptics-$version.tgz"
