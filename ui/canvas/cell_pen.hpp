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
  CellPen(const Look& look, ImDrawList& list, const Projection& screen, const Run& run)
      : look_(look), list_(list), screen_(screen), run_(run) {}

  /// Fills spans and draws the line around all of them; rows must be in order, one span each. `fill` is the opacity.
  void area(std::span<const CellSpan> spans, ImU32 colour, float fill) const;
  /// What of the spans lies in the world.
  [[nodiscard]] std::vector<CellSpan> inside(std::span<const CellSpan> spans) const;
  void dashed(ImVec2 a, ImVec2 b, ImU32 colour) const;
  void dashed_frame(const CellRect& rect, ImU32 colour) const;
  /// The upper left corner of a cell, on whole pixels.
  [[nodiscard]] ImVec2 at(int x, int y) const;
  [[nodiscard]] ImVec2 middle(Cell cell) const { return screen_({cell.x + 0.5, cell.y + 0.5}); }

  [[nodiscard]] const Look& look() const { return look_; }
  [[nodiscard]] ImDrawList& list() const { return list_; }
  [[nodiscard]] const GridMap& map() const { return run_.scenario().map; }
  /// The run of the pane that is drawn in.
  [[nodiscard]] const Run& run() const { return run_; }

 private:
  void side(ImVec2 a, ImVec2 b, ImU32 colour) const { list_.AddLine(a, b, colour, look_.px(1.5f)); }
  void edge_towards(const CellSpan& span, const CellSpan* next, float y, ImU32 colour) const;

  const Look& look_;
  ImDrawList& list_;
  const Projection& screen_;
  const Run& run_;
};

}  // namespace replan::ui
