// The names of the condition language, with what help says of them.
#include "core/debug/condition.hpp"

namespace replan {

std::span<const ConditionName> condition_names() {
  using enum ValueType;
  static constexpr ConditionName kNames[] = {
      {Op::g, number, "g", "g(x, y)", "The cell's cost to the goal (A*: from the start), as settled last."},
      {Op::rhs, number, "rhs", "rhs(x, y)", "The cell's one-step lookahead of g. A* has none: inf."},
      {Op::dist, number, "dist", "dist(x, y)", "The cell's clearance penalty."},
      {Op::k1, number, "k1", "k1(x, y)", "First part of the cell's key in the open list U; inf outside it."},
      {Op::k2, number, "k2", "k2(x, y)", "Second part of the key, min(g, rhs); inf outside U."},
      {Op::order, number, "order", "order(x, y)",
       "Number of the cell's latest expansion since its search began; 0 if never expanded."},
      {Op::times, number, "times", "times(x, y)", "How often the cell was expanded."},
      {Op::lp, cell, "lp", "lp(x, y)", "The cell's local parent, a cell or none."},
      {Op::rp, cell, "rp", "rp(x, y)", "The cell's remote parent, a cell or none."},
      {Op::queued, truth, "queued", "queued(x, y)", "The cell is in the open list U."},
      {Op::known, truth, "known", "known(x, y)", "The cell is an obstacle on the robot's map."},
      {Op::wall, truth, "wall", "wall(x, y)", "A wall stands there in the world, known or not."},
      {Op::consistent, truth, "consistent", "consistent(x, y)", "The cell has g = rhs. With A* all have."},
      {Op::km, number, "km", "km", "What moves of the robot have added to new keys."},
      {Op::queue_size, number, "size", "size(U)", "How many cells the open list U holds."},
      {Op::moves, number, "moves", "moves",
       "The robot's clock: its moves, turns on the spot and waits so far."},
      {Op::replans, number, "replans", "replans", "How often it has replanned."},
      {Op::expansions, number, "expansions", "expansions", "Expansions so far, all plans together."},
      {Op::samples, number, "samples", "samples",
       "Samples drawn so far, all plans together: the expansions of a planner that grows a tree of them; 0 "
       "of others."},
      {Op::robot, cell, "robot", "robot", "Where the robot stands."},
      {Op::start, cell, "start", "start", "Where the present search plans from, s_start."},
      {Op::goal, cell, "goal", "goal", "Where it plans to, s_goal."},
      {Op::last, cell, "last", "last", "Where the robot was when km was raised last, s_last."},
      {Op::sub_goal, cell, "sub_goal", "sub_goal", "The cell of its plan that a driving robot makes for."},
      {Op::admissible, number, "admissible", "admissible",
       "Of the arcs that a driving robot tried last, how many it may take; inf before the first decision."},
      {Op::score, number, "score", "score(winner)",
       "The score of the arc that a driving robot chose last; inf where it chose none."},
      {Op::best, number, "best", "best",
       "What the best path costs that a tree of samples, or a population, has so far; inf before the first."},
      {Op::vertices, number, "vertices", "vertices",
       "How many vertices a tree of samples has, those that were cut off among them."},
      {Op::generation, number, "generation", "generation",
       "How many generations of paths have been bred since the planner last began anew."},
      {Op::line, number, "line", "line",
       "The pseudo-code line that the run stands on; lines of Algorithm 1 have 100 added."},
      {Op::on_line, truth, "line", "line(n)", "The run stands on that pseudo-code line."},
      {Op::taken, truth, "taken", "taken(x, y)", "The cell is taken from the open list U, now."},
      {Op::taken_any, truth, "taken", "taken", "Some cell is taken from the open list U, now."},
      {Op::rewired, truth, "rewired", "rewired(v)",
       "That vertex of a tree is hung on another one, which makes the way to it shorter."},
      {Op::changed, truth, "changed", "changed(value)",
       "The value is written and becomes another, now: changed(g(3, 4)), changed(km)."},
      {Op::event, truth, "event", "event(name)", "Something happens, now; the names are below."},
  };
  return kNames;
}

std::string form_text(std::string_view form, bool solid) {
  constexpr std::string_view kPlane = "x, y";
  std::string text(form);
  if (const std::size_t at = text.find(kPlane); solid && at != std::string::npos)
    text.replace(at, kPlane.size(), "x, y, z");
  return text;
}

std::span<const HappeningName> happening_names() {
  static constexpr HappeningName kHappenings[] = {
      {Happening::plan, "plan", "A first plan begins."},
      {Happening::replan, "replan", "A replan begins."},
      {Happening::underconsistent, "underconsistent", "A cell with g < rhs is taken from U."},
      {Happening::sight_failed, "sight_failed", "A line of sight turns out to be blocked."},
      {Happening::first_path, "first_path",
       "A tree of samples, or a population, has a path where it had none."},
      {Happening::rewired, "rewired",
       "A vertex of a tree is hung on another one, which makes the way to it shorter."},
      {Happening::no_path, "no_path", "A plan ends without a path."},
      {Happening::blocked, "blocked",
       "The robot cannot go on: it waits without a path, would run into an obstacle, or gives up."},
      {Happening::surprise, "surprise", "The world changes, by script or by hand."},
      {Happening::move, "move", "The robot enters a cell."},
      {Happening::arrival, "arrival", "The robot arrives at the goal."},
      {Happening::invariant, "invariant", "A law that the planner must keep is broken, if laws are checked."},
      {Happening::oracle, "oracle", "The oracle disagrees with a plan's cost, if it is asked."},
  };
  return kHappenings;
}

}  // namespace replan
