#include "core/experiment/batch_report.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/statistics.hpp"
#include "core/experiment/run_experiment.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

/// Adds up the runs of one planner.
class ReportSum {
 public:
  explicit ReportSum(const RunName& name) {
    report_.planner = name.planner;
    report_.label = planner_label(name);
  }

  [[nodiscard]] const std::string& label() const { return report_.label; }

  void add(const RunResult& run) {
    ++report_.problems;
    if (run.skipped()) {
      ++report_.skipped;
      return;
    }
    report_.found += run.succeeded ? 1 : 0;
    report_.expansions += static_cast<std::int64_t>(run.figure("expansions").value_or(0));
    if (!run.plan_ms.empty()) report_.total_ms += median(run.plan_ms) + median(run.replan_ms);
    if (run.mismatch) report_.comparable = true;
    if (run.mismatch.value_or(false)) mismatch(run);
    if (run.succeeded && run.expected) compare(run);
  }

  BatchReport report() {
    report_.mean_ratio = ratios_ > 0 ? ratio_sum_ / static_cast<double>(ratios_) : 0;
    return std::move(report_);
  }

 private:
  void compare(const RunResult& run) {
    const auto ratio = run.ratio();
    // The way from a cell to itself: any length is an error as it stands.
    const double error = ratio ? std::abs(*ratio - 1) : run.length().value_or(0);
    report_.max_relative_error = std::max(report_.max_relative_error, error);
    if (!ratio) return;
    ratio_sum_ += *ratio;
    ++ratios_;
  }

  void mismatch(const RunResult& run) {
    ++report_.mismatches;
    if (report_.first_mismatches.size() < BatchReport::kMismatchesKept)
      report_.first_mismatches.push_back(
          {run.name.world, run.name.line, run.length().value_or(0), run.expected.value_or(0)});
  }

  BatchReport report_;
  double ratio_sum_ = 0;
  std::int64_t ratios_ = 0;
};

}  // namespace

std::vector<BatchReport> batch_reports(std::span<const RunResult> results) {
  std::vector<ReportSum> sums;
  for (const RunResult& run : results) {
    const std::string label = planner_label(run.name);
    // Runs of one planner follow each other.
    auto sum = std::find_if(sums.rbegin(), sums.rend(),
                            [&](const ReportSum& each) { return each.label() == label; });
    if (sum == sums.rend()) {
      sums.emplace_back(run.name);
      sum = sums.rbegin();
    }
    sum->add(run);
  }
  std::vector<BatchReport> reports;
  for (ReportSum& sum : sums) reports.push_back(sum.report());
  return reports;
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
  ReportSum sum(list.name({}));
  for (std::int64_t run = 0; run < list.count(); ++run)
    if (const auto result = worker.make(run, {})) sum.add(*result);
  return sum.report();
}

}  // namespace replan
