#include "core/experiment/batch_report.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/statistics.hpp"
#include "core/experiment/run_experiment.hpp"
#include "core/world/json_reader.hpp"

namespace replan {

void BatchSums::Sum::add(const RunResult& run) {
  ++report.problems;
  if (run.skipped()) {
    ++report.skipped;
    return;
  }
  report.found += run.succeeded ? 1 : 0;
  report.expansions += static_cast<std::int64_t>(run.figure("expansions").value_or(0));
  if (!run.plan_ms.empty()) report.total_ms += median(run.plan_ms) + median(run.replan_ms);
  if (run.mismatch) report.comparable = true;
  if (run.mismatch.value_or(false)) mismatch(run);
  if (run.succeeded && run.expected) compare(run);
}

void BatchSums::Sum::compare(const RunResult& run) {
  const auto ratio = run.ratio();
  // The way from a cell to itself: any length is an error as it stands.
  const double error = ratio ? std::abs(*ratio - 1) : run.length().value_or(0);
  report.max_relative_error = std::max(report.max_relative_error, error);
  if (!ratio) return;
  ratios += *ratio;
  ++compared;
}

void BatchSums::Sum::mismatch(const RunResult& run) {
  ++report.mismatches;
  if (report.first_mismatches.size() < BatchReport::kMismatchesKept)
    report.first_mismatches.push_back(
        {run.name.world, run.name.line, run.length().value_or(0), run.expected.value_or(0)});
}

void BatchSums::add(const RunResult& run) {
  const std::string label = planner_label(run.name);
  // Runs of one planner follow each other.
  auto sum =
      std::find_if(sums_.rbegin(), sums_.rend(), [&](const Sum& each) { return each.report.label == label; });
  if (sum == sums_.rend()) {
    sums_.emplace_back();
    sum = sums_.rbegin();
    sum->report.planner = run.name.planner;
    sum->report.label = label;
  }
  sum->add(run);
}

std::vector<BatchReport> BatchSums::reports() const {
  std::vector<BatchReport> reports;
  for (const Sum& sum : sums_) {
    reports.push_back(sum.report);
    if (sum.compared > 0) reports.back().mean_ratio = sum.ratios / static_cast<double>(sum.compared);
  }
  return reports;
}

std::vector<BatchReport> batch_reports(std::span<const RunResult> results) {
  BatchSums sums;
  for (const RunResult& run : results) sums.add(run);
  return sums.reports();
}

std::string batch_json(std::span<const BatchReport> reports) {
  Json document = {{"planners", Json::array()}};
  for (const BatchReport& report : reports)
    document["planners"].push_back({{"planner", report.planner},
                                    {"problems", report.problems},
                                    {"found", report.found},
                                    {"mismatches", report.mismatches},
                                    {"max_relative_error", report.max_relative_error},
                                    {"total_ms", report.total_ms},
                                    {"expansions", report.expansions},
                                    {"skipped", report.skipped},
                                    {"comparable", report.comparable},
                                    {"mean_ratio", report.mean_ratio},
                                    {"label", report.label}});
  return pretty_json(document);
}

BatchReport solve_problems(const GridMap& map, const LengthFormat& lengths,
                           std::span<const ScenProblem> problems, const PlannerChoice& choice) {
  Experiment experiment;
  experiment.planners = {choice};
  experiment.surprises = {{ExperimentSurprises::Kind::none, {}}};
  LoadedWorld world;
  world.problems.assign(problems.begin(), problems.end());
  world.lengths = lengths;
  world.scenario.map = map;
  std::vector<LoadedWorld> worlds;
  worlds.push_back(std::move(world));
  const RunList list(std::move(experiment), std::move(worlds), 0);
  ExperimentWorker worker(list);
  BatchSums sums;
  for (std::int64_t run = 0; run < list.count(); ++run)
    if (const auto result = worker.make(run, {})) sums.add(*result);
  std::vector<BatchReport> reports = sums.reports();
  if (!reports.empty()) return std::move(reports.front());
  BatchReport nothing;
  nothing.planner = nothing.label = choice.id;
  return nothing;
}

}  // namespace replan
