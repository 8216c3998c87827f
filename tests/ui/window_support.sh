# Sourced by the tests of the window: a display of its own, and a program on it.
# The program to test is in $program. Exit code 77: skipped, with the reason.
set -u

skip() { echo "skipped: $1"; exit 77; }
for tool in Xvfb xdotool; do command -v "$tool" >/dev/null || skip "$tool is not installed"; done

scratch=$(mktemp -d)
server= window=
clean_up() {
  [ -n "$window" ] && kill "$window" 2>/dev/null
  [ -n "$server" ] && kill "$server" 2>/dev/null
  rm -rf "$scratch"
}
trap clean_up EXIT

fail() {
  echo "FAILED: $1"
  [ -s "$scratch/output" ] && sed 's/^/  program: /' "$scratch/output"
  [ -s "$scratch/state.json" ] && cat "$scratch/state.json"
  exit 1
}

# Xvfb itself looks for a free display and tells its number.
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 3>"$scratch/display" >"$scratch/server" 2>&1 &
server=$!
for _ in $(seq 100); do [ -s "$scratch/display" ] && break; sleep 0.1; done
[ -s "$scratch/display" ] || skip "Xvfb did not start: $(tail -1 "$scratch/server")"
export DISPLAY=":$(cat "$scratch/display")"
export LIBGL_ALWAYS_SOFTWARE=1 XDG_CONFIG_HOME="$scratch/config" XDG_STATE_HOME="$scratch/state"
export REPLAN_STATE_DUMP="$scratch/state.json" REPLAN_SCALE=1
unset WAYLAND_DISPLAY

# An open world of 20 x 10 cells: wherever the stroke falls in its middle it paints.
cat >"$scratch/world.json" <<'JSON'
{"replan": 1, "map": {"rows": ["....................", "....................", "....................",
 "....................", "....................", "....................", "....................",
 "....................", "....................", "...................."]},
 "start": [1, 1], "goal": [18, 8], "planners": [{"id": "dstar-lite"}]}
JSON

start_program() {
  rm -f "$scratch/state.json"
  : >"$scratch/output"  # or the last program's first frame is taken for this one's
  REPLAN_TIMING=1 "$program" "$@" >"$scratch/output" 2>&1 &
  window=$!
  # The first frame is reported; a window without a manager needs the focus given to it.
  for _ in $(seq 300); do grep -q "first frame" "$scratch/output" && break; kill -0 "$window" 2>/dev/null || fail "it ended before its first frame"; sleep 0.1; done
  grep -q "first frame" "$scratch/output" || fail "no first frame within 30 seconds"
  xdotool search --sync --onlyvisible --pid "$window" >"$scratch/id" 2>/dev/null || xdotool search --onlyvisible --name Replan >"$scratch/id"
  id=$(tail -1 "$scratch/id")
  xdotool windowfocus "$id" 2>/dev/null
  settle
}
settle() { sleep 0.7; }
# Waits until the command succeeds, for at most so many seconds.
within() {
  local seconds=$1 _; shift
  for _ in $(seq $((seconds * 10))); do "$@" >/dev/null 2>&1 && return 0; sleep 0.1; done
  return 1
}
# Waits for the program's own end and checks how it went.
end_program() {
  for _ in $(seq 150); do kill -0 "$window" 2>/dev/null || break; sleep 0.1; done
  kill -0 "$window" 2>/dev/null && fail "it did not close: $1"
  wait "$window"; code=$?
  window=
  [ "$code" = 0 ] || fail "it closed with exit code $code: $1"
}
fact() { sed -n "s/^ *\"$1\": \"\{0,1\}\([^\",]*\)\"\{0,1\},\{0,1\}$/\1/p" "$scratch/state.json"; }
expect() { [ "$(fact "$1")" = "$2" ] || fail "$3: $1 is '$(fact "$1")', not '$2'"; }
# Presses the left button there and drags to the right, painting.
stroke() {
  xdotool key b
  settle
  xdotool mousemove "$1" "$2" mousedown 1
  settle
  for by in 30 60 90; do xdotool mousemove "$(($1 + by))" "$2"; sleep 0.1; done
  xdotool mouseup 1
  settle
}
