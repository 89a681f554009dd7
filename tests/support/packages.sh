# The Debian 12 packages that Palpate needs, stated once; tests/run.sh, tests/bench/run.sh, tests/stress/run.sh and
# samples/run.sh source this file.

palpate_build_packages=(
  g++ cmake ninja-build
  libtinygltf-dev libglm-dev libembree-dev libhwy-dev libdraco-dev libmeshoptimizer-dev
  libcli11-dev nlohmann-json3-dev pkg-config libhidapi-dev
)
# The viewer, which is left out without them; Mesa draws where there is no graphics processor.
palpate_viewer_packages=(
  libglfw3-dev libimgui-dev libepoxy-dev libegl-dev libstb-dev pkg-config
  libgl1 libgl1-mesa-dri libegl-mesa0 fonts-dejavu-core
)
palpate_test_packages=(
  libgtest-dev clang-format-14 abigail-tools doxygen binutils make patchelf umockdev libumockdev-dev
  python3 python3-numpy python3-pip python3-setuptools python3-venv python3-wheel
  mypy python3-matplotlib python3-scipy
  mono-mcs mono-runtime mono-devel nunit-console libnunit-cil-dev
  godot3-server godot3-runner xvfb xauth xdotool python3-xlib libopenxr-dev
)
# Making packages that hold the library and all that it needs.
palpate_package_packages=(binutils patchelf python3)
palpate_fuzz_packages=(clang-14 libclang-rt-14-dev)
palpate_analysis_packages=(clang-tidy-14 cppcheck valgrind)
palpate_bench_packages=(libfcl-dev libbullet-dev)
palpate_stress_packages=(libfcl-dev)

missing_packages() {
  local package
  for package in "$@"; do
    [[ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" == installed ]] || echo "$package"
  done
}

# Installs those of the named packages that are not installed. Without any to install, apt is not touched.
install_missing() {
  local -a missing as_root=()
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "These packages are missing; install them as root: apt-get install ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}"
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}
