// The runs of an experiment, made: one after the other, or on several threads.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "core/base/stop.hpp"
#include "core/experiment/run_list.hpp"
#include "core/experiment/run_result.hpp"
#include "core/plan/navigator.hpp"

namespace replan {

/// Makes runs one after the other, with one planner for those that follow each other on one map.
class ExperimentWorker {
 public:
  /// `list` must outlive it.
  explicit ExperimentWorker(const RunList& list) : list_(list) {}

  /// Nothing if it was stopped.
  std::optional<RunResult> make(std::int64_t run, const StopToken& stop);

 private:
  std::optional<RunReport> once(const RunParts& parts, const StopToken& stop);
  Navigator& navigator_for(const RunParts& parts);

  const RunList& list_;
  std::unique_ptr<Navigator> navigator_;
  RunParts made_for_;  // what of it decides which navigator it is
};

/// How the making of runs is watched and stopped.
struct ExperimentWatch {
  /// Takes each result, one at a time, from the threads that make them; false: no more are wanted.
  std::function<bool(RunResult)> take;
  StopToken stop = {};  ///< what is being made then is given up
};

/// Makes the runs of these numbers on `jobs` threads; with one on the caller's own. Returns whether all were made and
/// taken. The order in which they are taken is that of the numbers with one thread alone.
bool make_runs(const RunList& list, std::span<const std::int64_t> runs, std::size_t jobs,
               const ExperimentWatch& watch);

}  // namespace replan
