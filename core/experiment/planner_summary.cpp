#include "core/experiment/planner_summary.hpp"

#include <algorithm>

#include "core/base/statistics.hpp"

namespace replan {

std::optional<double> summary_figure(const RunResult& run, SummaryFigure figure) {
  if (!run.succeeded) return std::nullopt;
  const auto first_of = [&run](const char* driven, const char* planned) {
    const auto value = run.figure(driven);
    return value ? value : run.figure(planned);
  };
  switch (figure) {
    case SummaryFigure::length:
      return run.length();
    case SummaryFigure::turns:
      return run.figure("turns");
    case SummaryFigure::clearance:
      return first_of("way_min_clearance_cells", "min_clearance_cells");
    case SummaryFigure::expansions:
      return run.figure("expansions");
    case SummaryFigure::time:
      break;
  }
  if (run.plan_ms.empty() || run.replan_ms.empty()) return std::nullopt;
  return median(run.plan_ms) + median(run.replan_ms);
}

void PlannerSummary::add(const RunResult& run) {
  if (run.skipped()) return;
  ++runs_;
  found_ += run.succeeded ? 1 : 0;
  for (std::size_t i = 0; i < kSummaryFigures; ++i)
    if (const auto value = summary_figure(run, static_cast<SummaryFigure>(i))) medians_[i].add(*value);
}

std::optional<double> PlannerSummary::median(SummaryFigure figure) const {
  const RunningMedian& kept = medians_[static_cast<std::size_t>(figure)];
  return kept.empty() ? std::nullopt : std::optional(kept.median());
}

std::optional<double> PlannerSummary::ratio(SummaryFigure figure, const PlannerSummary& other) const {
  const auto own = median(figure), its = other.median(figure);
  if (!own || !its || *its == 0) return std::nullopt;
  return *own / *its;
}

void PlannerSummaries::add(const RunResult& run) {
  const std::string label = planner_label(run.name);
  auto at = std::find_if(all_.begin(), all_.end(),
                         [&](const PlannerSummary& each) { return each.label() == label; });
  auto index = static_cast<std::size_t>(at - all_.begin());
  if (at == all_.end()) {
    // Of several jobs a later planner's run may be done first.
    const auto place = std::upper_bound(lowest_.begin(), lowest_.end(), run.run);
    index = static_cast<std::size_t>(place - lowest_.begin());
    all_.emplace(all_.begin() + (place - lowest_.begin()), label);
    lowest_.insert(place, run.run);
  }
  all_[index].add(run);
}

}  // namespace replan
