// The files of a folder of results, by their names. Only for what reads and writes such folders.
#pragma once

#include <array>
#include <span>
#include <string>

#include "core/experiment/results_folder.hpp"

namespace replan {

inline constexpr const char *kBatchFile = "batch.json", *kJournalFile = "runs.jsonl",
                            *kCsvFile = "results.csv", *kJsonFile = "results.json", *kTimesFile = "times.csv";
/// Written once all runs are done.
inline constexpr std::array kResultFiles = {kCsvFile, kJsonFile, kTimesFile};
std::string batch_path(const std::string& folder, const char* file);

/// batch.json; read back it has no results yet.
Result<void> write_batch_file(const std::string& folder, const ResultsHead& head, const Shard& shard,
                              const std::string& experiment);
Result<KeptResults> read_batch_file(const std::string& folder);

}  // namespace replan
