#include "ui/tabs/fitness_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/debug/event_words.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/column_line.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr std::size_t kGenerationsPerFrame = 512;

/// Where generations and costs stand in the chart. Costs are laid out by their logarithms: the first paths hit much, and a
/// hit costs more than all that is gained later.
struct FitnessAxes {
  ImVec2 min, max;
  double generations = 1;  // at the right
  double low = std::numeric_limits<double>::infinity(), high = 0;

  [[nodiscard]] bool empty() const { return high < low; }
  [[nodiscard]] float x(std::int64_t generation) const {
    return min.x + static_cast<float>(static_cast<double>(generation) / generations) * (max.x - min.x);
  }
  [[nodiscard]] float y(Cost cost) const {
    const double range = high > low ? std::log(high / low) : 1;
    return max.y -
           static_cast<float>(std::log(std::max(cost.to_double(), low) / low) / range) * (max.y - min.y);
  }
  [[nodiscard]] double generation(float at) const {
    return std::clamp((at - min.x) / std::max(max.x - min.x, 1.0f), 0.0f, 1.0f) * generations;
  }
  void take(const FitnessPoint& point) {
    generations = std::max(generations, static_cast<double>(point.generation));
    low = std::min(low, point.fittest.to_double());
    high = std::max({high, point.fittest.to_double(), point.mean.to_double()});
  }
};

/// One cost of each point, joined.
void draw_costs(const FitnessAxes& axes, ImDrawList& list, std::span<const FitnessPoint> points,
                Cost FitnessPoint::*cost, ImU32 colour, float thick) {
  std::vector<ImVec2> line;
  for (const FitnessPoint& point : points) line.push_back({axes.x(point.generation), axes.y(point.*cost)});
  draw_long_line(list, line, colour, thick);
}

void draw_fitness_axes(const Look& look, const FitnessAxes& axes, ImDrawList& list, float right) {
  const ImFont* small = look.fonts.mono_small;
  list.AddRectFilled({axes.min.x, axes.max.y}, {right, axes.max.y + look.px.hair}, look.theme.line);
  const auto cost = [&](double value, float y) {
    const std::string words = fixed(value, 1);
    draw_text(list, small, {right - text_width(small, words), y}, look.theme.faint, words);
  };
  cost(axes.high, axes.min.y - look.px(4));
  if (axes.high > axes.low) cost(axes.low, axes.max.y - small->FontSize);
  const float below = axes.max.y + look.px(3);
  draw_text(list, small, {axes.min.x, below}, look.theme.faint, "0");
  const std::string end = grouped(static_cast<std::int64_t>(axes.generations)) + " generations";
  draw_text(list, small, {axes.max.x - text_width(small, end), below}, look.theme.faint, end);
}

/// The generations that have ended before a position of the log.
std::int64_t reached(std::span<const FitnessPoint> points, std::size_t position) {
  const auto after = std::partition_point(
      points.begin(), points.end(), [position](const FitnessPoint& point) { return point.event < position; });
  return after == points.begin() ? 0 : std::prev(after)->generation;
}

/// The generation that the mouse is at.
const FitnessPoint& point_at(std::span<const FitnessPoint> points, double generation) {
  return *std::partition_point(points.begin(), points.end() - 1, [generation](const FitnessPoint& point) {
    return static_cast<double>(point.generation) < generation;
  });
}

}  // namespace

bool has_generations(const Session& session) {
  return std::any_of(session.runs().begin(), session.runs().end(),
                     [](const auto& run) { return run->info().evolving && !run->milestones().empty(); });
}

const FitnessCurve& FitnessChart::curve_of(const Run& run, std::size_t pane, std::size_t most) {
  if (curves_.size() <= pane) curves_.resize(pane + 1);
  curves_[pane].follow(run.log_view(), run.log_id(), most);
  return curves_[pane];
}

std::string FitnessChart::csv(const Session& session) {
  return fitness_csv(curve_of(session.run(), session.lead(), SIZE_MAX).points());
}

void FitnessChart::draw(Frame& frame, float height) {
  const Look& look = frame.look;
  const Session& session = frame.session;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0f), foot = look.px(20);
  ImGui::InvisibleButton("fitness", {width, height + foot});
  const bool pressed = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  FitnessAxes axes{{origin.x, origin.y + look.px(6)}, {0, origin.y + height - look.px(4)}};
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane) {
    const FitnessCurve& curve =
        curve_of(*session.runs()[pane], pane, frame.view.live ? kGenerationsPerFrame : SIZE_MAX);
    if (!curve.complete()) frame.panels.animated = true;
    for (const FitnessPoint& point : curve.points()) axes.take(point);
  }
  if (axes.empty()) return;
  axes.max.x = origin.x + width - text_width(look.fonts.mono_small, fixed(axes.high, 1)) - look.px.s;
  draw_fitness_axes(look, axes, list, origin.x + width);
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane)
    if (pane != session.lead())
      draw_costs(axes, list, curves_[pane].points(), &FitnessPoint::fittest, look.theme.faint, look.px(1));
  const std::span<const FitnessPoint> lead = curves_[session.lead()].points();
  draw_costs(axes, list, lead, &FitnessPoint::mean, look.theme.dim, look.px(1));
  draw_costs(axes, list, lead, &FitnessPoint::fittest, look.theme.accent, look.px(1.5f));
  const float playhead = std::round(axes.x(reached(lead, session.run().timeline().cursor())));
  list.AddRectFilled({playhead, origin.y}, {playhead + look.px.hair, origin.y + height}, look.theme.text);
  if ((!pressed && !hovered) || lead.empty()) return;
  const FitnessPoint& there = point_at(lead, axes.generation(ImGui::GetIO().MousePos.x));
  if (pressed && (ImGui::IsItemActivated() || ImGui::GetIO().MouseDelta.x != 0))
    frame.commands.push_back(Seek{there.event + 1});
  const std::string words =
      "After generation " + grouped(there.generation) + " the paths cost " + cost_text(there.mean, 3) +
      " on average" + (there.free ? "." : ", and the fittest one hits something.") + " Click to go there.";
  hint(look, {cost_text(there.fittest, 3).c_str(), "", words.c_str()});
}

}  // namespace replan::ui
