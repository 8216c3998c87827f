// What the debugger's instruments read of a run.
#pragma once

#include "core/lattice/box.hpp"
#include "core/plan/parameters.hpp"
#include "core/plan/registry.hpp"
#include "core/trace/timeline.hpp"

namespace replan {

/// A log, and what its numbers mean. All of it outlives the view.
struct LogView {
  const Timeline& log;
  const Box& lattice;  ///< of the world
  const PlannerInfo& info;
  const Settings& settings;
  double radius = 0;  ///< of the robot
  [[nodiscard]] MoveRules rules() const { return move_rules(settings, radius); }
};

}  // namespace replan
