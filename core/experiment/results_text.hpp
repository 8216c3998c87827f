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
std::string results_csv_head();
std::string results_csv_row(const RunResult& result);
/// The same as JSON: `{"format": "replan results", "version": 1, "name", "digest", "runs_in_all", "repeats", "runs": [...]}`.
/// Rows follow the head, each behind a line's end and with a comma between them, and the end comes last.
std::string results_json_head(const ResultsHead& head);
std::string results_json_row(const RunResult& result);
inline constexpr const char* kResultsJsonEnd = "\n]}\n";
/// What does not repeat, joined to the others by the run's number: medians and quartiles of the times that it was made,
/// and the planner's memory.
std::string times_csv_head();
std::string times_csv_row(const RunResult& result);

/// Results as results.json has them.
struct ReadResults {
  ResultsHead head;
  std::vector<RunResult> results;
};
/// `origin` names the text in errors.
Result<ReadResults> parse_results(const std::string& text, const std::string& origin);

}  // namespace replan
