// A table, and longer than a file should be for that reason alone.
#include "core/plan/glossary.hpp"

#include <algorithm>
#include <cctype>

namespace replan {
namespace {

constexpr GlossaryTerm kTerms[] = {
    // Values of a cell
    {"g", "g",
     "The cost from this cell to the goal that the search has settled on so far (A* and Dijkstra: from the "
     "start "
     "to this cell). Infinite until the cell is expanded."},
    {"rhs", "rhs, the lookahead value",
     "What g should be, given the neighbours' current values: the least c + g + dist over all cells that one "
     "move leads to, and 0 at the goal. Where rhs differs from g, the cell still has to be processed."},
    {"c", "c, the cost of a move",
     "1 for a straight step, the square root of 2 for a diagonal one, and infinite where an obstacle is in "
     "the "
     "way."},
    {"dist", "dist, the clearance penalty",
     "What entering the cell costs on top of the move because it lies near an obstacle: range − distance + 1 "
     "within the range, or the threat, and 0 beyond. It makes paths keep their distance."},
    {"key", "Key",
     "A cell's priority in the open list: two numbers [k1; k2], compared one after the other. The smallest "
     "key is "
     "taken next."},
    {"k1", "k1, the first key component",
     "min(g, rhs) + h + km: the cost of a path through this cell, as the heuristic h estimates it, and km. "
     "The list keeps the key that the cell was put in with; beside a key computed now it may be too low, "
     "never too high."},
    {"k2", "k2, the second key component",
     "min(g, rhs). It decides between cells with the same k1: the one nearer to the goal is taken first, and "
     "raised "
     "cells before those that depend on them."},
    {"f", "f",
     "g + h: the cost of a path through this cell, as the heuristic estimates it. A* takes the cell with the "
     "smallest f next. In focused D*: k and the estimate of the way from the robot to the cell."},
    {"h", "h",
     "In D* and its like the cost of the way to the goal along back-pointers, as far as is known; infinite "
     "where none "
     "is. In A* and D* Lite the heuristic, an estimate of a cost."},
    {"k", "k, the lowest cost",
     "The least that h was since the cell came into the open list of D*. With k < h the cell is in a RAISE "
     "state, with "
     "k = h in a LOWER state. The list is ordered by k."},
    {"f_B", "f_B, the biased cost",
     "f and the bias, which grows when the robot moves: what focused D* orders its open list by. Beside a "
     "value made now "
     "an old one may be too low, never too high. Of equal ones the smaller f comes first, then the smaller "
     "k."},
    {"d", "d, the bias",
     "What the robot's moves have added to new keys of focused D*: at least as much as an estimate can have "
     "fallen since "
     "the first plan. D* Lite's km is the same idea."},
    {"b", "b, the back-pointer",
     "The neighbour that the cell's way to the goal leads to, in D* and its like. The robot follows "
     "back-pointers."},
    {"tag", "Tag of a cell",
     "NEW: D* has never put it in the open list. OPEN: it is there. CLOSED: it was there and was taken."},
    {"raise", "RAISE state",
     "k < h: the way from this cell became dearer. When it is taken it first looks for a better way, then "
     "tells all cells "
     "whose back-pointers lead to it. So a wave of risen costs runs as far as anybody relied on them."},
    {"lower", "LOWER state",
     "k = h: the cost of this cell is as low as it was since it waits. When it is taken it offers that to "
     "all "
     "neighbours, which turn their back-pointers to it if it is better than what they have."},
    {"lp", "lp, the local parent",
     "The neighbour that this cell's rhs comes from: the next cell on a cheapest way to the goal, step by "
     "step over "
     "the grid."},
    {"rp", "rp, the remote parent",
     "A cell farther along the way to the goal that can be driven to in a straight line. The path follows "
     "remote "
     "parents, so it may have any angle."},
    {"parent", "Parent",
     "The neighbour that the search reached this cell from. Following the parents from the goal back to the "
     "start "
     "gives the path."},
    {"order", "Expansion order",
     "The number of the cell's latest expansion, counted over the whole run. Low numbers came first: the "
     "wave that "
     "the search ran in."},
    {"times", "Times expanded",
     "How often the cell was expanded. A plan from scratch expands most cells once; a repair expands some "
     "again."},
    {"state", "State of a cell",
     "Consistent if g equals rhs, over(consistent) if g is larger, under(consistent) if g is smaller. Only "
     "cells "
     "that are not consistent wait in the open list. In D* a cell is NEW, CLOSED, or waits in a RAISE or "
     "LOWER state."},
    {"inconsistent", "Inconsistent",
     "g and rhs differ, so there is work to do at the cell: it waits in U, the open list. With g > rhs it is "
     "overconsistent, with g < rhs underconsistent."},
    {"consistent", "Consistent", "g = rhs: the cell agrees with its neighbours and needs no work."},
    {"overconsistent", "Overconsistent",
     "g > rhs: a cheaper way has been found than the one settled. When the cell is expanded, g is lowered to "
     "rhs, and its neighbours are updated."},
    {"underconsistent", "Underconsistent",
     "g < rhs: the way that g was computed from costs more now or is blocked. When the cell is expanded, g "
     "is raised to infinity first, so that no neighbour goes on relying on it."},
    // The search
    {"open-list", "U, the open list",
     "The priority queue of the cells whose g and rhs differ (A*: of the cells that were reached and not yet "
     "expanded), ordered by key. The search takes the first one, again and again."},
    {"rank", "Place in the open list",
     "How many cells would be taken before this one, plus one: #1 is next, if no key changes until then."},
    {"expansion", "Expansion",
     "One round of the main loop: a cell is taken from the open list, its g is settled or raised, and its "
     "neighbours "
     "are brought up to date."},
    {"expansions", "Expansions",
     "How many cells were taken from the open list and settled or raised: the usual measure of a search's "
     "work that "
     "does not depend on the machine."},
    {"queue-operations", "Queue operations",
     "How often something was put into the open list, taken out or given another key. Each costs time that "
     "grows "
     "with the logarithm of the list's length."},
    {"sight-checks", "Sight checks",
     "How often the search, or the path that was read out of it, asked whether two cells see each other."},
    {"memory", "Memory of the planner",
     "The most bytes that the planner held: its values per cell and its open list, the map not counted."},
    {"km", "km, the key modifier",
     "How far the robot has gone between replans, as the heuristic measures it. Old keys would have to "
     "shrink by at most this distance. Instead, km is added to all new keys, so that old and new ones stay "
     "comparable without re-sorting the list."},
    {"stale-key", "Stale key",
     "A key from before the robot moved or the costs changed. When its cell is taken, the key is computed "
     "again; if it has grown, the cell goes back into the list unexpanded."},
    {"lookahead", "Lookahead",
     "D* Lite keeps two values per cell: g, and rhs, which looks one step ahead. Comparing the two tells "
     "which cells "
     "a change of the map has touched, so only these are searched again."},
    {"s_start", "s_start",
     "Where the search thinks the robot is: the cell that keys are aimed at. It moves to the robot's cell "
     "with each "
     "replan."},
    {"s_last", "s_last",
     "Where the robot stood when km last grew. The heuristic from there to the robot's present cell is what "
     "km grows "
     "by next."},
    {"heuristic", "Heuristic, h",
     "A quick estimate of the cost between two cells that never exceeds the true one. It draws the search "
     "towards "
     "the end instead of in all directions; the closer to the truth, the fewer expansions."},
    {"octile", "Octile distance",
     "The exact cost between two cells on an empty grid with eight neighbours: diagonal steps as far as they "
     "go, "
     "then straight ones."},
    {"euclidean", "Euclidean distance",
     "The straight-line distance. Never more than the octile distance, so it misleads no search, but it "
     "draws less "
     "and more cells are expanded."},
    {"chebyshev", "Chebyshev distance",
     "The larger of the two differences of the coordinates: as if a diagonal step cost no more than a "
     "straight "
     "one."},
    {"manhattan", "Manhattan distance",
     "The sum of the differences of the coordinates: exact with four neighbours. With diagonal moves it "
     "estimates "
     "too much, and the path found may not be a shortest one."},
    {"moves", "Neighbours",
     "The cells that one move leads to: 8 with diagonals, 4 without (26 and 6 in 3D)."},
    {"corners", "Corner rule",
     "Which cells beside a diagonal move may be blocked: none (the robot never cuts a corner), at most one, "
     "or any "
     "(it may squeeze between two obstacles that touch)."},
    {"sight", "Line of sight",
     "Whether a straight line between two cells is clear: no cell that it crosses is an obstacle, or lies "
     "near one "
     "when clearance counts."},
    {"supercover", "Supercover line",
     "All cells that the segment touches. The strict rule: what is clear by it is free of obstacles."},
    {"bresenham", "Bresenham line",
     "The cells that a line-drawing algorithm fills. The rule of the DLD* Lite paper; it checks fewer cells, "
     "and a "
     "line may graze a corner that it does not look at."},
    {"clearance", "Clearance",
     "The distance to the nearest obstacle. Planners with clearance pay for cells that have little of it."},
    {"clearance-range", "Clearance range", "How far from obstacles the penalty reaches, in cells."},
    {"threat", "Threat",
     "A penalty near obstacles that falls as a power of e: c up to the distance r_min, from there on c "
     "e^-(distance − "
     "r_min), and 0 beyond r_max. Up to r_min cells may be impassable instead."},
    {"spline", "B-spline",
     "A smooth curve that follows a row of control points without touching most of them: each piece is drawn "
     "from four "
     "of them. The straight lines between the points are its control polygon."},
    {"curvature", "Curvature",
     "How sharply a way bends: one over the radius of the circle that fits it best. 0 is a straight line. Of "
     "a path it is "
     "the change of heading over half a cell to either side, so that corners have one too."},
    {"distance-transform", "Distance transform",
     "The distance of every cell to its nearest obstacle, for all cells at once. After a change only the "
     "cells around it are computed again."},
    {"chamfer", "Chamfer distance",
     "A distance put together from steps of 1 and the square root of 2, in two passes over the map: the "
     "octile distance to the nearest obstacle, as if nothing stood in between."},
    {"any-angle", "Any-angle path",
     "A path whose straight segments may run in any direction, not only along the eight of the grid: "
     "shorter, with "
     "fewer turns."},
    {"interpolation", "Interpolation",
     "What a point between two cells costs, taken from their g: in the middle between 5 and 6 it is 5.5. "
     "Field D* leads its path through such points."},
    {"side", "side",
     "Where the way on from this cell leads between two cells, the one that is not lp: lp is beside this "
     "cell, and side lies across the corner."},
    {"unchecked-parent", "Unchecked remote parent",
     "A remote parent that the robot follows without a check that the way is still clear. Only with remote "
     "parents as printed; it can lead into an obstacle."},
    // A run
    {"plan", "Plan",
     "The path that the robot follows, and the search's values that it was read out of. It is complete once "
     "the "
     "search has nothing left to do."},
    {"replan", "Replan",
     "What happens when the robot's map has changed: the planner takes in the changed cells and searches "
     "until a "
     "plan is complete again."},
    {"repair", "Repair",
     "A replan that keeps what is still right and works out only the rest. The fewer cells it touches "
     "beside a "
     "plan from scratch, the more the incremental search has saved."},
    {"from-scratch", "Plan from scratch",
     "Forgetting everything and planning on the map as it is now: what a repair is measured against."},
    {"cell", "Cell",
     "A square of the world, free or an obstacle, and a place of the search with a g and a key. Pseudo-code "
     "and papers "
     "call it a vertex or a node."},
    {"surprise", "Surprise",
     "A change of the world while the robot drives: obstacles that appear or go, at a step or when the robot "
     "comes "
     "near. It replans once it sees them, or at once if it is told."},
    {"sensor", "Sensor",
     "What the robot sees: cells within its radius, and with an opening angle only those ahead. What differs "
     "from its map there is put right, and the plan is repaired."},
    {"course", "Course",
     "Which way the robot looks: the direction of its last move, before the first one that to its goal. A "
     "sensor with an opening angle looks along it."},
    {"turn-on-the-spot", "Turn on the spot",
     "At a corner that is too sharp for it a vehicle stops and turns before it goes on: a step by itself, "
     "after which it looks the new way."},
    {"known", "The robot's map", "What the robot takes the world for. It plans on this map alone."},
    {"truth", "The true world", "What really stands there, whether the robot knows it or not."},
    {"moving-obstacle", "Moving obstacle",
     "A box of cells that goes along a drawn way. It waits for the robot rather than run into it."},
    {"stuck", "Stuck",
     "A robot that drives has a plan, but none of the arcs that it can take up leads along it: it has turned "
     "all the way "
     "round in vain, or come no nearer to its goal for as long as its patience lasts."},
    {"sub-goal", "Sub-goal",
     "The corner of its plan that a robot which drives makes for: the next one when it is near, or when the "
     "way "
     "to the one after it is free."},
    {"admissible", "Admissible",
     "A speed and turn rate that a robot which drives may choose: its motors can reach it within a period, "
     "and it "
     "could still stop before it touches anything."},
    {"score", "Score of an arc",
     "What a robot which drives chooses by: heading, speed and the distances from known and unknown "
     "obstacles, each "
     "brought to the scale of 0 to 1 and multiplied by its weight."},
    {"robot-moves", "Moves",
     "How many cells the robot has entered; of a robot on wheels, for how many periods it has driven."},
    {"robot", "Robot",
     "What drives along the plan. It plans on the map that it believes in, which its sensor corrects within "
     "its "
     "radius, and replans when that changes."},
    {"steps", "Steps",
     "The robot's clock: every move is a step, and so is every turn on the spot, and every wait while it has "
     "no "
     "path."},
    {"travelled", "Travelled",
     "How far the robot has driven, in cells, along the straight segments of its paths."},
    {"collision", "Collision",
     "A plan led the robot into an obstacle that it knew or could see. It never happens with checked remote "
     "parents."},
    {"no-path", "No path",
     "Nothing leads from the robot to the goal on its map. That is an answer, not an error: it waits, and "
     "goes on "
     "when a way opens."},
    {"nearest-goal", "Nearest reachable cell",
     "Where the goal is an obstacle or cannot be reached, a robot that is set so makes for the cell nearest "
     "to "
     "it, as the crow flies, that it can reach, and goes on to the goal once a way opens."},
    {"robot-radius", "Radius of the robot",
     "Of its body, in cells; 0 is a point. Its centre keeps at least so far away from the squares of all "
     "obstacles, and "
     "it cuts no corners."},
    {"too-near", "Too near",
     "A free cell whose centre is nearer to an obstacle than the robot's radius: the robot's centre keeps "
     "out of it. A "
     "robot that an obstacle comes too near to drives out, and never nearer to obstacles on the way."},
    {"arrival", "Arrival", "The robot stands on the goal."},
    // Planners that sample
    {"sample", "Sample",
     "A place of the world that is drawn by chance, and that the tree is grown towards. A planner that "
     "samples is at "
     "work sample by sample, as a search is expansion by expansion."},
    {"goal-bias", "Goal bias",
     "How often the goal itself is taken for the sample, as long as there is no path: with 0.05 one time in "
     "twenty."},
    {"tree", "Tree of samples",
     "Places that were reached, its vertices, each hung on another one by a straight way that is free. From "
     "every "
     "vertex one way leads back to the root, where the robot is."},
    {"tree-vertex", "Vertex of a tree",
     "A place that the tree has reached. Its cost is the length of its way to the root; the number tells "
     "when it came."},
    {"steer", "Steer",
     "From the vertex nearest to the sample straight towards it, and no farther than a step: there the new "
     "vertex comes "
     "to lie."},
    {"ball", "Ball",
     "The vertices no farther than so much from the new place: RRT* looks among them for the parent with the "
     "shortest "
     "way, and for vertices that it can rewire."},
    {"candidate", "Candidate",
     "A vertex that the new one could hang on. Its sum is the way to it and the edge from there; of those "
     "whose edge is "
     "free the least sum wins."},
    {"rewired", "Rewired",
     "Hung on another vertex, over which the way to the root is shorter. All that hangs on it becomes nearer "
     "by as "
     "much."},
    {"ellipse", "Ellipse, the informed set",
     "The places over which a path shorter than the best one could lead: those whose distances to the start "
     "and to the "
     "goal together are less than c_best. In space it is an ellipsoid."},
    {"c_best", "c_best",
     "The length of the best path so far. Informed planners draw samples from the ellipse that it spans, "
     "which shrinks "
     "with it."},
    {"c_min", "c_min",
     "The distance from the start to the goal, as the crow flies. No path is shorter; the nearer c_best "
     "comes to it, the "
     "narrower the ellipse."},
    {"cut-off", "Cut off",
     "No longer in the tree: the edge to it hits an obstacle that the robot has learnt of, or it hung on a "
     "vertex that "
     "was cut off."},
    {"anytime", "Anytime",
     "Of a planner that has a path early and betters it as long as it is let: it may be stopped at any time "
     "after the "
     "first path, and the longer it runs, the better that is."},
    // Planners that evolve
    {"population", "Population",
     "The paths that a genetic algorithm keeps, always the same number of them. Each leads from the start to "
     "the goal; "
     "some of them may hit obstacles."},
    {"chromosome", "Chromosome",
     "A path as the genetic algorithm sees it: the row of cells at which it turns, start and goal included. "
     "Each of the "
     "cells is a gene."},
    {"child", "Child",
     "A path that is made of two others by crossover and mutation. If it is fitter than the least fit path, "
     "and not in "
     "the population yet, it takes that one's place."},
    {"generation", "Generation",
     "As many children as the population has paths. The work of a genetic algorithm is counted by "
     "generations."},
    {"fitness", "Fitness",
     "1 / cost, where the cost of a path is its length and a penalty for each straight way that hits an "
     "obstacle. A path "
     "that hits nothing is fitter than any that does."},
    {"selection", "Selection by tournament",
     "How parents are chosen: some paths are drawn by chance, and the fittest of them becomes the mother, or "
     "the "
     "father."},
    {"crossover", "Crossover",
     "What makes a child of two paths: it has the mother's cells up to one, and the father's from there on. "
     "The one is "
     "a cell that both have, if there is any."},
    {"mutation", "Mutation",
     "A cell of the child is replaced by a free neighbour. The improved one tries all of them and takes that "
     "with which "
     "the whole path is fittest; a plain one takes any."},
    {"elitism", "Elitism",
     "The fittest path is never lost: a child can only take the place of a path that is less fit than "
     "itself. So the "
     "best cost never rises within a plan."},
    // Figures of a path
    {"nodes", "Nodes of a path",
     "The corners of the path's polyline, both ends counted. Fewer nodes, fewer manoeuvres."},
    {"length", "Path length",
     "Measured along the path's straight segments, in cells; penalties are not in it."},
    {"to-go", "To go", "How much of the plan's path the robot still has before it, in cells."},
    {"cost", "Path cost",
     "What the search minimises: the moves of the path over the grid and the clearance penalties on it."},
    {"turns", "Turns", "Inner corners where the path changes its heading."},
    {"turning", "Turning", "The sum of all changes of heading along the path, in degrees."},
    {"min-clearance", "Least clearance",
     "From the path to the nearest obstacle's edge, at the narrowest place, in cells."},
    {"mean-clearance", "Mean clearance",
     "From the path to the nearest obstacle's edge, averaged over the path every tenth of a cell, in cells."},
    {"edge-clearance", "Clearance of the edge",
     "The clearance of a robot with a size from its edge instead of its centre: less by its radius."},
    {"plan-ms", "Time of the first plan",
     "Wall time of the first search, in milliseconds. In the window this includes recording every step, so a "
     "run from the command line is faster."},
    {"replan-ms", "Time of the replans",
     "Wall time of all replans together, in milliseconds: taking in the changes, and the search."},
    {"replans", "Replans", "How often the plan was repaired, or made from scratch."},
    // The debugger
    {"event", "Event",
     "One record of the log: a value that changed, a pseudo-code line that was passed, or something that "
     "happened. "
     "Each can be taken back, which is how the run goes backwards."},
    {"log", "Log", "All events of a run in order. The same scenario gives the same log on every machine."},
    {"position", "Position in the log",
     "How many events lie before the playhead: 0 is before the first one. What is shown is the state after "
     "that "
     "many."},
    {"key-frame", "Key frame",
     "A whole state, kept every so many events, so that any position can be gone to without walking through "
     "all "
     "events from the beginning."},
    {"record", "Record",
     "The memory that the log and its key frames take: what it costs to be able to go back. Beyond 1 GiB, "
     "for "
     "all panes together, stretches are dropped and planned once more when one goes there."},
    {"code-line", "Pseudo-code line",
     "The line of the published algorithm that the planner is at. Every event knows the line that made it."},
    {"pop", "Taken from U",
     "The cell with the smallest key leaves the open list, to be expanded or to go back with a newer key."},
    {"breakpoint", "Breakpoint",
     "A condition that the run stops at as soon as it comes true: an event, a code line, or values such as "
     "g(12,40) > 30."},
    {"watch", "Watch",
     "A value that is drawn over the whole run as a small chart, so that its history is in sight."},
    {"history", "History of a value",
     "Every event that changed it, from the first to the last. A click goes there."},
    {"last-writer", "Last written by",
     "The latest event before the playhead that changed this value, and the line of pseudo-code that it came "
     "from."},
    {"invariant", "Invariant",
     "A law that the planner's values must keep after every step, such as: a cell is in U exactly if g and "
     "rhs "
     "differ. The first step that breaks one is where a fault began."},
    {"breach", "Breach", "A law that does not hold where it should: what is, and what should be."},
    {"oracle", "Oracle",
     "A second opinion: plain Dijkstra on the map as the robot knows it. The planner's plan must cost "
     "exactly what "
     "the oracle's does."},
    {"difference", "First difference",
     "The first event, expansion, cost or move in which two planners on the same world do not agree."},
    {"lockstep", "Lockstep",
     "Panes go on together: at every moment their robots have taken as many steps, or their searches as many "
     "expansions."},
    {"lead", "Leading pane", "The pane whose run the timeline and the tabs show. The other panes follow it."},
    {"from-here", "Branch",
     "An edit made while looking at the past: the run goes on from that moment, and the old future comes "
     "back with "
     "undo."},
    {"trace", "Search trace",
     "The log as a file for other programs: JSON Lines, or the format of the Posthoc visualiser."},
    {"seed", "Seed",
     "The number that chance is drawn from. The same seed gives the same world, on every machine."},
};

struct Alias {
  std::string_view written, id;
};
constexpr Alias kAliases[] = {
    {"U", "open-list"},
    {"|U|", "open-list"},
    {"queue", "open-list"},
    {"open list", "open-list"},
    {"in U", "rank"},
    {"#", "rank"},
    {"key (k1)", "key"},
    {"dist (penalty)", "dist"},
    {"top curvature", "curvature"},
    {"sight lines", "sight"},
    {"over", "overconsistent"},
    {"g > rhs", "overconsistent"},
    {"under", "underconsistent"},
    {"g < rhs", "underconsistent"},
    {"RAISE", "raise"},
    {"LOWER", "lower"},
    {"back-pointer", "b"},
    {"consistency", "state"},
    {"last expansion", "order"},
    {"last exp.", "order"},
    {"expanded", "times"},
    {"local parent", "lp"},
    {"remote parent", "rp"},
    {"path", "plan"},
    {"range", "clearance-range"},
    {"transform", "distance-transform"},
    {"remote_parents", "rp"},
    {"sight_checks", "sight-checks"},
    {"start", "s_start"},
    {"last", "s_last"},
    {"line", "code-line"},
    {"queue operations", "queue-operations"},
    {"sight checks", "sight-checks"},
    {"least clearance", "min-clearance"},
    {"mean clearance", "mean-clearance"},
    {"least clearance of the edge", "edge-clearance"},
    {"mean clearance of the edge", "edge-clearance"},
    {"first plan", "plan-ms"},
    {"path length", "length"},
    {"vertex", "cell"},
    {"samples", "sample"},
    {"sampled", "sample"},
    {"hung on it", "rewired"},
    {"informed set", "ellipse"},
    {"children", "child"},
    {"generations", "generation"},
};

/// Whether the text has the words in it, in capitals or not.
bool contains(std::string_view text, std::string_view words) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return std::search(text.begin(), text.end(), words.begin(), words.end(), same) != text.end() ||
         words.empty();
}

}  // namespace

std::span<const GlossaryTerm> glossary() {
  return kTerms;
}

const GlossaryTerm* find_term(std::string_view id) {
  for (const Alias& alias : kAliases)
    if (alias.written == id) id = alias.id;
  const auto* const found = std::find_if(std::begin(kTerms), std::end(kTerms),
                                         [&](const GlossaryTerm& term) { return term.id == id; });
  return found == std::end(kTerms) ? nullptr : found;
}

std::vector<const GlossaryTerm*> search_glossary(std::string_view typed) {
  const GlossaryTerm* const named = find_term(typed);
  std::vector<const GlossaryTerm*> found;
  if (named != nullptr) found.push_back(named);
  for (const bool in_title : {true, false})
    for (const GlossaryTerm& term : kTerms)
      if (&term != named && contains(term.title, typed) == in_title &&
          (in_title || contains(term.text, typed)))
        found.push_back(&term);
  return found;
}

}  // namespace replan
