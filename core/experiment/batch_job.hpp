// A batch off the thread that shows it: the runs of an experiment made into a folder of results, watched while they are.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/background.hpp"
#include "core/experiment/run_list.hpp"
#include "core/experiment/run_result.hpp"
#include "core/experiment/world_experiment.hpp"

namespace replan {

/// What shall be made.
struct BatchRequest {
  WorldExperiment what;
  std::string folder;    ///< of the results; a world in hand and its experiment go there too
  std::size_t jobs = 1;  ///< threads
};

/// How it came to its end.
struct BatchEnd {
  bool all = false;   ///< all runs are made, and the files of results are written
  std::string error;  ///< why it could not begin or go on; empty if it was stopped
};

/// How far it is.
struct BatchProgress {
  std::size_t done = 0, all = 0;  ///< runs; none of all before the experiment is loaded
  std::optional<double>
      seconds_left;  ///< at the pace since it was begun or went on; nothing before the first run
};

/// One batch at a time. What has come of it is there until the next one is started.
class BatchJob {
 public:
  explicit BatchJob(const WorkPlace& place = {}) : place_(place), work_(place) {}
  ~BatchJob() { stop(); }
  BatchJob(const BatchJob&) = delete;
  BatchJob& operator=(const BatchJob&) = delete;

  /// Begins, or goes on with what the folder holds. Not while another one is at work.
  void start(BatchRequest request);
  /// Runs that are being made are finished, and no others begun.
  void pause();
  void go_on();
  /// Gives up the runs that are being made; the folder is let go of once that is so, which is its end.
  void stop();

  [[nodiscard]] bool busy() const { return work_.busy(); }
  [[nodiscard]] bool paused() const;
  [[nodiscard]] BatchProgress progress() const;
  /// The results since the last call, those that the folder held already first; so many at most.
  std::vector<RunResult> take_results(std::size_t most = static_cast<std::size_t>(-1));
  /// Its end, once.
  std::optional<BatchEnd> take_end() { return work_.take(); }
  /// What the runs are; nullptr before the experiment is loaded.
  [[nodiscard]] std::shared_ptr<const RunList> list() const;

 private:
  class Shared;

  WorkPlace place_;
  std::shared_ptr<Shared> shared_;  // with the thread
  Background<BatchEnd> work_;
};

}  // namespace replan
