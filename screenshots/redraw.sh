#!/usr/bin/env bash
# Draws every picture of this folder anew, by the program itself: no display needed, the same pixels each time.
#   screenshots/redraw.sh [PROGRAM]      default: build/release/replan
set -euo pipefail

cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
program=${1:-build/release/replan}
drive=100  # events of the drive round the closed passage

draw() {
  local picture=$1
  shift
  "$program" render maps/demo.json -o "screenshots/$picture" "$@"
}

draw window-dark.png --theme dark
draw window-light.png --theme light

# The robot has seen the passage close, and the way round it is found: a little after the run's last plan. Counted from
# the end, since the length of the search before it may change; the program tells the run's length when asked for more.
complaint=$("$program" render maps/demo.json -o screenshots/demo-surprise.png --at 999999999999 2>&1 || true)
events=$(sed -n 's/.*it has \([0-9]*\) events.*/\1/p' <<<"$complaint")
# The whole story as a film, small enough for a page: two planners, the surprise and the repairs.
draw demo.gif --canvas-only --panes all --size 840x560 --fps 20 --speed 10/s --hold 0.8 --theme dark

draw demo-surprise.png --theme dark --at "$((events - drive))"
