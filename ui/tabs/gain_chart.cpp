#include "ui/tabs/gain_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/debug/event_words.hpp"
#include "core/session/lockstep.hpp"
#include "core/study/anytime.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr std::size_t kGainsPerFrame = 512;

/// Where samples and costs stand in the chart.
struct GainAxes {
  ImVec2 min, max;
  double samples = 1;  // at the right
  double low = std::numeric_limits<double>::infinity(), high = -low;

  [[nodiscard]] bool empty() const { return high < low; }
  [[nodiscard]] float x(double sample) const {
    return min.x + static_cast<float>(std::min(1.0, sample / samples)) * (max.x - min.x);
  }
  [[nodiscard]] float y(double cost) const {
    const double range = high > low ? high - low : 1;
    return max.y - static_cast<float>((cost - low) / range) * (max.y - min.y);
  }
  [[nodiscard]] double sample(float at) const {
    return std::clamp((at - min.x) / std::max(max.x - min.x, 1.0f), 0.0f, 1.0f) * samples;
  }
  void take(double cost) {
    low = std::min(low, cost);
    high = std::max(high, cost);
  }
};

/// The events of the plan that the cursor stands in, or of the last one before it.
std::pair<std::size_t, std::size_t> plan_at_cursor(const Run& run) {
  std::size_t begin = 0, end = run.timeline().size();
  for (const Milestone& each : run.milestones()) {
    if (each.kind != EventKind::plan_begin) continue;
    if (each.event > begin && each.event >= run.timeline().cursor()) {
      end = each.event;
      break;
    }
    begin = each.event;
  }
  return {begin, end};
}

/// Where the plan that begins there stands, before anything else happens; `end` if it does not yet.
std::size_t plan_end(const Run& run, std::size_t begin, std::size_t end) {
  for (const Milestone& each : run.milestones())
    if (each.kind == EventKind::plan_end && each.event > begin) return std::min(each.event, end);
  return end;
}

/// A cost holds until the next one, so the line goes in steps; where there is no path there is none.
void draw_gains(const GainAxes& axes, ImDrawList& list, std::span<const PathGain> gains, std::int64_t samples,
                ImU32 colour, float thick) {
  for (std::size_t i = 0; i < gains.size(); ++i) {
    if (gains[i].cost.is_infinite()) continue;
    const bool last = i + 1 == gains.size();
    const float from = axes.x(static_cast<double>(gains[i].sample)), y = axes.y(gains[i].cost.to_double()),
                to = axes.x(static_cast<double>(last ? samples : gains[i + 1].sample));
    list.AddRectFilled({from, y - thick / 2}, {std::max(to, from + thick), y + thick / 2}, colour);
    if (last || gains[i + 1].cost.is_infinite()) continue;
    const float next = axes.y(gains[i + 1].cost.to_double());
    list.AddRectFilled({to - thick / 2, std::min(y, next)}, {to + thick / 2, std::max(y, next)}, colour);
  }
}

void draw_gain_axes(const Look& look, const GainAxes& axes, ImDrawList& list, float right) {
  const ImFont* small = look.fonts.mono_small;
  list.AddRectFilled({axes.min.x, axes.max.y}, {right, axes.max.y + look.px.hair}, look.theme.line);
  const auto label = [&](double value, float y) {
    const std::string words = fixed(value, 2);
    draw_text(list, small, {right - text_width(small, words), y}, look.theme.faint, words);
  };
  label(axes.high, axes.min.y - look.px(4));
  if (axes.high > axes.low) label(axes.low, axes.max.y - small->FontSize);
  draw_text(list, small, {axes.min.x, axes.max.y + look.px(3)}, look.theme.faint, "0");
  const std::string end = grouped(static_cast<std::int64_t>(axes.samples)) + " samples";
  draw_text(list, small, {axes.max.x - text_width(small, end), axes.max.y + look.px(3)}, look.theme.faint,
            end);
}

void draw_optimum(const Look& look, const GainAxes& axes, ImDrawList& list, double optimum) {
  const float y = axes.y(optimum), dash = look.px(4);
  for (float x = axes.min.x; x < axes.max.x; x += 2 * dash)
    list.AddRectFilled({x, y}, {std::min(x + dash, axes.max.x), y + look.px.hair}, look.theme.good);
}

bool is_first_path(std::span<const PathGain> gains, std::size_t i) {
  return !gains[i].cost.is_infinite() && (i == 0 || gains[i - 1].cost.is_infinite());
}

}  // namespace

bool has_gains(const Session& session) {
  return std::any_of(session.runs().begin(), session.runs().end(),
                     [](const auto& run) { return run->info().sampling && !run->milestones().empty(); });
}

