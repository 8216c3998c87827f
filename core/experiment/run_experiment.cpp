#include "core/experiment/run_experiment.hpp"

#include <atomic>
#include <mutex>
#include <new>

#include "core/base/threads.hpp"
#include "core/study/run_report.hpp"
#include "core/world/choices.hpp"

namespace replan {
namespace {

std::optional<double> figure_named(std::span<const NamedFigure> figures, std::string_view key) {
  for (const NamedFigure& figure : figures)
    if (figure.key == key) return figure.value;
  return std::nullopt;
}

/// The run's figures, in the order of the columns.
std::vector<std::optional<double>> figures_of(const RunReport& report) {
  std::vector<NamedFigure> all = named_figures(report);
  if (report.robot)
    for (const auto& more : {named_figures(*report.robot), drive_figures(*report.robot),
                             kept_figures(*report.robot), surprise_figures(*report.robot)})
      all.insert(all.end(), more.begin(), more.end());
  std::vector<std::optional<double>> figures;
  for (const ResultColumn& column : result_columns()) figures.push_back(figure_named(all, column.figure));
  return figures;
}

}  // namespace

Navigator& ExperimentWorker::navigator_for(const RunParts& parts) {
  RunParts now = parts;
  now.problem = now.surprises = 0;
  if (navigator_ == nullptr || now != made_for_) {
    navigator_.reset();  // before there is another: both may be large
    const GridMap& map = list_.world(parts).scenario.map;
    navigator_ = make_navigator(list_.choice(parts), map.box(), map.blocked, list_.robot(parts).radius);
    made_for_ = now;
  }
  return *navigator_;
}

std::optional<RunReport> ExperimentWorker::once(const RunParts& parts, const StopToken& stop) {
  const PlannerChoice choice = list_.choice(parts);
  if (list_.drives(parts)) return drive_until(stop, list_.scenario(parts), choice);
  const ScenProblem& asked = list_.problem(parts);
  RunLimit limit{.stop = stop};
  if (find_planner(choice.id)->can_miss()) limit.seconds = list_.experiment().seconds;
  return plan_once(navigator_for(parts), list_.world(parts).scenario.map, asked.start, asked.goal, choice,
                   list_.robot(parts), limit);
}

std::optional<RunResult> ExperimentWorker::make(std::int64_t run, const StopToken& stop) {
  const RunParts parts = list_.parts(run);
  const ScenProblem& asked = list_.problem(parts);
  RunResult result;
  result.run = run;
  result.name = list_.name(parts);
  if (!asked.printed.empty() || asked.length > 0) result.expected = asked.length;
  result.printed = asked.printed;
  if (list_.skipped(parts)) {
    result.status = RunResult::kSkipped;
    result.figures.resize(result_columns().size());
    return result;
  }
  for (int time = 0; time < list_.experiment().repeat; ++time) {
    const auto report = once(parts, stop);
    if (!report) return std::nullopt;
    result.plan_ms.push_back(report->plan_ms);
    result.replan_ms.push_back(report->replan_ms);
    if (time > 0) continue;
    result.plan_status = report->status;
    result.status = report->robot ? mission_state_name(report->robot->ending) : report->status;
    result.succeeded = report->succeeded();
    if (report->frame) result.metres_per_cell = report->frame->metres_per_cell();
    result.figures = figures_of(*report);
    result.memory_bytes = report->memory_bytes;
  }
  if (list_.length_is_listed(parts)) {
    const auto length = result.length();
    result.mismatch = !length || !list_.world(parts).lengths.agrees(*length, asked.printed);
  }
  return result;
}

bool make_runs(const RunList& list, std::span<const std::int64_t> runs, std::size_t jobs,
               const ExperimentWatch& watch) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> given_up{false};
  std::mutex taking;
  std::atomic<bool> no_memory{false};
  const auto make_some = [&] {
    ExperimentWorker worker(list);
    for (std::size_t i = next++; i < runs.size() && !given_up; i = next++) {
      auto result = watch.stop.stop_requested() ? std::nullopt : worker.make(runs[i], watch.stop);
      const std::lock_guard lock(taking);
      if (given_up || !result || !watch.take(std::move(*result))) given_up = true;
    }
  };
  const auto work = [&] {
    try {
      make_some();
    } catch (const std::bad_alloc&) {  // a thread that let it go on would end the program
      no_memory = given_up = true;
    }
  };
  work_on_threads(std::min(jobs, runs.size()), work);
  if (no_memory) throw std::bad_alloc();
  return !given_up;
}

}  // namespace replan
