#include "ui/tabs/scatter_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/shell/format.hpp"

namespace replan::ui {
namespace {

/// Of points that are too many for marks: the squares, the fuller the stronger.
void draw_bins(const Look& look, ImDrawList& list, const PlotPlace& place) {
  const PlotPicture& picture = place.picture;
  const float wide = (place.area.max.x - place.area.min.x) / static_cast<float>(picture.width),
              high = (place.area.max.y - place.area.min.y) / static_cast<float>(picture.height);
  const float full = std::log1p(static_cast<float>(picture.most));
  for (int line = 0; line < picture.height; ++line)
    for (int column = 0; column < picture.width; ++column) {
      const PlotBin& bin =
          picture.bins[static_cast<std::size_t>(line) * static_cast<std::size_t>(picture.width) +
                       static_cast<std::size_t>(column)];
      if (bin.count == 0) continue;
      const float strength = 0.35f + 0.65f * std::log1p(static_cast<float>(bin.count)) / full;
      const ImVec2 min(place.area.min.x + static_cast<float>(column) * wide,
                       place.area.max.y - static_cast<float>(line + 1) * high);
      list.AddRectFilled(min, {min.x + wide, min.y + high},
                         with_alpha(state_colour(look.theme, bin.state), strength));
    }
}

}  // namespace

ImVec2 PlotPlace::at(double x, double y) const {
  const auto along = [](float from, float to, double place) {
    return from + static_cast<float>(std::clamp(place, -1.0, 2.0)) * (to - from);
  };
  return {along(area.min.x, area.max.x, picture.x.place(x)),
          along(area.max.y, area.min.y, picture.y.place(y))};
}

double PlotPlace::x(float pixel) const {
  const float share = (pixel - area.min.x) / (area.max.x - area.min.x);
  return picture.x.value(std::clamp(static_cast<double>(share), 0.0, 1.0));
}

double PlotPlace::y(float pixel) const {
  const float share = (area.max.y - pixel) / (area.max.y - area.min.y);
  return picture.y.value(std::clamp(static_cast<double>(share), 0.0, 1.0));
}

std::optional<std::size_t> PlotPlace::near(ImVec2 mouse, float reach) const {
  std::optional<std::size_t> nearest;
  float least = reach * reach;
  const auto take = [&](std::size_t row) {
    const ImVec2 there = of(row);
    const float x = there.x - mouse.x, y = there.y - mouse.y, away = x * x + y * y;
    if (!(away <= least)) return;
    least = away;
    nearest = row;
  };
  if (marked()) {
    for (std::size_t row = 0; row < picture.columns->points.size(); ++row) take(row);
    return nearest;
  }
  // Of many the first of each square about the mouse.
  const int column = static_cast<int>((mouse.x - area.min.x) / (area.max.x - area.min.x) *
                                      static_cast<float>(picture.width)),
            line = static_cast<int>((area.max.y - mouse.y) / (area.max.y - area.min.y) *
                                    static_cast<float>(picture.height));
  for (int y = std::max(line - 3, 0); y < std::min(line + 4, picture.height); ++y)
    for (int x = std::max(column - 3, 0); x < std::min(column + 4, picture.width); ++x) {
      const PlotBin& bin =
          picture.bins[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                       static_cast<std::size_t>(x)];
      if (bin.count > 0) take(bin.first);
    }
  return nearest;
}

ImU32 state_colour(const Theme& theme, PointState state) {
  switch (state) {
    case PointState::touched:
      return theme.faint;
    case PointState::closed:
      return theme.dim;
    case PointState::inconsistent:
      return theme.warning;
    case PointState::open:
      return theme.accent;
    case PointState::on_path:
      return theme.path;
  }
  return theme.text;
}

/// As on the canvas, no meaning by colour alone: what waits is hollow, what is not consistent points down, the path's stand on
/// a corner.
void draw_point(const Look& look, ImDrawList& list, ImVec2 at, PointState state) {
  const ImU32 colour = state_colour(look.theme, state);
  const float r = look.px(2.5f);
  switch (state) {
    case PointState::touched:
      return list.AddCircle(at, r * 0.8f, colour, 8);
    case PointState::closed:
      return list.AddCircleFilled(at, r * 0.8f, colour, 8);
    case PointState::inconsistent:
      return list.AddTriangleFilled({at.x - r, at.y - r}, {at.x + r, at.y - r}, {at.x, at.y + r}, colour);
    case PointState::open:
      return list.AddRect({at.x - r, at.y - r}, {at.x + r, at.y + r}, colour, 0, 0, look.px(1.5f));
    case PointState::on_path:
      return draw_star(list, at, look.px(4), 4, 0.7f, colour, look.theme.panel, look.px(1));
  }
}

void draw_points(const Look& look, ImDrawList& list, const PlotPlace& place) {
  if (!place.marked()) return draw_bins(look, list, place);
  const RunColumns& columns = *place.picture.columns;
  // The most telling over the others.
  for (std::size_t state = 0; state < kPointStates; ++state)
    for (std::size_t row = 0; row < columns.points.size(); ++row) {
      if (static_cast<std::size_t>(columns.states[row]) != state) continue;
      const double x = place.picture.x.place(columns.x[row]), y = place.picture.y.place(columns.y[row]);
      if (x >= 0 && x <= 1 && y >= 0 && y <= 1)
        draw_point(look, list, place.of(row), static_cast<PointState>(state));
    }
}

std::string measure_text(const Measure& measure, double value) {
  return measure.whole() ? grouped(static_cast<std::int64_t>(std::llround(value))) : fixed(value, 2);
}

void draw_plot_axes(const Look& look, ImDrawList& list, const PlotPlace& place, const Measure& x,
                    const Measure& y) {
  const ImFont *small = look.fonts.mono_small, *words = look.fonts.small;
  const ImVec2 min = place.area.min, max = place.area.max;
  list.AddRectFilled({min.x, max.y}, {max.x, max.y + look.px.hair}, look.theme.line);
  list.AddRectFilled({min.x - look.px.hair, min.y}, {min.x, max.y}, look.theme.line);
  const PlotPicture& picture = place.picture;
  const std::string left = measure_text(x, picture.x.low), right = measure_text(x, picture.x.high),
                    low = measure_text(y, picture.y.low), high = measure_text(y, picture.y.high);
  const float below = max.y + look.px(4);
  draw_text(list, small, {min.x, below}, look.theme.faint, left);
  draw_text(list, small, {max.x - text_width(small, right), below}, look.theme.faint, right);
  const float room = max.x - min.x - text_width(small, left) - text_width(small, right) - look.px.l;
  const std::string name = elide(words, x.label, std::max(room, 0.0f));
  draw_text(list, words,
            {min.x + text_width(small, left) + look.px.s + (room - text_width(words, name)) / 2, below},
            look.theme.dim, name);
  const float above = min.y - small->FontSize - look.px(4);
  const std::string range = low + " … " + high, upwards = elide(words, y.label, (max.x - min.x) / 2);
  draw_text(list, words, {min.x, above}, look.theme.dim, upwards);
  draw_text(list, small, {max.x - text_width(small, range), above}, look.theme.faint, range);
}

}  // namespace replan::ui
