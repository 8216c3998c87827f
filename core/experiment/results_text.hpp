// The results of an experiment as files for people's own programs.
#pragma once

#include <span>
#include <string>

#include "core/base/result.hpp"
#include "core/experiment/run_result.hpp"

namespace replan {

/// What results say of the experiment that they are of.
struct ResultsHead {
  std::string name;       ///< of the experiment; may be empty
  std::string digest;     ///< RunList::digest()
  std::int64_t runs = 0;  ///< in the whole experiment
  bool repeats = true;    ///< Experiment::repeats()
  friend bool operator==(const ResultsHead&, const ResultsHead&) = default;
};
ResultsHead results_head(const RunList& list);

/// A line for each run under a line of names, units in the names; what a run has not is empty. The same bytes for the same
/// results, however they were made.
std::string results_csv(std::span<const RunResult> results);
/// The same as JSON: `{"format": "replan results", "version": 1, "name", "digest", "runs_in_all", "repeats", "runs": [...]}`.
std::string results_json(const ResultsHead& head, std::span<const RunResult> results);
/// What does not repeat, joined to the others by the run's number: medians and quartiles of the times that it was made,
/// and the planner's memory.
std::string times_csv(std::span<const RunResult> results);

/// Results as results_json() wrote them.
struct ReadResults {
  ResultsHead head;
  std::vector<RunResult> results;
};
/// `origin` names the text in errors.
Result<ReadResults> parse_results(const std::string& text, const std::string& origin);

}  // namespace replan
