#include "core/study/batch.hpp"

#include <chrono>
#include <cmath>
#include <optional>

#include "core/plan/figures.hpp"
#include "core/plan/navigator.hpp"
#include "core/plan/registry.hpp"
#include "core/study/run_report.hpp"
#include "core/world/choices.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

using Clock = std::chrono::steady_clock;

/// One planner at work on one file.
class Batch {
 public:
  Batch(const GridMap& map, const LengthFormat& lengths, const PlannerChoice& choice)
      : map_(map), choice_(choice), lengths_(lengths) {
    if (find_pilot(choice.id) == nullptr) navigator_ = make_navigator(choice, map.box(), map.blocked, 0);
    report_.planner = choice.id;
    report_.comparable = lengths_apply(choice);
  }

  void solve(const ScenProblem& problem) {
    ++report_.problems;
    if (map_.at(problem.start) || map_.at(problem.goal)) {
      ++report_.skipped;
      return;
    }
    const std::optional<double> length = navigator_ ? planned(problem) : driven(problem);
    if (length)
      compare(problem, *length);
    else
      mismatch(problem, 0);
  }

  BatchReport report() {
    report_.mean_ratio = ratios_ > 0 ? ratio_sum_ / static_cast<double>(ratios_) : 0;
    return std::move(report_);
  }

 private:
  /// The length of the path, if there is one.
  std::optional<double> planned(const ScenProblem& problem) {
    const auto begin = Clock::now();
    navigator_->begin(centre_of(problem.start), centre_of(problem.goal));
    const bool found = finish(*navigator_) == PlanStatus::found;
    report_.total_ms += std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    report_.expansions += navigator_->counters().expansions;
    return found ? std::optional(path_length(navigator_->path())) : std::nullopt;
  }

  /// Of a pilot, whose path is none until it is driven: the length of its way, if it arrives.
  std::optional<double> driven(const ScenProblem& problem) {
    Scenario world;
    world.map = map_;
    world.start = problem.start;
    world.goal = problem.goal;
    const RunReport report = drive(world, choice_);
    report_.total_ms += report.plan_ms + report.replan_ms;
    report_.expansions += report.counters.expansions;
    return report.succeeded() ? std::optional(report.robot->travelled) : std::nullopt;
  }

  void compare(const ScenProblem& problem, double length) {
    ++report_.found;
    if (!lengths_.agrees(length, problem.printed)) mismatch(problem, length);
    if (problem.length == 0) {  // the way from a cell to itself: any length is an error as it stands
      report_.max_relative_error = std::max(report_.max_relative_error, length);
      return;
    }
    const double ratio = length / problem.length;
    report_.max_relative_error = std::max(report_.max_relative_error, std::abs(ratio - 1));
    ratio_sum_ += ratio;
    ++ratios_;
  }

  void mismatch(const ScenProblem& problem, double found) {
    if (!report_.comparable) return;
    ++report_.mismatches;
    if (report_.first_mismatches.size() < BatchReport::kMismatchesKept)
      report_.first_mismatches.push_back({problem.line, found, problem.length});
  }

  const GridMap& map_;
  const PlannerChoice& choice_;
  std::unique_ptr<Navigator> navigator_;  // of a planner
  LengthFormat lengths_;
  BatchReport report_;
  double ratio_sum_ = 0;
  std::int64_t ratios_ = 0;
};

}  // namespace

bool lengths_apply(const PlannerChoice& choice) {
  if (find_pilot(choice.id) != nullptr) return false;
  const MoveRules rules = move_rules(choice.settings);
  return find_planner(choice.id)->optimal(choice.settings) && rules.diagonals &&
         rules.corners == MoveRules{}.corners;
}

std::vector<ScenProblem> even_sample(const std::vector<ScenProblem>& problems, std::size_t limit) {
  if (limit == 0 || limit >= problems.size()) return problems;
  std::vector<ScenProblem> sample;
  sample.reserve(limit);
  const std::size_t gaps = limit > 1 ? limit - 1 : 1;
  for (std::size_t i = 0; i < limit; ++i) sample.push_back(problems[i * (problems.size() - 1) / gaps]);
  return sample;
}

BatchReport run_batch(const GridMap& map, const LengthFormat& lengths, std::span<const ScenProblem> problems,
                      const PlannerChoice& choice, const BatchWatch& watch) {
  Batch batch(map, lengths, choice);
  std::size_t done = 0;
  for (const ScenProblem& problem : problems) {
    if (watch.stop.stop_requested()) break;
    batch.solve(problem);
    if (watch.progress) watch.progress(++done);
  }
  return batch.report();
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
                                    {"mean_ratio", report.mean_ratio}});
  return pretty_json(document);
}

}  // namespace replan
