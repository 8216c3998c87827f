#include "ui/tabs/fitness_chart.hpp"

#include <algorithm>

#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr std::size_t kGenerationsPerFrame = 512;

/// One cost of each generation.
std::vector<CostPoint> points_of_fitness(std::span<const FitnessPoint> points, Cost FitnessPoint::*cost) {
  std::vector<CostPoint> curve;
  for (const FitnessPoint& point : points) curve.push_back({point.generation, (point.*cost).to_double()});
  return curve;
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

/// Every pane's fittest with its key, and of the leading one the mean of all.
std::vector<CurveKey> FitnessChart::draw_curves(const Frame& frame, CostChart& chart) const {
  const Session& session = frame.session;
  std::vector<CurveKey> keys;
  const auto draw = [&](std::size_t pane, CurveMark mark) {
    chart.line(points_of_fitness(curves_[pane].points(), &FitnessPoint::fittest), curve_colour(frame, pane),
               mark);
  };
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane) {
    if (!session.runs()[pane]->info().evolving) continue;
    const bool leads = pane == session.lead();
    const CurveMark mark = leads ? CurveMark::thick : CurveMark::thin;
    keys.push_back({mark, curve_colour(frame, pane), curve_name(frame, pane) + ", the fittest path"});
    if (!leads) draw(pane, mark);
  }
  const std::vector<CostPoint> mean =
      points_of_fitness(curves_[session.lead()].points(), &FitnessPoint::mean);
  if (!mean.empty()) keys.push_back({CurveMark::thin, frame.look.theme.dim, "all paths on average"});
  chart.line(mean, frame.look.theme.dim, CurveMark::thin);
  draw(session.lead(), CurveMark::thick);
  return keys;
}

void FitnessChart::draw(Frame& frame, float height) {
  const Session& session = frame.session;
  const LengthUnit lengths = shown_lengths(frame.view, session.scenario().map);
  CostChart chart(frame, "fitness", height, CostScale::logarithmic);
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane) {
    const FitnessCurve& curve =
        curve_of(*session.runs()[pane], pane, frame.view.live ? kGenerationsPerFrame : SIZE_MAX);
    if (!curve.complete()) frame.panels.animated = true;
    for (const FitnessPoint& point : curve.points()) {
      chart.axes.reach(point.generation);
      chart.axes.take(point.fittest.to_double());
      chart.axes.take(point.mean.to_double());
    }
  }
  const std::string end =
      count_text(static_cast<std::int64_t>(chart.axes.count), "generation", "generations");
  if (!chart.lay_out(lengths, 1, end)) return;
  const std::vector<CurveKey> keys = draw_curves(frame, chart);
  const std::span<const FitnessPoint> lead = curves_[session.lead()].points();
  chart.playhead(reached(lead, session.run().timeline().cursor()));
  if (const auto pointed = chart.pointed(); pointed && !lead.empty()) {
    const FitnessPoint& there = point_at(lead, *pointed);
    if (chart.asks()) frame.commands.push_back(Seek{there.event + 1});
    const std::string words =
        "After generation " + grouped(there.generation) + " the paths cost " + lengths.text(there.mean) +
        " on average" + (there.free ? "." : ", and the fittest one hits something.") + " Click to go there.";
    hint(frame.look, {lengths.text(there.fittest).c_str(), "", words.c_str()});
  }
  chart.keys(keys);
}

}  // namespace replan::ui
