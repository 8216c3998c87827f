// What stands in the world and is moved by hand: with every tool the start, the goal and the robot.
#pragma once

#include <unordered_set>

#include "ui/tools/tool.hpp"

namespace replan::ui {

/// Something that goes where the mouse goes, cell by cell, once it has moved.
class HeldDrag : public Drag {
 public:
  void move(ToolContext& context) final;
  /// It was clicked, not moved: that is for the tool.
  void end(ToolContext& context) override;
  [[nodiscard]] bool holds() const final { return true; }

 private:
  virtual void put(ToolContext& context, Cell to) = 0;

  std::unordered_set<std::uint32_t> been_;  // nodes
};

std::unique_ptr<Drag> hold_start();
std::unique_ptr<Drag> hold_goal();
/// Shows where something would stand, in the tool's colour; over an obstacle, why it cannot.
void draw_ghost(const CellPen& pen, const ViewState& view, Cell at);

/// A tool that takes hold of one of them wherever it is pressed: a click puts it there.
template <std::unique_ptr<Drag> (*hold)()>
class HoldingTool final : public Tool {
  std::unique_ptr<Drag> press(ToolContext& context) override {
    context.press.moved = true;
    return hold();
  }
  void draw(const CellPen& pen, const ViewState& view, std::optional<Cell> hovered) const override {
    if (hovered) draw_ghost(pen, view, *hovered);
  }
};
/// What of start, goal and robot is nearest to the cursor, if one is within its reach; else nullptr.
std::unique_ptr<Drag> grab(const Run& run, const Pointer& pointer);

}  // namespace replan::ui
