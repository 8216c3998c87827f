// The panes of the canvas, as many as there is room for, with the legend that they share.
#pragma once

#include <memory>
#include <vector>

#include "ui/canvas/canvas.hpp"
#include "ui/canvas/legend.hpp"

namespace replan::ui {

class Panes {
 public:
  explicit Panes(ImGuiRenderer& renderer) : renderer_(renderer) {}

  /// Draws at most `most` panes of the session into the current window; 0: as many as there is room for. What the mouse
  /// comes to with `interactive` is appended to `commands`.
  void draw(const Look& look, const Session& session, std::size_t most, ViewState& state, ImVec2 min,
            ImVec2 max, bool interactive, std::vector<Command>& commands);
  /// Makes the next draw show the whole world.
  void fit();
  /// As Canvas::take_over(), in all of them.
  void take_over(const Box& world, ViewState& state);
  [[nodiscard]] bool animating() const;
  /// What was drawn of the leading pane, and where; of the one nearest to it, if there was no room for that.
  [[nodiscard]] const Scene& scene() const { return canvases_[shown_]->scene(); }
  [[nodiscard]] const ScreenArea& area() const { return area_; }

 private:
  Canvas& canvas(std::size_t pane);

  ImGuiRenderer& renderer_;
  std::vector<std::unique_ptr<Canvas>> canvases_;  // by pane
  Legend legend_;
  std::size_t shown_ = 0;                    // the pane of scene() and area()
  std::size_t first_drawn_ = 0, drawn_ = 0;  // the panes that were drawn last
  /// That the legend speaks of: the one under the mouse, or the last that was, for the way from there to the legend.
  std::size_t pointed_ = 0;
  ScreenArea area_;
};

}  // namespace replan::ui
