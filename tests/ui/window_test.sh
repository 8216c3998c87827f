#!/usr/bin/env bash
# The window itself, on a display of its own: it opens, a stroke by the mouse paints, a key steps, an edit is saved
# before it closes, it remembers what it should, it opens on a run of a batch, and it records films.
#   window_test.sh PROGRAM
# Exit code 77: skipped, with the reason.
program=${1:?usage: window_test.sh PROGRAM}
. "$(dirname "$0")/window_support.sh"

# 1. Untouched: it closes without a question, at the end of its first plan.
start_program "$scratch/world.json"
xdotool key ctrl+q
end_program "untouched"
expect obstacles 0 "an untouched world"
expect modified false "an untouched world"
planned=$(fact cursor)
[ "$planned" -gt 0 ] || fail "nothing was planned"

# 2. A key steps: Left goes back by an expansion, and the log stays whole.
start_program "$scratch/world.json"
xdotool key Left
settle
xdotool key ctrl+q
end_program "after a step"
[ "$(fact cursor)" -lt "$planned" ] || fail "Left did not step back from $planned"
expect events "$planned" "a step back"

# 3. A stroke paints and is saved with Ctrl+S; the file holds it.
start_program "$scratch/world.json"
stroke 350 350
xdotool key ctrl+s
settle
xdotool key ctrl+q
end_program "after a stroke"
painted=$(fact obstacles)
[ "$painted" -gt 0 ] || fail "the stroke painted nothing"
expect modified false "a saved stroke"
grep -q '@' "$scratch/world.json" || fail "the saved file holds no obstacle"

# 4. An unsaved edit: closing asks, Escape stays, undo takes the edit back, then it closes.
start_program "$scratch/world.json"
xdotool key b
settle
xdotool mousemove 350 450 click 1
settle
xdotool key ctrl+q
settle
kill -0 "$window" 2>/dev/null || fail "it closed over an unsaved edit"
xdotool key Escape
settle
kill -0 "$window" 2>/dev/null || fail "Escape closed the window"
xdotool key ctrl+z
settle
xdotool key ctrl+q
end_program "after undo"
expect obstacles "$painted" "undo"

# 5. The theme is remembered.
start_program "$scratch/world.json"
xdotool key t
settle
xdotool key ctrl+q
end_program "after a change of theme"
grep -q '"dark": false' "$scratch/config/replan/window.json" || fail "the theme was not remembered"

# 6. A run of a batch opens, and is in no file.
cat >"$scratch/experiment.json" <<'JSON'
{"format": "replan experiment", "version": 1, "worlds": ["world.json"], "planners": [{"id": "astar"}, {"id": "dstar-lite"}]}
JSON
planned=$(fact events)
start_program batch "$scratch/experiment.json" --open 1
xdotool key ctrl+q
end_program "on a run of a batch"
expect file "" "a run of a batch"
expect modified false "a run of a batch"
expect obstacles "$painted" "a run of a batch"
expect events "$planned" "the run of the world's own planner"

# 7. A film of the canvas while the run plays, one of the window that is still on when it closes, and pictures.
name_file() { sleep 1; xdotool type --delay 30 "$scratch/$1"; settle; xdotool key Return; settle; }
film_facts() {
  ffprobe -v error -count_frames -of csv=p=0 -show_entries stream=width,height,avg_frame_rate,nb_read_frames "$scratch/$1"
}
if command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null; then
  start_program "$scratch/world.json"
  xdotool key Home
  xdotool key ctrl+shift+r
  name_file canvas.mp4
  [ -e "$scratch/canvas.mp4" ] && fail "an unfinished film stands under its name"
  xdotool key space
  sleep 2
  xdotool key ctrl+shift+r
  for _ in $(seq 100); do [ -e "$scratch/canvas.mp4" ] && break; sleep 0.1; done
  xdotool key ctrl+shift+p
  name_file canvas.png
  xdotool key ctrl+shift+p
  name_file canvas.svg
  xdotool key ctrl+shift+w
  name_file window.gif
  sleep 1
  xdotool key ctrl+q
  for _ in $(seq 300); do kill -0 "$window" 2>/dev/null || break; sleep 0.1; done
  end_program "while it recorded"
  IFS=, read -r width height rate frames <<<"$(film_facts canvas.mp4)"
  [ "$rate" = 30/1 ] && [ "${frames:-0}" -ge 2 ] || fail "the film of the canvas: $rate frames per second, $frames frames"
  [ "$width" -ge 400 ] && [ "$width" -lt 1200 ] && [ "$height" -lt 780 ] || fail "the canvas is not $width x $height"
  IFS=, read -r width height rate frames <<<"$(film_facts window.gif)"
  [ "$width" = 1280 ] && [ "${frames:-0}" -ge 2 ] || fail "the film of the window: $width wide, $frames frames"
  [ "$(film_facts canvas.png | cut -d, -f1)" -lt 1200 ] || fail "the picture of the canvas"
  grep -q '<svg' "$scratch/canvas.svg" || fail "the drawing of the canvas"
  ls "$scratch" | grep -q 'gif\.\|mp4\.' && fail "something was left beside the films"
fi

echo "the window opens, paints, steps, saves, asks, remembers, shows a run and records"
