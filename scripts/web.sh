#!/usr/bin/env bash
# Builds Replan as a page for browsers:
#   scripts/web.sh              build/web/replan.html, one file, and build/web/site/, a folder for any static server
#   scripts/web.sh --test       the same, then its tests in a headless Chromium; needs the tests of build/release (./test)
# What is missing gets installed first (Debian, as root or by sudo): emscripten, and the sources of Dear ImGui, yaml-cpp,
# libjpeg-turbo and zlib as Debian has them, which are fetched into build/web and compiled there.
set -euo pipefail

cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh
# shellcheck source=scripts/build.sh
source scripts/build.sh

web=$PWD/build/web
prefix=$web/prefix # what a cross build finds in the place of /usr
sources=(imgui yaml-cpp libjpeg-turbo zlib)
# Debian's emscripten looks for its modules in Debian's own places, also where another Node.js is installed.
export NODE_PATH=/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}
toolchain=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake
# Exceptions as the machine's own: a tenth of the price of those by JavaScript. To be given to all that is linked.
flags=-fwasm-exceptions

# Debian's sources of those packages, at the version that the system's packages have; by a list of sources of our own, so
# that the system's lists stay as they are.
fetch_sources() {
  local apt=$web/apt suite options name
  suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
  mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial" "$web/sources"
  echo "deb-src http://deb.debian.org/debian $suite main" >"$apt/sources.list"
  options=(-q -o "Dir::Etc::sourcelist=$apt/sources.list" -o Dir::Etc::sourceparts=/dev/null -o "Dir::State::lists=$apt/lists"
    -o "Dir::Cache=$apt/cache" -o APT::Sandbox::User=)
  cd "$web/sources"
  apt-get "${options[@]}" update
  apt-get "${options[@]}" source --download-only "${sources[@]}"
  for name in "${sources[@]}"; do
    rm -rf "$name"
    dpkg-source --no-check -x "$name"_*.dsc "$name"
  done
}

# install_for_web NAME SOURCE [-D...]: configures, builds and installs into the prefix.
install_for_web() {
  local name=$1 source=$2
  shift 2
  quietly "Configuring $name" "$web/$name/configure.log" cmake -G Ninja -S "$source" -B "$web/$name" \
    -DCMAKE_TOOLCHAIN_FILE=$toolchain -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" \
    -DCMAKE_C_FLAGS=$flags -DCMAKE_CXX_FLAGS=$flags -DCMAKE_POLICY_DEFAULT_CMP0077=NEW "$@"
  quietly "Building $name" "$web/$name/build.log" ninja -C "$web/$name"
  quietly "Installing $name" "$web/$name/install.log" ninja -C "$web/$name" install
}

# By its own configure: Debian leaves out a file that its CMakeLists.txt names.
make_zlib() (
  cd "$web/sources/zlib" &&
    CFLAGS="-O3 $flags" emconfigure ./configure --static --prefix="$prefix" &&
    emmake make -j"$(nproc)" libz.a &&
    emmake make install-libs &&
    cp zlib.h zconf.h "$prefix/include/"
)

# Headers that hold all there is to a library: /usr/include itself must not be looked at.
copy_headers() {
  mkdir -p "$prefix/include/GL" "$prefix/include/KHR" "$prefix/share/cmake"
  cp -r /usr/include/nlohmann /usr/include/CLI /usr/include/stb "$prefix/include/"
  cp -r /usr/share/cmake/nlohmann_json /usr/share/cmake/CLI11 "$prefix/share/cmake/"
  cp /usr/include/GL/glcorearb.h "$prefix/include/GL/"
}

# Done once: a finished prefix is left alone until this file or what it is made by changes.
make_prefix() {
  local stamp=$prefix/made
  [[ $stamp -nt scripts/web.sh && $stamp -nt scripts/web/imgui/CMakeLists.txt ]] && return 0
  echo "Making what the page is linked with (once)."
  quietly "Fetching sources" "$web/fetch.log" bash -c "set -e; $(declare -f fetch_sources); web='$web'; sources=(${sources[*]}); fetch_sources"
  rm -rf "$prefix"
  copy_headers
  install_for_web imgui scripts/web/imgui -DIMGUI_SOURCE="$web/sources/imgui"
  install_for_web yaml-cpp "$web/sources/yaml-cpp" -DYAML_CPP_BUILD_TESTS=OFF -DYAML_CPP_BUILD_TOOLS=OFF \
    -DYAML_BUILD_SHARED_LIBS=OFF
  install_for_web libjpeg-turbo "$web/sources/libjpeg-turbo" -DWITH_SIMD=0 -DENABLE_SHARED=0 -DWITH_TURBOJPEG=0 -DSIZE_T=4
  quietly "Building zlib" "$web/zlib.log" make_zlib
  touch "$stamp"
}

# In a headless Chromium, and the logs in Node.js, beside those of build/release.
test_page() {
  build "$web/page" replan_log_hashes
  tests/web/logs_test.sh build/release/tests/replan_log_hashes "$web/page/replan_log_hashes.js"
  node tests/web/page_test.js "$web/site" "$web/replan.html" build/release/replan
}

build_page() {
  PKG_CONFIG_LIBDIR="$prefix/lib/pkgconfig" configure web "$web/page"
  build "$web/page" replan_page
  rm -rf "$web/site"
  mkdir -p "$web/site"
  cp "$web/page/index.html" "$web/page/replan.js" "$web/page/replan.wasm" "$web/site/"
  node scripts/web/one_file.js "$web/site" "$web/replan.html"
  echo "build/web/replan.html opens from a disk; build/web/site/ is a folder for any static server."
}

install_packages "${build_packages[@]}" "${web_packages[@]}"
make_prefix
case ${1:-} in
  '') build_page ;;
  --test)
    install_packages "${web_test_packages[@]}"
    build_page
    test_page
    ;;
  *) echo "usage: scripts/web.sh [--test]" >&2 && exit 2 ;;
esac
