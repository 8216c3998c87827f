#!/usr/bin/env bash
# Draws every picture of this folder anew, by the program itself: no display needed, the same pixels each time.
#   screenshots/redraw.sh [PROGRAM]      default: build/release/replan
set -euo pipefail

cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
program=${1:-build/release/replan}

draw() {
  local picture=$1
  shift
  "$program" render "maps/${world:-demo}.json" -o "screenshots/$picture" "$@"
}

draw window-dark.png --theme dark
draw window-light.png --theme light

# The robot has seen the passage close, and the way round it is found.
draw demo-surprise.png --theme dark --at replan:1
# A door that shut, a box on no map and two that move: in the middle of the drive.
world=everything-at-once draw everything-at-once.png --theme light --at move:66
# What the paper's pseudo-code does after a surprise, and what the checked one does.
world=fault-through-obstacle draw fault.png --theme dark --at-end

# A planner with a mistake in it: its first bad step, by the laws that it is held to.
world=broken-planner draw broken-planner.png --theme dark --at-end --action show_debug
# What the last replan touched, with the values before and after.
draw last-repair.png --theme light --at replan:1 --action show_touched --overlay g,lp,rp,path,trail,sensor,repair

# Why a cell has its rhs, and who wrote it.
draw why-rhs.png --theme dark --at replan:1 --pin 13,27 --camera 13,26,48 --action show_cell \
  --overlay g,lp,rp,path,trail,numbers
# Where two planners part ways.
draw first-difference.png --theme light --camera 28,42,48 --overlay g,lp,numbers --action first_difference,show_debug
# Breakpoints, their flags on the timeline, and a chart.
draw breakpoints.png --theme dark --at replan:1 --pin 20,22 --action break_on_cell,watch_cell,show_debug
# Four planners side by side, with their figures.
draw figures.png --theme light --at-end --action four_panes,show_figures

# A robot on two wheels among boxes that are on no map: the arcs that it tries, and the one that it takes.
world=fusion-boxes draw arcs.png --theme dark --at move:52 --camera 7,4,46 --panes 1
# Why it does not take another one: the tab Drive, with an arc clicked on which it could not stop.
world=fusion-boxes draw why-arc.png --theme light --at move:52 --camera 5,3,96 --panes 1 --action show_drive --arc 0.42,0.15
# The fusion paper's experiment as a film: with the plan's turns for sub-goals, and with the same drive alone.
world=fusion-boxes draw fusion-boxes.gif --planner fusion,dwa --canvas-only --panes all --size 760x430 --fps 12 --speed 100 \
  --hold 0 --from plan --theme light --overlay path,trail,arcs,sensor,unknown,size
# What a plan is for: a pocket that opens towards the robot holds the one that has none.
world=bug-trap draw fusion.png --theme light --planner dstar-lite,fusion,dwa,theta-star --overlay path,trail,grid \
  --canvas-only --panes all --size 1200x860 --at-end
# The reference planners beside D* Lite, each with the cells that it worked at.
for planner in weighted-astar adaptive-astar jps visibility-graph theta-star lazy-theta-star lpa-star field-dstar dstar \
  focused-dstar threat-dstar; do
  world=fusion-maze draw "$planner.png" --theme light --planner "dstar-lite,$planner" --overlay g,scanned,path,queue,grid \
    --canvas-only --panes all --size 960x520
done

# Trees of samples: what each sample comes to, and the ellipse that a shorter path must lie in.
world=gap-for-samples draw rrt-star.png --theme dark --at-plan --panes all --size 1440x900 --action show_figures
# The Informed RRT* paper's hardest world, and the DLD* Lite paper's line-up, with their figures.
world=informed-rrt-3 draw informed-rrt.png --theme dark --at-plan --panes all --size 1600x1000 --action show_figures
world=dld-fig-5 draw line-up.png --theme light --at-plan --panes all --size 1600x1000 --action show_figures
# Why a vertex hangs where it does.
world=gap-for-samples draw why-edge.png --theme light --at-plan --panes 1 --pin 50,56 --camera 50,52,16 --action show_cell
"$program" anytime maps/gap-for-samples.json --planner rrt-connect,rrt-star,informed-rrt-star,greedy-informed-rrt-star --seeds 20 \
  --svg screenshots/anytime.svg > /dev/null

# What a study leaves: its planners side by side, and a diagram that gnuplot draws.
report=$(mktemp -d)
"$program" study dld-table1 --quick --out "$report" >/dev/null
cp "$report/dld-table1-paths.png" screenshots/study-paths.png
cp "$report/dld-table1-nodes.svg" screenshots/study-nodes.svg
rm -r "$report"

# A batch that is under way.
draw batch.png --dialog batch_results --theme dark --size 1280x800

# Paths that are bred: the child in hand, what each neighbour of the changed cell would make of it, and why.
draw improved-ga.png --planner improved-ga --overlay population,path,grid --theme dark --at 28193 --pin 16,36 --camera 15,33,30 \
  --action show_cell --size 1440x900

# What coming near obstacles costs, and the path that pays it beside one that does not.
world=office draw threat-astar.png --theme light --planner astar,threat-astar --overlay dist,path,grid --canvas-only \
  --panes all --at plan --size 1280x520
# A path rounded to a curve: its control polygon, and where the curve was pulled in.
world=office draw spline.png --theme light --planner astar --stage bspline --set bspline.corners_only=true \
  --overlay path,spline,grid --canvas-only --at plan --camera 50,27,28 --size 960x600

# In three dimensions: a vehicle that knows its world by sonar alone, with plain D* and with the threat cost and a spline.
world=auv draw auv.gif --canvas-only --panes all --size 1080x400 --orbit 25,32 --slice robot --fps 12 --speed 10/s --hold 0.1 \
  --from plan --theme dark
world=auv draw auv.png --orbit 25,32 --at move:20 --panes all --theme light --size 1280x800

# The whole story as a film, small enough for a page: two planners, the surprise and the repairs.
draw demo.gif --canvas-only --panes all --size 840x560 --fps 20 --speed 10/s --hold 0.8 --theme dark
