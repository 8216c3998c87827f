// An experiment in a world that is in hand and maybe in no file yet: it is put into a folder with its world beside it, so that
// nothing that happens to the world later changes the experiment, and `replan batch` on that folder makes the same runs.
#pragma once

#include <memory>
#include <string>

#include "core/experiment/experiment.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// The name of the experiment's file in a folder that put_experiment() writes to.
inline constexpr const char* kExperimentFile = "experiment.json";

/// An experiment, and the world that it is in; without one its worlds are files already.
struct WorldExperiment {
  Experiment experiment;
  std::shared_ptr<const Scenario> world = {};
};

/// Where the world of an experiment is kept, from the experiment's folder: "worlds/demo.json" of "demo". What no file name
/// or pattern should have in it becomes a hyphen.
std::string kept_world_file(const std::string& name);

/// Writes the world below the folder and returns the experiment as it is there. Without a world of its own: the experiment as
/// it is. Refused: another world of that name is there already.
Result<Experiment> put_world(const WorldExperiment& what, const std::string& folder);
/// Writes the experiment's file, unless it is there already. Refused: another experiment is.
Result<void> put_experiment(const Experiment& experiment, const std::string& path);

/// The command line that makes the runs of the experiment in that file, as a shell takes it.
std::string batch_command_line(const std::string& file, const std::string& folder, std::size_t jobs);

}  // namespace replan
