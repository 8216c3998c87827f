// results.csv, results.json and times.csv, written run by run as they are told, and there all at once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/pending_file.hpp"
#include "core/experiment/results_text.hpp"

namespace replan {

class ResultFiles {
 public:
  static Result<ResultFiles> create(const std::string& folder, const ResultsHead& head);
  /// The next run in the order of their numbers.
  Result<void> add(const RunResult& result);
  /// Gives the files their names. Without it they are gone.
  Result<void> commit();

 private:
  /// Text on its way to the disk.
  struct Text {
    PendingFile file;
    std::string held;  // not written yet
    Result<void> put(std::string_view more, std::size_t most_held);
  };

  ResultFiles() = default;

  std::vector<Text> texts_;  // results.csv, results.json, times.csv
  bool first_ = true;        // run
};

}  // namespace replan
