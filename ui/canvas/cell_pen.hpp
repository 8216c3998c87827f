// Draws over the canvas in cells: what tools show while they are at work.
#pragma once

#include <span>
#include <vector>

#include "core/world/brush.hpp"
#include "ui/canvas/draw.hpp"
#include "ui/canvas/editing.hpp"

namespace replan::ui {

class CellPen {
 public:
  CellPen(const Look& look, ImDrawList& list, const Projection& screen, const Run& run, const Sheet& sheet)
      : look_(look), list_(list), screen_(screen), run_(run), sheet_(sheet) {}

  /// Fills spans and draws the line around all of them; rows must be in order, one span each. `fill` is the opacity.
  void area(std::span<const CellSpan> spans, ImU32 colour, float fill) const;
  /// What of the spans lies in the world. Spans are in columns and rows, cells and boxes are the world's.
  [[nodiscard]] std::vector<CellSpan> inside(std::span<const CellSpan> spans) const;
  void dashed(ImVec2 a, ImVec2 b, ImU32 colour) const;
  void dashed_frame(const CellBox& box, ImU32 colour) const;
  void fill(const CellBox& box, ImU32 colour) const;
  [[nodiscard]] ImVec2 middle(Cell cell) const { return screen_(centre_of(sheet_.box.seen(cell))); }
  /// Whether the pane shows a part of it, and not only what lies before or behind.
  [[nodiscard]] bool meets(const CellBox& box) const;

  [[nodiscard]] const Look& look() const { return look_; }
  [[nodiscard]] ImDrawList& list() const { return list_; }
  [[nodiscard]] const GridMap& map() const { return run_.scenario().map; }
  /// The run of the pane that is drawn in.
  [[nodiscard]] const Run& run() const { return run_; }
  [[nodiscard]] const Sheet& sheet() const { return sheet_; }

 private:
  /// The upper left corner of a column and a row, on whole pixels.
  [[nodiscard]] ImVec2 at(int column, int row) const;
  [[nodiscard]] CellBox seen(const CellBox& box) const {
    return box_of(sheet_.box.seen(box.low), sheet_.box.seen(box.high));
  }
  void side(ImVec2 a, ImVec2 b, ImU32 colour) const { list_.AddLine(a, b, colour, look_.px(1.5f)); }
  void edge_towards(const CellSpan& span, const CellSpan* next, float y, ImU32 colour) const;

  const Look& look_;
  ImDrawList& list_;
  const Projection& screen_;
  const Run& run_;
  const Sheet sheet_;
};

}  // namespace replan::ui
