# shellcheck shell=bash
# Configuring and building, quiet unless something fails. Sourced by ./run and ./test, which run in the project's
# folder.

# Runs a command with its output in a file, shown only if it fails. On a terminal, one line says how far it is.
quietly() {
  local title=$1 log=$2 status=0
  shift 2
  mkdir -p "$(dirname "$log")"
  if [[ -t 1 ]]; then
    # The last line of the output so far, cut to the window, over the one before.
    "$@" 2>&1 | tee "$log" | while IFS= read -r line; do
      printf '\r\033[K%s' "${line:0:$((${COLUMNS:-80} - 1))}"
    done || status=$?
    printf '\r\033[K'
  else
    "$@" >"$log" 2>&1 || status=$?
  fi
  if ((status != 0)); then
    # Steps that went well say nothing about the one that did not.
    grep -v '^\[[0-9]*/[0-9]*\] ' "$log" >&2 || true
    echo "$title failed (the whole log: $log)" >&2
  fi
  return "$status"
}

# A build folder that was copied or moved along with the project still names the old place.
is_configured() {
  local folder=$1
  [[ -f $folder/build.ninja ]] && grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$folder/CMakeCache.txt"
}

# configure PRESET FOLDER [-D...]: (re)configures; Ninja does it by itself when a CMakeLists.txt changes.
configure() {
  local preset=$1 folder=$2 fresh=()
  shift 2
  [[ -f $folder/CMakeCache.txt ]] && ! is_configured "$folder" && fresh=(--fresh)
  quietly "Configuring ($preset)" "$folder/configure.log" cmake --preset "$preset" "${fresh[@]}" "$@" ||
    { on_debian || say_libraries; return 1; }
}

# build FOLDER [TARGET...]
build() {
  local folder=$1
  shift
  quietly "Building in $folder" "$folder/build.log" ninja -C "$folder" "$@"
}
