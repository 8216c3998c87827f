// Edits of what happens on the way: the robot and its goal put elsewhere, obstacles that move.
#include <utility>

#include "core/session/session.hpp"

namespace replan {
namespace {

Result<void> check_mover(const MovingObstacle& mover, const GridMap& map) {
  if (mover.way.empty()) return Error{"a moving obstacle needs a way: draw at least one cell of it"};
  for (const Cell corner : mover.way)
    if (!map.contains(corner)) return Error{"the way of a moving obstacle must lie on the map"};
  if (mover.width < 1 || mover.height < 1 || mover.width > kMaxMoverSide || mover.height > kMaxMoverSide)
    return Error{"a moving obstacle has from 1 to " + std::to_string(kMaxMoverSide) + " cells each way"};
  if (!(mover.speed >= kMinSpeed && mover.speed <= kMaxSpeed))
    return Error{"a moving obstacle's speed lies between 0.01 and 1000 cells per second"};
  return {};
}

}  // namespace

/// Something that happens to the robot or its goal at its present step. Of a drag only the end counts.
Result<void> Session::edit_script(std::string label, std::uint64_t stroke, Surprise surprise) {
  Scenario changed = *scenario_;
  const bool same_drag = history_.goes_on(stroke);
  if (same_drag && !changed.surprises.empty()) {
    surprise.at.move = changed.surprises.back().at.move;
    changed.surprises.pop_back();
  } else {
    surprise.at.move = run().decision_for_edit()->clock;
  }
  changed.surprises.push_back(std::move(surprise));
  commit(std::move(label), stroke, std::move(changed));
  return {};
}

/// Whether the robot has set out at the cursor: what is moved now is moved on the way.
bool Session::under_way() const {
  const Decision* decision = run().decision_for_edit();
  return decision != nullptr && decision->clock > 0;
}

Result<void> Session::run_command(const SetStart& command) {
  if (!scenario_->map.contains(command.cell)) return Error{"the start must lie on the map"};
  if (command.cell == scenario_->start) return {};
  Scenario changed = tidied(*scenario_, scripted());
  changed.start = command.cell;
  commit("move the start", command.stroke, std::move(changed));
  return {};
}

Result<void> Session::run_command(const SetGoal& command) {
  if (!scenario_->map.contains(command.cell)) return Error{"the goal must lie on the map"};
  if (under_way()) {
    Surprise surprise;
    surprise.goal = command.cell;
    if (run().timeline().state().wanted_goal() == run().lattice().node(command.cell)) return {};
    return edit_script("move the goal on the way: a fresh plan from where the robot is", command.stroke,
                       std::move(surprise));
  }
  if (command.cell == scenario_->goal) return {};
  Scenario changed = tidied(*scenario_, scripted());
  changed.goal = command.cell;
  commit("move the goal", command.stroke, std::move(changed));
  return {};
}

Result<void> Session::run_command(const PutRobot& command) {
  if (!scenario_->map.contains(command.cell)) return Error{"the robot must stand on the map"};
  if (!under_way()) return run_command(SetStart{command.cell, command.stroke});
  if (run().timeline().state().node(Scalar::robot) == run().lattice().node(command.cell)) return {};
  Surprise surprise;
  surprise.robot = command.cell;
  return edit_script("put the robot elsewhere", command.stroke, std::move(surprise));
}

/// Moving obstacles belong to a run from its beginning, so the runs start afresh and go to where the robot
/// was.
void Session::commit_movers(std::string label, std::uint64_t stroke, std::vector<MovingObstacle> movers) {
  const Decision* decision = run().decision_at(run().timeline().cursor());
  const std::int64_t clock = decision == nullptr ? 0 : decision->clock;
  Scenario changed = *scenario_;
  changed.movers = std::move(movers);
  commit(std::move(label), stroke, std::move(changed));
  if (clock > 0)
    for (const auto& each : runs_) each->go(Target::clock_at(clock));
}

Result<void> Session::run_command(const AddMover& command) {
  if (const auto good = check_mover(command.mover, scenario_->map); !good) return good;
  std::vector<MovingObstacle> movers = scenario_->movers;
  if (movers.size() >= kMaxMovers)
    return Error{"there are " + std::to_string(kMaxMovers) +
                 " moving obstacles already, the most there can be"};
  movers.push_back(command.mover);
  if (const Decision* decision = run().decision_at(run().timeline().cursor()))
    movers.back().from = decision->clock;
  commit_movers("add a moving obstacle", 0, std::move(movers));
  return {};
}

Result<void> Session::run_command(const ChangeMover& command) {
  if (const auto good = check_mover(command.mover, scenario_->map); !good) return good;
  std::vector<MovingObstacle> movers = scenario_->movers;
  if (command.index >= movers.size()) return Error{"there is no such moving obstacle"};
  if (movers[command.index] == command.mover) return {};
  movers[command.index] = command.mover;
  commit_movers("change a moving obstacle", command.stroke, std::move(movers));
  return {};
}

Result<void> Session::run_command(const RemoveMover& command) {
  std::vector<MovingObstacle> movers = scenario_->movers;
  if (command.index >= movers.size()) return Error{"there is no such moving obstacle"};
  movers.erase(movers.begin() + static_cast<std::ptrdiff_t>(command.index));
  commit_movers("remove a moving obstacle", 0, std::move(movers));
  return {};
}

}  // namespace replan
