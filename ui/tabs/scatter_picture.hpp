// How a scatter plot's points are drawn and met by the mouse.
#pragma once

#include <optional>

#include "core/debug/plot_bins.hpp"
#include "ui/look.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

/// Up to so many points each has a mark of its own; more are drawn as squares that stand the stronger, the more of them
/// they hold.
inline constexpr std::size_t kMarkedPoints = 4000;
/// The side of such a square, in pixels of the design.
inline constexpr float kBinSide = 3;

/// Where numbers stand in the window.
struct PlotPlace {
  ScreenArea area;
  const PlotPicture& picture;

  [[nodiscard]] ImVec2 at(double x, double y) const;
  [[nodiscard]] ImVec2 of(std::size_t row) const {
    return at(picture.columns->x[row], picture.columns->y[row]);
  }
  [[nodiscard]] double x(float pixel) const;
  [[nodiscard]] double y(float pixel) const;
  /// Whether each point has a mark of its own.
  [[nodiscard]] bool marked() const { return picture.columns->points.size() <= kMarkedPoints; }
  /// The row of the point nearest to a place of the window, within some pixels.
  [[nodiscard]] std::optional<std::size_t> near(ImVec2 mouse, float reach) const;
};

[[nodiscard]] ImU32 state_colour(const Theme& theme, PointState state);
/// The mark of a point in that state.
void draw_point(const Look& look, ImDrawList& list, ImVec2 at, PointState state);
void draw_points(const Look& look, ImDrawList& list, const PlotPlace& place);
/// The frame, and the numbers at the ends of both axes.
void draw_plot_axes(const Look& look, ImDrawList& list, const PlotPlace& place, const Measure& x,
                    const Measure& y);
/// "9 214", "41.21"
[[nodiscard]] std::string measure_text(const Measure& measure, double value);

}  // namespace replan::ui
