#!/usr/bin/env bash
# Work that was not saved outlives the program: after kill -9 it is offered, taken up, kept until it is saved, and
# never offered while the program that holds it lives.
#   recovery_test.sh PROGRAM
# Exit code 77: skipped, with the reason.
program=${1:?usage: recovery_test.sh PROGRAM}
. "$(dirname "$0")/window_support.sh"

autosaves="$scratch/state/replan/autosave"
is_kept() { ls "$autosaves"/*.json; }
is_gone() { ! ls "$autosaves"/*.json; }

# 1. Paint, also once the robot has set out, and wait: the edits are put aside while nothing is saved.
start_program "$scratch/world.json"
stroke 350 350
xdotool key Up
settle
stroke 350 450
within 15 is_kept || fail "unsaved edits were not put aside"
cp "$scratch/world.json" "$scratch/before.json"
kill -9 "$window"
wait "$window" 2>/dev/null
window=
is_kept >/dev/null || fail "the autosave did not outlive the program"
cmp -s "$scratch/world.json" "$scratch/before.json" || fail "the file was changed without being saved"

# 2. The next start offers them. Escape: later. They stay, and the file is as it was.
start_program "$scratch/world.json"
xdotool key Escape
settle
xdotool key ctrl+q
end_program "with recovery put off"
expect obstacles 0 "recovery put off"
is_kept >/dev/null || fail "an autosave that was put off is gone"

# 3. Enter takes them up: the obstacles are there, and still unsaved; another kill loses nothing.
start_program "$scratch/world.json"
xdotool key Return
settle
sleep 1
kill -9 "$window"
wait "$window" 2>/dev/null
window=
is_kept >/dev/null || fail "work that was taken up was lost by the second kill"
start_program "$scratch/world.json"
xdotool key Return
settle
xdotool key End
sleep 2

# 4. While it lives, another window does not offer the same work: Enter there does nothing, and it closes at once.
first=$window first_id=$id
REPLAN_STATE_DUMP="$scratch/second.json" REPLAN_TIMING= "$program" "$scratch/world.json" >"$scratch/output2" 2>&1 &
second=$!
sleep 3
second_id=$(xdotool search --onlyvisible --pid "$second" 2>/dev/null | tail -1)
xdotool windowfocus "${second_id:-$(xdotool search --onlyvisible --name Replan | grep -v "^$first_id$" | tail -1)}" 2>/dev/null
settle
xdotool key Return
settle
xdotool key ctrl+q
within 10 sh -c "! kill -0 $second" || { kill "$second"; fail "the second window did not close: it had something to ask"; }
wait "$second"
grep -q '"obstacles": 0' "$scratch/second.json" || fail "the second window took up work that another one holds"
window=$first id=$first_id
xdotool windowfocus "$id" 2>/dev/null
settle

# 5. Saved: the autosave is gone, the edits are in the file, nothing is offered any more.
xdotool key ctrl+s
settle
within 5 is_gone || fail "the autosave outlived the saving"
xdotool key ctrl+q
end_program "after recovery"
painted=$(fact obstacles)
[ "$painted" -gt 1 ] || fail "the recovered world holds $painted obstacles"
[ "$(fact moves)" -gt 0 ] || fail "the recovered mission did not run"
expect modified false "recovered and saved"
expect file "$scratch/world.json" "recovered and saved"
grep -q '"surprises"' "$scratch/world.json" || fail "the edit on the way was lost"
start_program "$scratch/world.json"
xdotool key End
sleep 2
xdotool key ctrl+q
end_program "after saving"
expect obstacles "$painted" "the saved world"
expect modified false "the saved world"

# 6. A clean end over unwanted edits leaves nothing behind.
start_program "$scratch/world.json"
xdotool key b
settle
xdotool mousemove 350 250 click 1
within 15 is_kept || fail "the second edit was not put aside"
xdotool key ctrl+z
within 5 is_gone || fail "the autosave outlived the undo"
xdotool key ctrl+q
end_program "after undo"
[ -z "$(ls -A "$autosaves")" ] || fail "left behind: $(ls -A "$autosaves")"
[ -s "$scratch/state/replan/recent.json" ] && grep -q world.json "$scratch/state/replan/recent.json" ||
  fail "the file is not among the recent ones"

echo "unsaved work outlives kill -9, is offered once, taken up whole, and cleaned away"
