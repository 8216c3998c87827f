#include "ui/tabs/gain_chart.hpp"

#include <algorithm>

#include "core/debug/event_words.hpp"
#include "core/session/lockstep.hpp"
#include "core/study/anytime.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr std::size_t kGainsPerFrame = 512;

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

std::vector<CostPoint> points_of(std::span<const PathGain> gains) {
  std::vector<CostPoint> points;
  for (const PathGain& gain : gains) points.push_back({gain.sample, gain.cost.to_double()});
  return points;
}

bool is_first_path(std::span<const PathGain> gains, std::size_t i) {
  return !gains[i].cost.is_infinite() && (i == 0 || gains[i - 1].cost.is_infinite());
}

}  // namespace

bool has_gains(const Session& session) {
  return std::any_of(session.runs().begin(), session.runs().end(),
                     [](const auto& run) { return run->info().sampling && !run->milestones().empty(); });
}

std::size_t gains_pane(const Session& session) {
  const auto runs = session.runs();
  if (runs[session.lead()]->info().sampling) return session.lead();
  const auto first =
      std::find_if(runs.begin(), runs.end(), [](const auto& run) { return run->info().sampling; });
  return first == runs.end() ? session.lead() : static_cast<std::size_t>(first - runs.begin());
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

std::optional<double> GainChart::optimum_of(Frame& frame, const Run& run, const Curve& curve) {
  const std::size_t at = plan_end(run, curve.begin, curve.end);
  const bool same = optimum_ && optimum_->log_id == curve.log_id && optimum_->begin == curve.begin;
  if (!same || (!optimum_->has_ends && optimum_->at != at)) begin_optimum(frame, run, curve, at);
  if (const auto done = optimum_->job.take()) optimum_->length = *done;
  if (optimum_->job.busy()) frame.panels.animated = true;
  return optimum_->length;
}

void GainChart::begin_optimum(const Frame& frame, const Run& run, const Curve& curve, std::size_t at) {
  const bool large = run.lattice().node_count() > kLargeWorld;
  optimum_ = std::make_unique<Optimum>(frame.session.work().only_if(frame.view.live || large));
  optimum_->log_id = curve.log_id;
  optimum_->begin = curve.begin;
  optimum_->at = at;
  const SearchState state = run.timeline().state_at(at);
  const NodeId start = state.node(Scalar::start), goal = state.node(Scalar::goal);
  optimum_->has_ends = start != kNoNode && goal != kNoNode;
  if (!optimum_->has_ends) return;
  auto search = std::make_shared<ShortestSearch>(run.lattice(), state.known_map(),
                                                 run.lattice().position(start), run.lattice().position(goal),
                                                 run.choice(), run.scenario().robot.radius);
  optimum_->job.start_slices([search = std::move(search)](const StopToken&) { return search->advance(); });
}

/// Expansions and children are no samples: only panes that draw samples have a curve, over samples.
void GainChart::draw(Frame& frame, float height) {
  const Session& session = frame.session;
  const LengthUnit lengths = shown_lengths(frame.view, session.scenario().map);
  const std::size_t main = gains_pane(session);
  CostChart chart(frame, "gains", height, CostScale::linear);
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane) {
    if (!session.runs()[pane]->info().sampling) continue;
    const Curve& curve = curve_of(frame, pane);
    chart.axes.reach(curve.samples);
    for (const PathGain& gain : curve.gains())
      if (!gain.cost.is_infinite()) chart.axes.take(gain.cost.to_double());
  }
  const Run& run = *session.runs()[main];
  const Curve& curve = curves_[main];
  const auto optimum = optimum_of(frame, run, curve);
  if (optimum) chart.axes.take(*optimum);
  const std::string end = count_text(static_cast<std::int64_t>(chart.axes.count), "sample", "samples");
  if (!chart.lay_out(lengths, 2, end)) return;
  const std::vector<CurveKey> keys = draw_curves(frame, chart, optimum);
  chart.playhead(expansions_between(run, curve.begin, run.timeline().cursor()));
  tell_gain(frame, chart, optimum);
  chart.keys(keys);
}

/// What the mouse points at in the strong curve, and where a click leads.
void GainChart::tell_gain(Frame& frame, const CostChart& chart, std::optional<double> optimum) {
  const auto pointed = chart.pointed();
  if (!pointed) return;
  const std::size_t main = gains_pane(frame.session);
  const std::span<const PathGain> gains = curves_[main].gains();
  const LengthUnit lengths = shown_lengths(frame.view, frame.session.scenario().map);
  const auto after = std::partition_point(
      gains.begin(), gains.end(),
      [sample = *pointed](const PathGain& gain) { return static_cast<double>(gain.sample) <= sample; });
  if (after == gains.begin()) return;
  const PathGain& gain = *std::prev(after);
  if (chart.asks()) {
    if (main != frame.session.lead()) frame.commands.push_back(Lead{main});
    frame.commands.push_back(Seek{gain.event + 1});
  }
  const std::string best = gain.cost.is_infinite() ? "no path" : lengths.text(gain.cost);
  std::string words = "Since sample " + grouped(gain.sample) + " of this plan. Click to go there.";
  if (optimum) words += " The shortest of all ways is " + lengths.in_words(*optimum) + " long.";
  hint(frame.look, {best.c_str(), "", words.c_str()});
}

/// Every curve with its key; the strong one lies on top.
std::vector<CurveKey> GainChart::draw_curves(const Frame& frame, CostChart& chart,
                                             std::optional<double> optimum) const {
  const Session& session = frame.session;
  const Theme& theme = frame.look.theme;
  const std::size_t main = gains_pane(session);
  std::vector<CurveKey> keys;
  if (optimum) chart.level(*optimum, theme.good);
  const auto draw = [&](std::size_t pane, CurveMark mark) {
    const std::vector<CostPoint> points = points_of(curves_[pane].gains());
    chart.steps(points, curves_[pane].samples, curve_colour(frame, pane), mark);
  };
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane) {
    if (!session.runs()[pane]->info().sampling) continue;
    const CurveMark mark = pane == main ? CurveMark::thick : CurveMark::thin;
    keys.push_back({mark, curve_colour(frame, pane), curve_name(frame, pane)});
    if (pane != main) draw(pane, mark);
  }
  draw(main, CurveMark::thick);
  const std::span<const PathGain> gains = curves_[main].gains();
  for (std::size_t i = 0; i < gains.size(); ++i) {
    if (!is_first_path(gains, i)) continue;
    chart.dot({gains[i].sample, gains[i].cost.to_double()}, theme.accent);
    keys.push_back({CurveMark::dot, theme.accent, "first path"});
    break;
  }
  if (optimum) keys.push_back({CurveMark::dashes, theme.good, "the shortest of all ways"});
  return keys;
}

}  // namespace replan::ui
