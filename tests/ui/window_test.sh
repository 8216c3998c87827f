#!/usr/bin/env bash
# The window itself, on a display of its own: it opens, a stroke by the mouse paints, a key steps, an edit is saved
# before it closes, and it remembers what it should.
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

echo "the window opens, paints, steps, saves, asks and remembers"
