// The oracle's word on plans: what each costs by plain Dijkstra on the map as the robot knows it.
#pragma once

#include <cstddef>
#include <optional>

#include "core/base/cost.hpp"

namespace replan {

/// A plan that does not cost what it should.
struct Disagreement {
  std::size_t plan = 0;      ///< how many plans came before it; 0 is the first
  std::size_t position = 0;  ///< of the log: where the plan stands
  Cost claimed;              ///< by the planner
  Cost right;                ///< by the oracle
};

struct OracleReport {
  bool on = false;
  bool exact = true;  ///< false: with these settings the planner does not promise a cheapest plan, only one
  std::size_t asked = 0;  ///< plans that were compared
  bool busy = false;      ///< more are being worked out
  std::size_t disagreements = 0;
  std::optional<Disagreement> first;
};

}  // namespace replan
