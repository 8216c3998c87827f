// A part of a view's pixels.
#pragma once

#include <algorithm>
#include <cmath>

namespace replan {

/// A rectangle of a view, in its pixels.
struct PixelBox {
  double left = 0, top = 0, right = 0, bottom = 0;
  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
  [[nodiscard]] PixelBox moved_to(double x, double y) const { return {x, y, x + width(), y + height()}; }
  /// The area that two have in common.
  [[nodiscard]] double common(const PixelBox& other) const;
  /// How far two lie apart; 0 if they meet.
  [[nodiscard]] double apart(const PixelBox& other) const;
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

inline double PixelBox::common(const PixelBox& other) const {
  const double across = std::min(right, other.right) - std::max(left, other.left),
               down = std::min(bottom, other.bottom) - std::max(top, other.top);
  return across > 0 && down > 0 ? across * down : 0;
}

inline double PixelBox::apart(const PixelBox& other) const {
  const double across = std::max({0.0, left - other.right, other.left - right}),
               down = std::max({0.0, top - other.bottom, other.top - bottom});
  return std::hypot(across, down);
}

}  // namespace replan
