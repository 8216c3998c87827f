#include "ui/tabs/watch_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// Where moments and values stand in the chart.
struct Plot {
  ImVec2 min, max;
  double low = 0, high = 1;
  std::size_t size = 1;  // of the log

  [[nodiscard]] float x(std::size_t position) const {
    return min.x +
           static_cast<float>(static_cast<double>(position) / static_cast<double>(size)) * (max.x - min.x);
  }
  [[nodiscard]] float y(double value) const {
    return max.y - static_cast<float>((value - low) / (high - low)) * (max.y - min.y);
  }
  [[nodiscard]] std::size_t position(float at) const {
    const double part = std::clamp((at - min.x) / std::max(max.x - min.x, 1.0f), 0.0f, 1.0f);
    return static_cast<std::size_t>(std::llround(part * static_cast<double>(size)));
  }
};

/// The least and the greatest finite value of all panes' series, which share the chart; false if there are
/// none.
bool range_of(const Session& session, std::size_t watch, double& low, double& high) {
  low = std::numeric_limits<double>::infinity();
  high = -low;
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane)
    for (const WatchPoint& point : session.watches().series(pane, watch))
      if (std::isfinite(point.value)) {
        low = std::min(low, point.value);
        high = std::max(high, point.value);
      }
  return low <= high;
}

/// A value holds until the next one, so the line goes in steps; where it is infinite there is none.
void draw_series(const Plot& plot, ImDrawList& list, std::span<const WatchPoint> series, ImU32 colour,
                 float width) {
  for (std::size_t i = 0; i < series.size(); ++i) {
    const WatchPoint& point = series[i];
    if (!std::isfinite(point.value)) continue;
    const float from = plot.x(point.position), y = plot.y(point.value);
    const float to = i + 1 < series.size() ? plot.x(series[i + 1].position) : plot.max.x;
    list.AddRectFilled({from, y - width * 0.5f}, {std::max(to, from + width), y + width * 0.5f}, colour);
    if (i + 1 == series.size() || !std::isfinite(series[i + 1].value)) continue;
    const float next = plot.y(series[i + 1].value);
    list.AddRectFilled({to - width * 0.5f, std::min(y, next)}, {to + width * 0.5f, std::max(y, next)},
                       colour);
  }
}

/// The least and the greatest value, to the right of the lines.
void draw_range(const Look& look, const Plot& plot, ImDrawList& list, float right, float bottom) {
  const ImFont* small = look.fonts.mono_small;
  list.AddRectFilled({plot.min.x, bottom}, {right, bottom + look.px.hair}, look.theme.line);
  const auto label = [&](double value, float y) {
    const std::string words = quantity_text(value);
    draw_text(list, small, {right - text_width(small, words), y}, look.theme.faint, words);
  };
  label(plot.high, plot.min.y - look.px(4));
  if (plot.high > plot.low) label(plot.low, bottom - small->FontSize);
}

/// Room for the range: the same for most charts, so that their moments stand one above the other.
float range_width(const Look& look, double low, double high) {
  const ImFont* small = look.fonts.mono_small;
  return std::max({text_width(small, "0000.000"), text_width(small, quantity_text(low)),
                   text_width(small, quantity_text(high))});
}

}  // namespace

std::string quantity_text(double value) {
  if (!std::isfinite(value)) return "—";
  if (value == std::floor(value) && std::abs(value) < 1e15) return grouped(static_cast<std::int64_t>(value));
  return fixed(value, 3);
}

void watch_chart(Frame& frame, std::size_t watch, float height) {
  const Look& look = frame.look;
  const Session& session = frame.session;
  const Timeline& log = session.run().timeline();
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0f);
  ImGui::InvisibleButton("chart", {width, height});
  const bool pressed = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const auto series = session.watches().series(session.lead(), watch);
  Plot plot{{origin.x, origin.y + look.px(6)},
            {origin.x + width, origin.y + height - look.px(4)},
            0,
            1,
            std::max<std::size_t>(log.size(), 1)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!range_of(session, watch, plot.low, plot.high)) {
    draw_text(list, look.fonts.small, {origin.x, origin.y + height * 0.4f}, look.theme.faint,
              series.empty() ? "Looking through the log…" : "It has no value in this run.");
  } else {
    plot.max.x -= range_width(look, plot.low, plot.high) + look.px.s;
    draw_range(look, plot, list, origin.x + width, origin.y + height);
    Plot drawn = plot;
    if (drawn.high == drawn.low) drawn.low -= 1, drawn.high += 1;
    for (std::size_t pane = 0; pane < session.runs().size(); ++pane)
      if (pane != session.lead() && session.runs()[pane]->timeline().size() > 0) {
        drawn.size = session.runs()[pane]->timeline().size();
        draw_series(drawn, list, session.watches().series(pane, watch), look.theme.line, look.px(1));
      }
    drawn.size = plot.size;
    list.PushClipRect(drawn.min, {drawn.max.x, drawn.max.y + look.px(2)}, true);
    draw_series(drawn, list, series, look.theme.accent, look.px(1.5f));
    list.PopClipRect();
  }
  const float playhead = std::round(plot.x(log.cursor()));
  list.AddRectFilled({playhead, origin.y}, {playhead + look.px.hair, origin.y + height}, look.theme.text);
  if (!pressed && !hovered) return;
  const std::size_t at = plot.position(ImGui::GetIO().MousePos.x);
  if (pressed && (ImGui::IsItemActivated() || ImGui::GetIO().MouseDelta.x != 0))
    frame.commands.push_back(Seek{at});
  const auto after = std::partition_point(series.begin(), series.end(),
                                          [at](const WatchPoint& point) { return point.position <= at; });
  const std::string value = after == series.begin() ? "—" : quantity_text(std::prev(after)->value);
  hint(look, {value.c_str(), "", ("At event " + grouped(at) + ". Click to go there.").c_str()});
}

}  // namespace replan::ui
