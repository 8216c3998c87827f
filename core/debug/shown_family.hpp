// A point of a search among the others as views show it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/point.hpp"
#include "core/debug/cell_set.hpp"

namespace replan {

/// What the point hangs on, and what hangs on it; by the coordinates of the world.
struct ShownFamily {
  std::uint64_t log_id = 0;  ///< of the run that it is of
  std::vector<Point> way;    ///< from the point along its parents, as far as they lead
  /// The cells of all points whose parents lead over it, its own left out; nullptr while they are not known.
  std::shared_ptr<const CellSet> below;
};

}  // namespace replan
