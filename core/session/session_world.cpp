// The session's edits of the world as a whole, and of what is to happen in it.
#include <algorithm>

#include "core/base/words.hpp"
#include "core/lattice/box_words.hpp"
#include "core/session/session.hpp"
#include "core/world/ends.hpp"
#include "core/world/generators/list.hpp"

namespace replan {
namespace {

Result<void> check_surprise(const Surprise& surprise, const GridMap& map) {
  if (surprise.at.move.has_value() == surprise.at.near.has_value())
    return Error{"say when the surprise happens: at a step, or near a place"};
  if (surprise.at.move && *surprise.at.move < 0) return Error{"the steps of the robot count from 0"};
  if (surprise.at.near && (!map.contains(*surprise.at.near) || !(surprise.at.within >= 0)))
    return Error{"the place that sets off a surprise must lie on the map, with a radius from 0"};
  for (const CellChange& change : surprise.cells)
    if (!map.contains(change.cell))
      return Error{"cell " + cell_text(change.cell, map.box().solid()) + " lies outside the world"};
  if (surprise.cells.empty() && !surprise.goal && !surprise.robot)
    return Error{"the surprise would change nothing: give at least one cell"};
  return {};
}

const char* turn_text(Turn turn) {
  switch (turn) {
    case Turn::left:
      return "turn the world left";
    case Turn::right:
      return "turn the world right";
    case Turn::left_right:
      return "mirror the world left to right";
    case Turn::top_bottom:
      return "mirror the world top to bottom";
  }
  return "";
}

}  // namespace

GridMap Session::world() const {
  GridMap map = scenario_->map;
  const SearchState& state = run().timeline().state();
  if (run().decision_at(run().timeline().cursor()) == nullptr) return map;
  for (std::size_t i = 0; i < map.blocked.size(); ++i) {
    const bool wall = state.wall(static_cast<NodeId>(i));
    if (wall != (map.blocked[i] != kFree)) map.blocked[i] = wall ? kObstacle : kFree;
  }
  return map;
}

/// A change of what is to happen later: what lies before it is the same run still, so the cursor stays. If
/// the runs have to start afresh they go to where the robot was.
void Session::commit_in_place(std::string label, Scenario changed, std::size_t scripted) {
  const std::size_t cursor = run().timeline().cursor();
  const bool follow = follow_;
  const Decision* decision = run().decision_at(cursor);
  const std::int64_t clock = decision == nullptr ? 0 : decision->clock;
  commit(std::move(label), 0, std::move(changed), scripted);
  if (!run().decisions().empty() && run().timeline().size() >= cursor) {
    if (follow) return;  // it stood at the end, and still does
    seek(cursor);
    follow_ = false;
  } else if (clock > 0) {
    for (const auto& each : runs_) each->go(Target::clock_at(clock));
  }
}

Result<void> Session::run_command(const ScheduleSurprise& command) {
  if (const auto good = check_surprise(command.surprise, scenario_->map); !good) return good;
  Scenario changed = *scenario_;
  Surprise& surprise = changed.surprises.push_back(command.surprise);
  std::sort(surprise.cells.begin(), surprise.cells.end(),
            [](const CellChange& a, const CellChange& b) { return in_node_order(a.cell, b.cell); });
  const std::string when = surprise.at.move ? "at step " + std::to_string(*surprise.at.move)
                                            : "near " + cell_text(*surprise.at.near, box().solid());
  commit_in_place("schedule a surprise " + when, std::move(changed), scripted());
  return {};
}

Result<void> Session::run_command(const RemoveSurprise& command) {
  if (command.index >= scenario_->surprises.size()) return Error{"there is no such surprise"};
  Scenario changed = *scenario_;
  changed.surprises.erase(command.index);
  commit_in_place("remove a surprise", std::move(changed),
                  command.index < scripted() ? scripted() - 1 : scripted());
  return {};
}

Result<void> Session::run_command(const TurnWorld& command) {
  commit(turn_text(command.turn), 0, turned(tidied(), command.turn));
  return {};
}

Result<void> Session::run_command(const ResizeWorld& command) {
  const GridMap& map = scenario_->map;
  if (command.size.width == map.width && command.size.height == map.height) return {};
  Result<Resized> done = resized(tidied(), command.size);
  if (!done) return Error{done.error()};
  const auto lost = std::count_if(done->surprises_lost.begin(), done->surprises_lost.end(),
                                  [this](std::size_t index) { return index < scripted(); });
  commit("resize to " + sides_text(done->scenario.map.box()), 0, std::move(done->scenario),
         scripted() - static_cast<std::size_t>(lost));
  if (done->ends_moved) say("the start or the goal lay outside and moved to the nearest cell inside");
  if (done->cells_lost > 0)
    say(counted(done->cells_lost, "cell") + " of surprises lay outside and " +
        (done->cells_lost == 1 ? "is" : "are") + " gone");
  return {};
}

Result<void> Session::run_command(const InvertWorld&) {
  std::vector<Cell> keep = {scenario_->start, scenario_->goal};
  const NodeId robot = run().timeline().state().node(Scalar::robot);
  if (robot != kNoNode) keep.push_back(run().lattice().position(robot));
  return edit_cells(inversion(world(), keep), true, 0, "invert the world");
}

Result<void> Session::run_command(const ClearWorld&) {
  std::vector<CellChange> cells;
  const GridMap now = world();
  for (NodeId node = 0; node < now.blocked.size(); ++node)
    if (now.blocked[node] != kFree) cells.push_back({now.box().position(node), false});
  return edit_cells(cells, true, 0, "clear the world");
}

/// What the old world was called, and what it was about, is not said of the new one.
Result<void> Session::replace_map(std::string label, std::string name, GridMap map, std::optional<Cell> start,
                                  std::optional<Cell> goal) {
  if (map.blocked.empty()) return Error{"a world has at least one cell"};
  for (const auto& end : {start, goal})
    if (end && !map.contains(*end)) return Error{"start and goal must lie on the map"};
  Scenario changed = *scenario_;
  changed.map = std::move(map);
  changed.map_file.clear();
  changed.map_found = {};
  changed.name = std::move(name);
  changed.caption.clear();
  changed.surprises.clear();
  changed.movers.clear();
  changed.view.camera.reset();
  changed.start = {0, 0};
  changed.goal = {changed.map.width - 1, changed.map.height - 1, changed.map.depth - 1};
  place_ends(changed);
  changed.start = start.value_or(changed.start);
  changed.goal = goal.value_or(changed.goal);
  player_.stop();
  commit(std::move(label), 0, std::move(changed), 0);
  return {};
}

Result<void> Session::run_command(const ReplaceMap& command) {
  return replace_map("put in a map of " + sides_text(command.map.box()), "", command.map, command.start,
                     command.goal);
}

Result<void> Session::run_command(const GenerateWorld& command) {
  const auto info = require_generator(command.generator);
  if (!info) return Error{info.error()};
  Result<GridMap> map =
      generate(command.generator, command.settings, command.width, command.height, command.seed);
  if (!map) return Error{map.error()};
  const std::string size = sides_text(map->box());
  return replace_map(
      "generate " + std::string((*info)->id) + " of " + size + ", seed " + std::to_string(command.seed),
      std::string((*info)->name) + ", " + size, *std::move(map), std::nullopt, std::nullopt);
}

}  // namespace replan
