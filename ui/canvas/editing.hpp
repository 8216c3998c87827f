// What is selected for editing, and how it is drawn; no part of the document. What a tool alone remembers is its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/cell.hpp"

namespace replan::ui {

/// What the stroke under way does.
enum class StrokeKind : std::uint8_t {
  none,
  paints,
  erases,
  erases_wall,  ///< because it began on an obstacle
};

struct Editing {
  bool round = false;             ///< the brush
  std::optional<CellBox> region;  ///< selected cells
  // Numbers in the scenario; at most one is selected.
  std::optional<std::size_t> mover;
  std::optional<std::size_t> surprise;
  StrokeKind stroke = StrokeKind::none;
};

/// Selects cells, and nothing else.
inline void select_region(Editing& editing, const CellBox& region) {
  editing.region = region;
  editing.mover.reset();
  editing.surprise.reset();
}

}  // namespace replan::ui
