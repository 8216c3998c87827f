// The session's edits of the world as a whole, and of what is to happen in it.
#include <algorithm>

#include "core/base/words.hpp"
#include "core/lattice/box_words.hpp"
#include "core/session/session.hpp"

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

/// Of sides that may be wrong still.
std::size_t cells_of(int width, int height, int depth) {
  const auto side = [](int length) { return static_cast<std::size_t>(std::max(length, 0)); };
  return side(width) * side(height) * side(depth);
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

/// At once, or beside the session where that takes long and nobody has to wait for it. Whatever is asked for meanwhile
/// comes after it.
template <class WorldCommand>
Result<void> Session::edit_world(const WorldCommand& command, std::size_t cells) {
  // An edit cannot be cut up: in step a window stands still for as long as the world is large.
  auto job = [before = scenario_, scripted = scripted(), command](const StopToken&) {
    Result<WorldEdit> edit = edited(tidied(*before, scripted), scripted, command);
    if (edit) edit->change = change_between(*before, edit->scenario);
    return edit;
  };
  if (!patience_ || std::max(cells, box().node_count()) <= kLargeWorld) return take_edit(job({}));
  world_edit_.start(std::move(job));
  return {};
}

Result<void> Session::take_edit(Result<WorldEdit> edit) {
  if (!edit) return Error{edit.error()};
  commit(std::move(edit->label), 0, std::move(edit->scenario), std::move(edit->change), edit->scripted);
  for (std::string& note : edit->notes) say(std::move(note));
  return {};
}

/// Takes over what was worked out, and carries out what had to wait for it.
bool Session::finish_world_edit() {
  auto edit = world_edit_.take();
  if (!edit) return false;
  const auto note = [this](const Result<void>& done) {
    if (!done) notice_ = {done.error(), true};
  };
  const Result<void> done = take_edit(std::move(*edit));
  if (!done) say(done.error());
  note(done);
  for (std::vector<Command> waiting = std::exchange(waiting_, {}); const Command& command : waiting)
    note(apply(command));
  return true;
}

/// Whether a command has to wait until the world is what it is going to be.
bool Session::has_to_wait(const Command& command) {
  if (!world_edit_.busy()) return false;
  const bool gives_up =
      std::holds_alternative<Cancel>(command) || std::holds_alternative<ReplaceScenario>(command);
  if (!gives_up) {
    waiting_.push_back(command);
    return true;
  }
  world_edit_.cancel();
  waiting_.clear();
  return false;
}

Result<void> Session::run_command(const PaintCells& command) {
  if (command.cells.size() > kLargeWorld) return edit_world(command);
  return edit_cells(command.cells, true, command.stroke);
}

Result<void> Session::run_command(const PaintBoxes& command) {
  return edit_world(command);
}

Result<void> Session::run_command(const FillRegion& command) {
  return edit_world(command);
}

Result<void> Session::run_command(const TurnWorld& command) {
  return edit_world(command);
}

Result<void> Session::run_command(const ResizeWorld& command) {
  const GridMap& map = scenario_->map;
  const NewSize& size = command.size;
  if (size.width == map.width && size.height == map.height && size.depth == map.depth) return {};
  return edit_world(command, cells_of(size.width, size.height, size.depth));
}

Result<void> Session::run_command(const InvertWorld& command) {
  if (box().node_count() > kLargeWorld) return edit_world(command);
  std::vector<Cell> keep = {scenario_->start, scenario_->goal};
  const NodeId robot = run().timeline().state().node(Scalar::robot);
  if (robot != kNoNode) keep.push_back(run().lattice().position(robot));
  return edit_cells(inversion(world(), keep), true, 0, "invert the world");
}

Result<void> Session::run_command(const ClearWorld& command) {
  if (box().node_count() > kLargeWorld) return edit_world(command);
  std::vector<CellChange> cells;
  const GridMap now = world();
  for (NodeId node = 0; node < now.blocked.size(); ++node)
    if (now.blocked[node] != kFree) cells.push_back({now.box().position(node), false});
  return edit_cells(cells, true, 0, "clear the world");
}

Result<void> Session::run_command(const ReplaceMap& command) {
  player_.stop();
  return edit_world(command, command.map.box().node_count());
}

Result<void> Session::run_command(const GenerateWorld& command) {
  player_.stop();
  return edit_world(command, cells_of(command.width, command.height, command.layers));
}

}  // namespace replan
