// What is drawn over a scene while it is edited: the selected region, the cells that would be written, and what the tool
// shows besides.
#pragma once

#include <optional>

#include "ui/canvas/cell_pen.hpp"
#include "ui/canvas/view_state.hpp"

namespace replan::ui {

/// `hovered`: the cell under the cursor; nothing while something is held.
void draw_editing(const CellPen& pen, const ViewState& state, const CellPreview& preview,
                  std::optional<Cell> hovered);

}  // namespace replan::ui
