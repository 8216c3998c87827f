// The hand on a canvas: hands presses and drags to the tool that is chosen.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ui/canvas/view_state.hpp"
#include "ui/tools/tool.hpp"

namespace replan::ui {

class Hand {
 public:
  /// Takes in a frame's input and appends what it comes to.
  void update(const Session& session, const Run& run, ViewState& state, const Pointer& pointer,
              std::vector<Command>& commands);

  /// What was begun is given up.
  void let_go() {
    drag_.reset();
    busy_ = false;
  }

  /// A button is down that went down on the canvas.
  [[nodiscard]] bool busy() const { return busy_; }
  /// Start, goal, robot or the corner of a way are held.
  [[nodiscard]] bool holds() const { return drag_ && drag_->holds(); }
  /// Whether a press would take hold of the start, the goal or the robot.
  [[nodiscard]] bool could_hold(const Run& run, const ViewState& state, const Pointer& pointer) const;
  /// What would be written if the button were let go now, or pressed at `hovered` on that sheet.
  [[nodiscard]] CellPreview preview(const ViewState& state, const Sheet& sheet,
                                    std::optional<Cell> hovered) const;

 private:
  void press(ToolContext& context);
  void move(ToolContext& context);

  bool busy_ = false;
  Press press_;                 // the latest one
  std::unique_ptr<Drag> drag_;  // what it has begun; nothing: it was for something that is done
};

}  // namespace replan::ui
