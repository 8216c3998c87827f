#include "core/study/study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/statistics.hpp"
#include "core/plan/named.hpp"
#include "core/study/papers/paper_studies.hpp"

namespace replan {

const char* verdict_name(Verdict verdict) {
  constexpr std::array<const char*, 4> kNames = {"reproduced", "partly", "not reproduced", "answered"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::span<const StudyInfo> studies() {
  static const std::array kStudies{dld_table_study(), dld_surprise_study(), dld_random_study(),
                                   dld_maze_study(),  astar_table_study(),  fusion_study(),
                                   auv_study(),       informed_rrt_study()};
  return kStudies;
}

Result<const StudyInfo*> require_study(std::string_view id) {
  return require_by_id(studies(), id, "study");
}

std::optional<Spread> spread_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  Spread spread{.count = values.size(),
                .low = quantile(values, 0.25),
                .median = quantile(values, 0.5),
                .high = quantile(values, 0.75)};
  const auto count = static_cast<double>(values.size());
  for (const double value : values) spread.mean += value / count;
  if (values.size() == 1) return spread;
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = std::sqrt(squares / (count - 1));
  return spread;
}

std::optional<Spread> spread_of(const StudyReport& report, std::size_t figure, std::size_t planner,
                                std::optional<std::size_t> world) {
  std::vector<double> values;
  for (const StudyRun& run : report.runs)
    if (run.planner == planner && (!world || run.world == *world) && run.values[figure])
      values.push_back(*run.values[figure]);
  return spread_of(std::move(values));
}

std::optional<Spread> ratio_of(const StudyReport& report, std::size_t figure, std::size_t planner,
                               std::size_t to, std::optional<std::size_t> world) {
  std::map<std::pair<std::size_t, std::uint64_t>, double> others;
  for (const StudyRun& run : report.runs)
    if (run.planner == to && run.found && run.values[figure])
      others[{run.world, run.seed}] = *run.values[figure];
  std::vector<double> ratios;
  for (const StudyRun& run : report.runs) {
    if (run.planner != planner || !run.found || !run.values[figure] || (world && run.world != *world))
      continue;
    const auto other = others.find({run.world, run.seed});
    if (other != others.end() && other->second > 0) ratios.push_back(*run.values[figure] / other->second);
  }
  return spread_of(std::move(ratios));
}

double typical(const StudyFigure& figure, const Spread& spread) {
  return figure.wall_time ? spread.median : spread.mean;
}

}  // namespace replan
