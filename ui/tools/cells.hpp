// What tools ask of the world, and what they write into it.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "ui/tools/tool.hpp"

namespace replan::ui {

/// The nearest cell of the world.
Cell clamped(const Box& lattice, Cell cell);
/// An obstacle in the true world at the playhead.
bool is_wall(const Run& run, Cell cell);
/// Where the goal stands at the playhead.
Cell goal_cell(const Run& run);
Cell robot_cell(const Run& run);
/// Rows of the brush with its middle at a cell, of a straight stroke and of a rectangle between two, on a sheet.
std::vector<CellSpan> brush_on(const Sheet& sheet, const ViewState& view, Cell at);
std::vector<CellSpan> stroke_on(const Sheet& sheet, const ViewState& view, Cell from, Cell to);
std::vector<CellSpan> rectangle_on(const Sheet& sheet, Cell a, Cell b);
/// What of a rectangle lies in the world, if anything.
std::optional<CellBox> in_world(const Box& lattice, const CellBox& all);

/// Of the spans, on the press's sheet and as many layers behind it as the tools draw, the cells that lie in the world and
/// would change by the press. Start and goal keep standing on free
/// ground while others are painted around them. What is painted over the robot's own cell is there as it would be by a
/// script: RobotSetup::robot_cell_blocks says what it does. If there are more than `enough`, some of them, but more
/// than that.
std::vector<CellChange> changes(const ToolContext& context, std::span<const CellSpan> spans,
                                std::size_t enough = SIZE_MAX);
/// Queues them as one edit, if there are any.
void paint(ToolContext& context, std::vector<CellChange> cells);
/// Queues all that `spans` cover in those layers as one edit, however much that is.
void paint(ToolContext& context, const std::vector<CellSpan>& spans);

/// A shape between two cells, which is painted when the button is let go.
class ShapeDrag : public Drag {
 public:
  using Shape = std::vector<CellSpan> (*)(const Press& press, const ViewState& view);
  explicit ShapeDrag(Shape shape) : shape_(shape) {}

  void end(ToolContext& context) override;
  [[nodiscard]] CellPreview preview(const Press& press, const ViewState& view) const override;
  [[nodiscard]] bool draws() const override { return true; }
  [[nodiscard]] bool leaves_world() const override { return true; }

 protected:
  [[nodiscard]] std::vector<CellSpan> spans(const ToolContext& context) const;

 private:
  Shape shape_;
};

/// A stroke of the brush, which paints or erases under the mouse.
std::unique_ptr<Drag> brush_drag();

/// A tool that draws obstacles: its right button erases them, with the brush if the tool has no other way.
class DrawingTool : public Tool {
 public:
  std::unique_ptr<Drag> press_right(ToolContext&) override { return brush_drag(); }
};

}  // namespace replan::ui
