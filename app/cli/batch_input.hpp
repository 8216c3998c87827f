// What 'replan batch' is told: an experiment, or files of problems and planners, and what is to be done with it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/arguments.hpp"
#include "core/experiment/experiment.hpp"
#include "core/experiment/results_folder.hpp"
#include "core/experiment/run_list.hpp"

namespace replan::cli {

/// As typed.
struct BatchArguments {
  std::vector<std::string> files;
  std::string map;
  std::string limit;
  ReadingArguments reading;
  PlannerArguments planners;
  std::string folder;
  std::string jobs;
  std::string shard;
  std::string scenario;
  std::string open;
  std::string output;
  bool json = false;

  /// The runs of an experiment's file; or of problems, with the planners that were asked for.
  [[nodiscard]] Result<RunList> runs() const;
  /// The whole of it unless a part was asked for.
  [[nodiscard]] Result<Shard> part() const;
  [[nodiscard]] Result<std::size_t> threads() const;
  [[nodiscard]] bool of_problems() const;
};

}  // namespace replan::cli
