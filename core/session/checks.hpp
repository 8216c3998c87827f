// What the session holds its planners to: their own laws, and the oracle's word on each plan.
#pragma once

#include <cstddef>
#include <optional>

#include "core/debug/difference.hpp"
#include "core/debug/laws.hpp"
#include "core/debug/oracle.hpp"

namespace replan {

/// Read by panels; changed by the session's commands and update() alone.
class Checks {
 public:
  [[nodiscard]] LawReport laws(std::size_t pane) const;
  [[nodiscard]] OracleReport oracle(std::size_t pane) const;
  /// What the last FindDifference came to; nothing if the two were found to be alike, or none was asked for.
  [[nodiscard]] const std::optional<Difference>& difference() const { return difference_; }
  /// While two runs are still being compared.
  [[nodiscard]] bool comparing() const { return comparing_; }

 private:
  std::optional<Difference> difference_;
  bool comparing_ = false;
};

}  // namespace replan
