// The tool for moving obstacles: draws their ways, selects and changes them.
#pragma once

#include <optional>
#include <vector>

#include "ui/tools/tool.hpp"

namespace replan::ui {

class MoverTool final : public Tool {
 public:
  /// Of the next moving obstacle.
  struct Movement {
    double speed = 2;
    WayEnd at_end = WayEnd::back;
  };

  std::unique_ptr<Drag> press(ToolContext& context) override;
  std::unique_ptr<Drag> press_right(ToolContext& context) override;
  [[nodiscard]] bool grabs() const override { return way_.empty(); }
  void draw(const CellPen& pen, const ViewState& view, std::optional<Cell> hovered) const override;
  [[nodiscard]] bool has_options(const ViewState&) const override { return true; }
  void draw_options(Frame& frame) override;
  void choose(ViewState& view) override;
  void leave(ViewState& view) override;
  [[nodiscard]] bool holds() const override { return !way_.empty(); }
  void drop() override { way_.clear(); }

  /// The way becomes a moving obstacle, which is selected. Nothing if there is none.
  void finish(const Session& session, ViewState& view, std::vector<Command>& commands);
  /// The corners drawn so far; the middle of the box goes through them.
  [[nodiscard]] const std::vector<Cell>& way() const { return way_; }
  Movement& next() { return next_; }

 private:
  std::vector<Cell> way_;
  Movement next_;
};

// For the action that ends a way.
[[nodiscard]] bool draws_way(const ViewState& view);
void finish_way(const Session& session, ViewState& view, std::vector<Command>& commands);
/// What can be chosen for the moving obstacle that is selected.
void draw_selected_mover(Frame& frame);

}  // namespace replan::ui
