// How the panes of a canvas share its area: two side by side, four in a square, with lines between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <imgui.h>

#include "ui/look.hpp"

namespace replan::ui {

class PaneGrid {
 public:
  PaneGrid(const Look& look, std::size_t count, ImVec2 min, ImVec2 max)
      : look_(look), count_(count), min_(min), max_(max), gap_(look.px(6)) {
    const bool wide = max.x - min.x >= 3 * look.px(kNarrowest);
    columns_ = count <= 2 ? count : count == 3 && wide ? 3 : 2;
    rows_ = (count + columns_ - 1) / columns_;
  }

  /// How many panes an area has room for.
  [[nodiscard]] static std::size_t room(const Look& look, ImVec2 min, ImVec2 max) {
    const auto fit = [&](float length, float least) {
      return static_cast<std::size_t>(std::max(1.0f, length / look.px(least)));
    };
    const std::size_t columns = fit(max.x - min.x, kNarrowest), rows = fit(max.y - min.y, kLowest);
    return rows >= 2 && columns >= 2 ? 4 : columns;
  }

  /// Of the first pane; the last one of an odd number may be wider.
  [[nodiscard]] float width() const { return share(max_.x - min_.x, columns_); }
  [[nodiscard]] float height() const { return share(max_.y - min_.y, rows_); }
  [[nodiscard]] ImVec2 min(std::size_t pane) const {
    return {edge(min_.x, width(), pane % columns_), edge(min_.y, height(), pane / columns_)};
  }
  [[nodiscard]] ImVec2 max(std::size_t pane) const {
    const bool last_of_row = pane % columns_ + 1 == columns_ || pane + 1 == count_;
    const ImVec2 low = min(pane);
    return {last_of_row ? max_.x : std::floor(low.x + width()),
            pane / columns_ + 1 == rows_ ? max_.y : std::floor(low.y + height())};
  }
  /// The lines on the left of a pane and above it, where others are.
  void draw_parting(std::size_t pane) const {
    const ImVec2 low = min(pane), high = max(pane);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float hair = look_.px.hair;
    if (pane % columns_ > 0)
      list.AddRectFilled({low.x - gap_, low.y}, {low.x - gap_ + hair, high.y}, look_.theme.line);
    if (pane / columns_ > 0)
      list.AddRectFilled({low.x, low.y - gap_}, {high.x, low.y - gap_ + hair}, look_.theme.line);
  }

 private:
  static constexpr float kNarrowest = 340, kLowest = 210;  // of the design

  [[nodiscard]] float share(float length, std::size_t parts) const {
    return (length - gap_ * static_cast<float>(parts - 1)) / static_cast<float>(parts);
  }
  [[nodiscard]] float edge(float begin, float length, std::size_t index) const {
    return std::floor(begin + static_cast<float>(index) * (length + gap_));
  }

  const Look& look_;
  std::size_t count_, columns_ = 1, rows_ = 1;
  ImVec2 min_, max_;
  float gap_;
};

}  // namespace replan::ui
