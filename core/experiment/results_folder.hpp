// The folder that a batch keeps its results in. A run that is done is written down at once, so that whatever ends the
// program loses no more than the runs that were being made; begun again on the same folder, the batch goes on.
//
//   batch.json    the experiment with everything written out, the digest of all it depends on, and which part of it this is
//   runs.jsonl    a line for each run that is done, in the order in which they ended
//   results.csv, results.json, times.csv    once all are done: core/experiment/results_text.hpp
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "core/base/lock_file.hpp"
#include "core/base/result.hpp"
#include "core/experiment/journal.hpp"
#include "core/experiment/results_text.hpp"
#include "core/experiment/run_list.hpp"
#include "core/experiment/run_result.hpp"

namespace replan {

/// One of so many parts of an experiment: the runs whose number leaves `index` when divided by `count`.
struct Shard {
  std::int64_t index = 0;  ///< from 0
  std::int64_t count = 1;
  [[nodiscard]] bool has(std::int64_t run) const { return run % count == index; }
  friend bool operator==(const Shard&, const Shard&) = default;
};
inline constexpr std::int64_t kMostShards = 1'000'000;

/// Takes results one after the other, which are not all held at once.
using TakeResult = std::function<void(const RunResult&)>;

/// A folder that this process alone writes to.
class ResultsFolder {
 public:
  /// Makes the folder, or takes up what an earlier process has left there. Refused: results of another experiment or of
  /// another part of it, a folder that another process is at work in, a file of another kind in the way.
  static Result<ResultsFolder> open(const std::string& path, const RunList& list, const Shard& shard);
  ResultsFolder(ResultsFolder&& other) noexcept = default;
  ResultsFolder& operator=(ResultsFolder&&) = delete;
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;
  ~ResultsFolder();

  /// How many runs of this part are done.
  [[nodiscard]] std::size_t done() const { return kept_.size(); }
  /// Reads what is done, in the order of the runs' numbers.
  [[nodiscard]] Result<void> each(const TakeResult& take) const;
  /// The numbers of the runs of this part that are not done.
  [[nodiscard]] std::vector<std::int64_t> missing() const;
  /// Writes a result down.
  Result<void> add(const RunResult& result);
  /// Writes results.csv, results.json and times.csv of all that is done, and shows each result to `also`.
  Result<void> write_results(const TakeResult& also = {}) const;
  /// Whether these are there.
  [[nodiscard]] bool has_result_files() const;

 private:
  ResultsFolder(std::string path, LockFile lock, Journal journal, ResultsHead head, const Shard& shard);

  std::string path_;
  LockFile lock_;
  Journal journal_;
  ResultsHead head_;
  Shard shard_;
  std::vector<Journal::Line> kept_;        // of the journal, each run once
  std::unordered_set<std::int64_t> done_;  // their numbers
};

/// A folder as it stands, whoever writes to it.
struct KeptResults {
  ResultsHead head;
  Shard shard;
  std::string experiment;  ///< experiment_text()
  std::vector<RunResult> results;
};
Result<KeptResults> read_results_folder(const std::string& path);

/// The results of all parts together, in a folder of their own: the same bytes as the results of the whole experiment made
/// at once. Refused: parts of different experiments, runs that are missing or there twice, a folder that has results.
/// Shows each result to `also`, and returns how many there are.
Result<std::size_t> merge_results(std::span<const std::string> folders, const std::string& out,
                                  const TakeResult& also = {});

/// "3, 5-8 and 12 more": some numbers, in ascending order, as a sentence has them.
std::string numbers_text(std::span<const std::int64_t> numbers);

}  // namespace replan
