// The numbers in cells: which of them stand where. Each zoom has one layout, and none is half there.
#pragma once

#include "core/scene/context.hpp"

namespace replan {

/// Design pixels a cell from which on the numbers of all cells show.
inline constexpr double kNumbersFrom = 40;

/// Whether the search still has to deal with a cell: its two values differ, or, of a planner with one value alone, it is
/// in the open list.
bool waits(const SceneContext& context, NodeId node);
/// How opaque the ground is under the numbers of a cell that waits.
inline constexpr float kWaitingGround = 0.85f;

/// The numbers of a view, by its zoom and its overlays.
struct NumberLayout {
  explicit NumberLayout(const SceneContext& context);

  NumbersShown everywhere = NumbersShown::none;  ///< in all free cells
  NumbersShown waiting = NumbersShown::none;     ///< in cells that wait
  double apart = 0;    ///< of two lines: from the middle of the cell to the middle of each, in the world
  bool close = false;  ///< they leave no room in the middle of the cell

  [[nodiscard]] NumbersShown of(bool waits) const { return waits ? waiting : everywhere; }
};

/// Ground in the colour of its cell is laid under each of them, so that nothing runs through.
void build_numbers(SceneContext& context);

}  // namespace replan
