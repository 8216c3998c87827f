// How the panes of a canvas share its area: side by side, with a line between them.
#pragma once

#include <cmath>
#include <cstddef>

#include <imgui.h>

#include "ui/look.hpp"

namespace replan::ui {

class PaneRow {
 public:
  PaneRow(const Look& look, std::size_t count, ImVec2 min, ImVec2 max)
      : look_(look),
        min_(min),
        max_(max),
        gap_(look.px(6)),
        width_((max.x - min.x - gap_ * static_cast<float>(count - 1)) / static_cast<float>(count)) {}

  [[nodiscard]] float width() const { return width_; }
  [[nodiscard]] ImVec2 min(std::size_t pane) const { return {left(pane), min_.y}; }
  [[nodiscard]] ImVec2 max(std::size_t pane) const { return {std::floor(left(pane) + width_), max_.y}; }
  /// The line on the left of a pane, if it is not the first.
  void draw_parting(std::size_t pane) const {
    if (pane == 0) return;
    const float x = left(pane) - gap_;
    ImGui::GetWindowDrawList()->AddRectFilled({x, min_.y}, {x + look_.px.hair, max_.y}, look_.theme.line);
  }

 private:
  [[nodiscard]] float left(std::size_t pane) const {
    return std::floor(min_.x + static_cast<float>(pane) * (width_ + gap_));
  }

  const Look& look_;
  ImVec2 min_, max_;
  float gap_, width_;
};

}  // namespace replan::ui
