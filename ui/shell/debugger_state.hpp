// What the debugger's panels remember between frames; no part of the document.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "core/debug/cell_history.hpp"
#include "core/debug/open_order.hpp"
#include "core/debug/touched.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

struct DebuggerState {
  // Cell tab
  CellHistory history;
  RowScroll history_rows;
  std::optional<std::size_t> history_cursor;  ///< to which the list was scrolled; nothing: not yet
  int chosen_value = 0;                       ///< whose menu is open
  bool every_value = false;                   ///< parents, keys and the map too, not g, rhs and dist alone

  // Open list tab
  OpenOrder order;
  RowScroll order_rows;
  double order_seconds = 0;  ///< what sorting it anew took the last time
  double order_due = 0;      ///< not before this time (ImGui's) again while it plays
  bool repair = false;       ///< shows what the last replan touched instead
  TouchedList touched;
  RowScroll touched_rows;

  // Debug tab
  std::string breakpoint, watch;  ///< being typed
  std::array<int, 2> compared{0, 1};
  int compare = 1;  ///< a Compare

  bool menu_open = false;       ///< that of ViewState::menu
  std::optional<Cell> pointed;  ///< the cell of the row under the mouse, which the canvas shows as hovered
};

}  // namespace replan::ui
