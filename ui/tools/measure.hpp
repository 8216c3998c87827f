// The tool that measures a distance.
#pragma once

#include <optional>
#include <string>

#include "ui/tools/tool.hpp"

namespace replan::ui {

/// A distance between two cells.
struct Measure {
  Cell from, to;
  friend bool operator==(const Measure&, const Measure&) = default;
};

class MeasureTool final : public Tool {
 public:
  std::unique_ptr<Drag> press(ToolContext& context) override;
  [[nodiscard]] bool grabs() const override { return false; }
  void draw(const CellPen& pen, const ViewState& view, std::optional<Cell> hovered) const override;
  [[nodiscard]] bool holds() const override { return measure_.has_value(); }
  void drop() override { measure_.reset(); }

  [[nodiscard]] const std::optional<Measure>& measure() const { return measure_; }

 private:
  std::optional<Measure> measure_;  // the latest; a click takes it away
};

/// The figures of a measured distance.
struct MeasureFigures {
  int dx = 0, dy = 0, dz = 0;  ///< cells; y down
  double straight = 0;         ///< cells, centre to centre
  double octile = 0;           ///< cells, over the edges of a grid with all its diagonals
  double degrees = 0;          ///< within its layer, against the clock from the right, 0 to 360
};
MeasureFigures measured(const Measure& measure);
/// "12.8 cells · 0.64 m · octile 13.7 · dx 12, dy -4 · 18.4°"; metres where a cell has a length of its own. In
/// a `solid` world dz stands in the place of the angle.
std::string measure_text(const MeasureFigures& figures, double resolution, bool solid = false);

}  // namespace replan::ui
