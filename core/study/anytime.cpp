#include "core/study/anytime.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/plan/common_parameters.hpp"
#include "core/plan/figures.hpp"
#include "core/plan/navigator.hpp"
#include "core/plan/registry.hpp"
#include "core/planners/rrt_parameters.hpp"

namespace replan {
namespace {

constexpr double kNoLength = std::numeric_limits<double>::infinity();

double milliseconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

double where(const Gain& gain, AnytimeAxis axis) {
  return axis == AnytimeAxis::time ? gain.ms : static_cast<double>(gain.samples);
}

/// The length of the best path at a place of the axis.
double length_at(const AnytimeRun& run, AnytimeAxis axis, double at) {
  const auto next = std::partition_point(run.gains.begin(), run.gains.end(),
                                         [&](const Gain& gain) { return where(gain, axis) <= at; });
  return next == run.gains.begin() ? kNoLength : std::prev(next)->length;
}

}  // namespace

double wall_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

AnytimeRun plan_anytime(const GridMap& map, Cell start, Cell goal, const PlannerChoice& choice, double radius,
                        double most_ms, const StopToken& stop, double (*clock)()) {
  const auto navigator = make_navigator(choice, map.box(), map.blocked, radius);
  AnytimeRun run;
  run.planner = choice.id;
  run.seed = static_cast<std::int64_t>(choice.settings.get(parameters::kSeed));
  const double begin = clock();
  navigator->begin(centre_of(start), centre_of(goal));
  Cost best = Cost::infinity();
  const bool limited = std::isfinite(most_ms);
  for (bool stands = false; !stands;) {
    stands = navigator->advance(1);
    const Cost now = navigator->best_so_far();
    // A look at the clock can take as long as a sample: only where somebody wants to know.
    if (limited || stands || now != best) run.ms = clock() - begin;
    if (now != best) {
      best = now;
      run.gains.push_back({navigator->counters().expansions, run.ms, now.to_double()});
    }
    if (stands || (!(limited && run.ms >= most_ms) && !stop.stop_requested())) continue;
    run.end = stop.stop_requested() ? AnytimeEnd::stopped : AnytimeEnd::time;
    static_cast<void>(navigator->settle());
    break;
  }
  run.samples = navigator->counters().expansions;
  run.status = run.end != AnytimeEnd::planner && !run.found() ? PlanStatus::none_found : navigator->status();
  return run;
}

ShortestSearch::ShortestSearch(const Box& box, const SharedBytes& known, Cell start, Cell goal,
                               const PlannerChoice& choice, double radius) {
  PlannerChoice exact{"visibility-graph", {}};
  if (!fits(*find_planner(exact.id), box, radius)) return;
  exact.settings.set(parameters::kCorners.key, choice.settings.get(parameters::kCorners));
  make_ = [=] {
    auto navigator = make_navigator(exact, box, known, radius);
    navigator->begin(centre_of(start), centre_of(goal));
    return navigator;
  };
}

std::optional<std::optional<double>> ShortestSearch::advance() {
  constexpr std::int64_t kSlice = 16;  // corners
  const std::optional<double> nothing;
  if (!make_) return nothing;
  if (!navigator_) {
    navigator_ = make_();
    return std::nullopt;
  }
  if (!navigator_->advance(kSlice)) return std::nullopt;
  return navigator_->status() == PlanStatus::found ? std::optional(path_length(navigator_->path())) : nothing;
}

std::optional<double> shortest_of_all(const Box& box, const SharedBytes& known, Cell start, Cell goal,
                                      const PlannerChoice& choice, double radius, double most_ms,
                                      const StopToken& stop) {
  ShortestSearch search(box, known, start, goal, choice, radius);
  const auto begin = std::chrono::steady_clock::now();
  while (true) {
    if (const auto length = search.advance()) return *length;
    if (stop.stop_requested() || milliseconds_since(begin) >= most_ms) return std::nullopt;
  }
}

std::vector<std::span<const AnytimeRun>> by_planner(std::span<const AnytimeRun> runs) {
  std::vector<std::span<const AnytimeRun>> groups;
  for (std::size_t from = 0, to = 0; from < runs.size(); from = to) {
    while (to < runs.size() && runs[to].planner == runs[from].planner) ++to;
    groups.push_back(runs.subspan(from, to - from));
  }
  return groups;
}

double lower_median(std::vector<double> values) {
  if (values.empty()) return kNoLength;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<CurvePoint> median_curve(std::span<const AnytimeRun> runs, AnytimeAxis axis) {
  std::vector<double> places;
  for (const AnytimeRun& run : runs)
    for (const Gain& gain : run.gains) places.push_back(where(gain, axis));
  std::sort(places.begin(), places.end());
  std::vector<CurvePoint> curve;
  for (const double at : places) {
    std::vector<double> lengths;
    for (const AnytimeRun& run : runs) lengths.push_back(length_at(run, axis, at));
    const double median = lower_median(std::move(lengths));
    if (std::isfinite(median) && (curve.empty() || median < curve.back().length))
      curve.push_back({at, median});
  }
  return curve;
}

}  // namespace replan
