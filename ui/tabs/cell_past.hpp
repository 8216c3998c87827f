// What happened to a cell's values over the whole run: part of the Cell tab.
#pragma once

#include <optional>

#include "core/debug/cell_history.hpp"
#include "ui/shell/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

struct CellPast {
  CellHistory history;
  RowScroll rows;
  std::optional<std::size_t> shown_cursor;  ///< to which the list was scrolled; nothing: not yet
  bool every_value = false;                 ///< parents, keys and the map too, not g, rhs and dist alone

  /// In the current window.
  void draw(Frame& frame, Cell cell);
  /// The same of a vertex of a tree.
  void draw_vertex(Frame& frame, std::uint32_t vertex);

 private:
  void draw_rows(Frame& frame);
};

}  // namespace replan::ui
