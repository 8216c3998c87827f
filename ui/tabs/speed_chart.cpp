#include "ui/tabs/speed_chart.hpp"

#include <algorithm>
#include <cmath>

#include "core/debug/arc_words.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// Where times and speeds stand in the chart.
struct SpeedAxes {
  ImVec2 min, max;
  double seconds = 1, top = 0;  // at the right, and above

  [[nodiscard]] float x(double time) const {
    return min.x + static_cast<float>(time / seconds) * (max.x - min.x);
  }
  [[nodiscard]] float y(double speed) const {
    return max.y - static_cast<float>(speed / top) * (max.y - min.y);
  }
  [[nodiscard]] double time(float at) const {
    return std::clamp((at - min.x) / std::max(max.x - min.x, 1.0f), 0.0f, 1.0f) * seconds;
  }
};

double seconds_of(const Decision& decision) {
  return static_cast<double>(decision.time) / static_cast<double>(kSecond);
}

/// The first decision after that time, as an index.
std::size_t first_after(std::span<const Decision> decisions, double time) {
  const auto found = std::partition_point(decisions.begin(), decisions.end(),
                                          [time](const Decision& each) { return seconds_of(each) <= time; });
  return static_cast<std::size_t>(found - decisions.begin());
}

/// The speed that led up to each column of pixels: no more is looked at, however long the drive.
void draw_speeds(const SpeedAxes& axes, ImDrawList& list, std::span<const Decision> decisions, ImU32 colour,
                 float thick) {
  std::vector<ImVec2> line;
  const double last = seconds_of(decisions.back());
  for (float x = axes.min.x; x <= axes.max.x; x += 1) {
    const double time = axes.time(x);
    const std::size_t next = first_after(decisions, time);
    if (time > last || next == 0) break;
    const Decision& kept = decisions[std::min(next, decisions.size() - 1)];
    line.push_back({x, axes.y(kept.drive.state.motion.v)});
  }
  list.PushClipRect({axes.min.x, axes.min.y - thick}, {axes.max.x, axes.max.y + thick},
                    true);  // pointed corners
  list.AddPolyline(line.data(), static_cast<int>(line.size()), colour, ImDrawFlags_None, thick);
  list.PopClipRect();
}

void draw_axes(const Look& look, const SpeedAxes& axes, ImDrawList& list, float right) {
  const ImFont* small = look.fonts.mono_small;
  list.AddRectFilled({axes.min.x, axes.max.y}, {right, axes.max.y + look.px.hair}, look.theme.line);
  const std::string top = speed_text(axes.top), end = fixed(axes.seconds, 1) + " s";
  draw_text(list, small, {right - text_width(small, top), axes.min.y - look.px(4)}, look.theme.faint, top);
  draw_text(list, small, {right - text_width(small, end), axes.max.y - small->FontSize - look.px(2)},
            look.theme.faint, end);
}

bool has_driven(const Run& run) {
  return !run.decisions().empty() && run.decisions().back().figures.drive.top_speed > 0;
}

/// The limits that all panes' drives fit in.
void fit_all(const Session& session, SpeedAxes& axes) {
  for (const auto& run : session.runs()) {
    if (!has_driven(*run)) continue;
    const Decision& last = run->decisions().back();
    axes.seconds = std::max(axes.seconds, seconds_of(last));
    axes.top = std::max(axes.top, last.figures.drive.top_speed);
  }
}

}  // namespace

bool has_speeds(const Session& session) {
  return std::any_of(session.runs().begin(), session.runs().end(),
                     [](const auto& run) { return has_driven(*run); });
}

void speed_chart(Frame& frame, float height) {
  const Look& look = frame.look;
  const Session& session = frame.session;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0f);
  ImGui::InvisibleButton("speed", {width, height});
  const bool pressed = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  SpeedAxes axes{{origin.x, origin.y + look.px(6)}, {0, origin.y + height - look.px(4)}};
  fit_all(session, axes);
  axes.max.x = origin.x + width - text_width(look.fonts.mono_small, speed_text(axes.top)) - look.px.s;
  draw_axes(look, axes, list, origin.x + width);
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane)
    if (pane != session.lead() && has_driven(*session.runs()[pane]))
      draw_speeds(axes, list, session.runs()[pane]->decisions(), look.theme.faint, look.px(1));
  const Run& lead = session.run();
  if (!has_driven(lead)) return;
  draw_speeds(axes, list, lead.decisions(), look.theme.accent, look.px(1.5f));
  if (const Decision* now = lead.decision_at(lead.timeline().cursor())) {
    const float playhead = std::round(axes.x(seconds_of(*now)));
    list.AddRectFilled({playhead, origin.y}, {playhead + look.px.hair, origin.y + height}, look.theme.text);
  }
  if (!pressed && !hovered) return;
  const std::size_t after = first_after(lead.decisions(), axes.time(ImGui::GetIO().MousePos.x));
  const Decision& there = lead.decisions()[after == 0 ? 0 : after - 1];
  if (pressed && (ImGui::IsItemActivated() || ImGui::GetIO().MouseDelta.x != 0))
    frame.commands.push_back(Seek{there.event});
  hint(look, {(fixed(there.drive.state.motion.v, 3) + " m/s").c_str(), "",
              ("After " + fixed(seconds_of(there), 1) + " s. Click to go there.").c_str()});
}

}  // namespace replan::ui
