// What the tools draw over the canvas while they are at work: the cells that would be written, the selected
// region, a measured distance, a way in the making.
#pragma once

#include <optional>
#include <vector>

#include "core/world/brush.hpp"
#include "ui/canvas/canvas.hpp"
#include "ui/canvas/draw.hpp"

namespace replan::ui {

/// What the hand is about to write.
struct ToolPreview {
  std::vector<CellSpan> cells;
  bool adds = false;            ///< obstacles
  bool drawing = false;         ///< a button is held
  std::optional<Cell> hovered;  ///< nothing while something is held
};

void draw_tool_overlay(const Look& look, ImDrawList& list, const Projection& screen, const ViewState& state,
                       const GridMap& map, const ToolPreview& preview);

/// The figures of a measured distance.
struct MeasureFigures {
  int dx = 0, dy = 0;   ///< cells; y down
  double straight = 0;  ///< cells, centre to centre
  double octile = 0;    ///< cells, over the edges of an 8-connected grid
  double degrees = 0;   ///< against the clock from the right, 0 to 360
};
MeasureFigures measured(const Measure& measure);
/// "12.8 cells · 0.64 m · octile 13.7 · dx 12, dy -4 · 18.4°"; metres where a cell has a length of its own.
std::string measure_text(const MeasureFigures& figures, double resolution);

}  // namespace replan::ui
