#include "core/study/study.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/plan/named.hpp"
#include "core/study/paper_studies.hpp"

namespace replan {

const char* verdict_name(Verdict verdict) {
  constexpr std::array<const char*, 3> kNames = {"reproduced", "partly", "not reproduced"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::span<const StudyInfo> studies() {
  static const std::array kStudies{dld_random_study(), informed_rrt_study()};
  return kStudies;
}

Result<const StudyInfo*> require_study(std::string_view id) {
  return require_by_id(studies(), id, "study");
}

std::optional<Spread> spread_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double share) {
    const double at = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
  };
  Spread spread{
      .count = values.size(), .low = quantile(0.25), .median = quantile(0.5), .high = quantile(0.75)};
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

}  // namespace replan