const GainChart::Curve& GainChart::curve_of(Frame& frame, std::size_t pane) {
  const Run& run = *frame.session.runs()[pane];
  if (curves_.size() <= pane) curves_.resize(pane + 1);
  Curve& curve = curves_[pane];
  const auto [begin, end] = plan_at_cursor(run);
  const bool same = curve.log_id == run.log_id() && curve.begin == begin && curve.end == end;
  if (same && curve.read.complete()) return curve;
  curve.read.follow(run.log_view(), run.log_id(), begin, end, frame.view.live ? kGainsPerFrame : SIZE_MAX);
  if (!curve.read.complete()) frame.panels.animated = true;
  curve.log_id = run.log_id();
  curve.begin = begin;
  curve.end = end;
  curve.samples = expansions_between(run, begin, end);
  return curve;
}

std::optional<double> GainChart::optimum_of(Frame& frame, const Curve& curve) {
  const Run& run = frame.run();
  const std::size_t at = plan_end(run, curve.begin, curve.end);
  const bool same = optimum_ && optimum_->log_id == curve.log_id && optimum_->begin == curve.begin;
  if (!same || (!optimum_->has_ends && optimum_->at != at)) begin_optimum(run, curve, at, frame.view.live);
  if (const auto done = optimum_->job.take()) optimum_->length = *done;
  if (optimum_->job.busy()) frame.panels.animated = true;
  return optimum_->length;
}

void GainChart::begin_optimum(const Run& run, const Curve& curve, std::size_t at, bool live) {
  optimum_ = std::make_unique<Optimum>(live || run.lattice().node_count() > kLargeWorld);
  optimum_->log_id = curve.log_id;
  optimum_->begin = curve.begin;
  optimum_->at = at;
  const SearchState state = run.timeline().state_at(at);
  const NodeId start = state.node(Scalar::start), goal = state.node(Scalar::goal);
  optimum_->has_ends = start != kNoNode && goal != kNoNode;
  if (!optimum_->has_ends) return;
  optimum_->job.start([box = run.lattice(), known = state.known_map(), start, goal, choice = run.choice(),
                       radius = run.scenario().robot.radius](const std::stop_token& stop) {
    return shortest_of_all(box, known, box.position(start), box.position(goal), choice, radius,
                           std::numeric_limits<double>::infinity(), stop);
  });
}

void GainChart::draw(Frame& frame, float height) {
  const Look& look = frame.look;
  const Session& session = frame.session;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0f), foot = look.px(20);
  ImGui::InvisibleButton("gains", {width, height + foot});
  const bool pressed = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  GainAxes axes{{origin.x, origin.y + look.px(6)}, {0, origin.y + height - look.px(4)}};
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane) {
    const Curve& curve = curve_of(frame, pane);
    axes.samples = std::max(axes.samples, static_cast<double>(curve.samples));
    for (const PathGain& gain : curve.gains())
      if (!gain.cost.is_infinite()) axes.take(gain.cost.to_double());
  }
  const Curve& lead = curves_[session.lead()];
  const std::span<const PathGain> gains = lead.gains();
  const auto optimum = optimum_of(frame, lead);
  if (optimum) axes.take(*optimum);
  if (axes.empty()) return;
  axes.max.x = origin.x + width - text_width(look.fonts.mono_small, fixed(axes.high, 2)) - look.px.s;
  draw_gain_axes(look, axes, list, origin.x + width);
  if (optimum) draw_optimum(look, axes, list, *optimum);
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane)
    if (pane != session.lead())
      draw_gains(axes, list, curves_[pane].gains(), curves_[pane].samples, look.theme.faint, look.px(1));
  draw_gains(axes, list, gains, lead.samples, look.theme.accent, look.px(1.5f));
  for (std::size_t i = 0; i < gains.size(); ++i)
    if (is_first_path(gains, i))
      list.AddCircleFilled({axes.x(static_cast<double>(gains[i].sample)), axes.y(gains[i].cost.to_double())},
                           look.px(3), look.theme.accent);
  const Run& run = session.run();
  const float playhead =
      std::round(axes.x(static_cast<double>(expansions_between(run, lead.begin, run.timeline().cursor()))));
  list.AddRectFilled({playhead, origin.y}, {playhead + look.px.hair, origin.y + height}, look.theme.text);
  if (!pressed && !hovered) return;
  const double sample = axes.sample(ImGui::GetIO().MousePos.x);
  const auto after = std::partition_point(gains.begin(), gains.end(), [sample](const PathGain& gain) {
    return static_cast<double>(gain.sample) <= sample;
  });
  if (after == gains.begin()) return;
  const PathGain& gain = *std::prev(after);
  if (pressed && (ImGui::IsItemActivated() || ImGui::GetIO().MouseDelta.x != 0))
    frame.commands.push_back(Seek{gain.event + 1});
  const std::string best = gain.cost.is_infinite() ? "no path" : cost_text(gain.cost, 3);
  std::string words = "Since sample " + grouped(gain.sample) + " of this plan. Click to go there.";
  if (optimum) words += " The shortest of all ways is " + fixed(*optimum, 3) + " cells long.";
  hint(look, {best.c_str(), "", words.c_str()});
}

}  // namespace replan::ui
