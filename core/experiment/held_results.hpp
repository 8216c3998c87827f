// What a folder of results holds, told without reading them: for who chooses a folder and may go on with what is there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/experiment/results_folder.hpp"

namespace replan {

/// What the program's own JSON files of batches are.
enum class BatchPaper : std::uint8_t {
  none,        ///< something else
  experiment,  ///< an experiment
  results      ///< batch.json or results.json of a folder of results
};
/// By the key "format", whatever else is right or wrong in the file.
BatchPaper batch_paper(const std::string& path);

struct HeldResults {
  std::string folder;
  std::string name;                 ///< of the experiment; may be empty
  std::int64_t done = 0, runs = 0;  ///< of this part; in this part
  Shard shard;
  /// The experiment's file, if it is found: in the folder, in the two above it, or in the current one.
  std::string file;

  [[nodiscard]] bool complete() const { return done >= runs; }
  [[nodiscard]] bool whole() const { return shard.count == 1; }
};
/// Nothing where the folder holds no batch. Slow for long journals: not for the drawing thread.
Result<std::optional<HeldResults>> held_results(const std::string& folder);

}  // namespace replan
