#!/usr/bin/env bash
# Which Debian packages Replan needs, and how they get installed. Sourced by ./run and ./test; by hand:
#   scripts/packages.sh [build|test|web|all]          install what is missing
#   scripts/packages.sh [build|test|web|all] --list   print the list
set -euo pipefail

# What builds and runs the program. Why each one is there stands in CONTRIBUTING.md.
build_packages=(
  g++ cmake ninja-build ccache pkg-config
  libimgui-dev libglfw3-dev libosmesa6-dev libgl-dev libgl1-mesa-dri
  # GLFW opens these by name when it starts, so no package pulls them in.
  libxcursor1 libxi6 libxinerama1 libxrandr2 libegl1 libgles2
  libstb-dev libjpeg62-turbo-dev zlib1g-dev nlohmann-json3-dev libyaml-cpp-dev libcli11-dev
  ffmpeg gnuplot-nox
  fonts-inter fonts-jetbrains-mono fonts-font-awesome fonts-wqy-microhei
)
# What the tests and benchmarks need on top.
test_packages=(libgtest-dev libbenchmark-dev xvfb xauth xdotool)
# What builds the page for browsers (scripts/web.sh); dpkg-dev unpacks the sources of libraries.
web_packages=(emscripten nodejs dpkg-dev ca-certificates)
# What its tests need on top.
web_test_packages=(chromium)
# What only ./test --all and ./test --fuzz need on top.
long_packages=(clang libclang-rt-dev slurm-wlm munge)

# Prints those of the given packages that are not installed, one a line.
missing_packages() {
  local installed
  installed=$(dpkg-query -W -f '${db:Status-Status} ${binary:Package}\n' "$@" 2>/dev/null |
    sed -n 's/^installed \([^:]*\).*/\1/p' || true)
  comm -23 <(printf '%s\n' "$@" | sort) <(sort <<<"$installed")
}

on_debian() {
  command -v dpkg-query >/dev/null && command -v apt-get >/dev/null
}

# Elsewhere the names differ; the libraries are the same.
say_libraries() {
  cat >&2 <<'TEXT'
This system is not Debian, so nothing was installed. If the build stops because something is missing, it needs:
  g++ 12 or clang 14 (or later), CMake 3.25, Ninja, pkg-config; ccache if you like
  Dear ImGui 1.86 as a library with a pkg-config file, GLFW 3.3, OSMesa (Mesa's off-screen OpenGL) and its headers
  stb (stb_image.h, stb_image_write.h, stb_truetype.h under stb/), nlohmann-json 3, yaml-cpp 0.7, libjpeg, zlib, CLI11 2
  the program ffmpeg, for films; the rest works without it; likewise gnuplot, for the diagrams of studies
  the fonts Inter, JetBrains Mono, Font Awesome 4.7 and WenQuanYi Micro Hei (without them it falls back, and says so)
  for the tests: GoogleTest, Google Benchmark, Xvfb, xdotool
TEXT
}

# Sets `as_root` to what makes apt-get run as root; fails if there is no way.
find_root() {
  as_root=()
  [[ $EUID -eq 0 ]] && return 0
  command -v sudo >/dev/null || return 1
  as_root=(sudo)
  # Only a person at a terminal can type a password.
  if [[ -t 0 && -t 2 ]]; then sudo -v; else sudo -n true 2>/dev/null; fi
}

# `env` carries the setting through sudo, which clears the environment.
apt_get() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 "$@"
}

# Installs what is missing of the given packages. On a system that is not Debian it does nothing: the build will
# say what it lacks, and `say_libraries` what to look for.
install_packages() {
  on_debian || return 0
  local missing as_root log
  mapfile -t missing < <(missing_packages "$@")
  [[ ${#missing[@]} -gt 0 ]] || return 0
  if ! find_root; then
    echo "Some packages are missing, and only an administrator can install them. Ask for:" >&2
    echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
    return 1
  fi
  echo "Installing what is missing: ${missing[*]}"
  log=$(mktemp)
  # A stale list of packages names files that are no longer on the server. Without a network the list that is
  # there may still do.
  apt_get update >"$log" 2>&1 || true
  if ! apt_get install -y --no-install-recommends "${missing[@]}" >>"$log" 2>&1 </dev/null; then
    cat "$log" >&2
    rm -f "$log"
    echo "apt-get could not install them; see above. By hand: apt-get install --no-install-recommends ${missing[*]}" >&2
    return 1
  fi
  rm -f "$log"
}

packages_main() {
  local packages=()
  case ${1:-build} in
    build) packages=("${build_packages[@]}") ;;
    test) packages=("${build_packages[@]}" "${test_packages[@]}") ;;
    web) packages=("${build_packages[@]}" "${web_packages[@]}") ;;
    all) packages=("${build_packages[@]}" "${test_packages[@]}" "${long_packages[@]}") ;;
    *) echo "usage: scripts/packages.sh [build|test|web|all] [--list]" >&2 && return 2 ;;
  esac
  if [[ ${2:-} == --list ]]; then
    printf '%s\n' "${packages[@]}"
  else
    on_debian || say_libraries
    install_packages "${packages[@]}"
  fi
}

if [[ ${BASH_SOURCE[0]} == "$0" ]]; then packages_main "$@"; fi
