#include "core/experiment/world_experiment.hpp"

#include <filesystem>

#include "core/base/file.hpp"

namespace replan {
namespace {

namespace fs = std::filesystem;

/// Writes a file that may be there already, but not with anything else in it. `what` begins the error's sentence.
Result<void> put_file(const std::string& path, const std::string& bytes, const std::string& what) {
  if (!fs::exists(path)) return write_file_atomically(path, bytes);
  const auto there = read_file(path);
  if (!there) return Error{there.error()};
  if (*there == bytes) return {};
  return Error{"'" + path + "' is " + what + ": give another folder"};
}

/// A word that a shell hands on as it is.
std::string shell_word(const std::string& word) {
  constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=:,+@";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

std::string kept_world_file(const std::string& name) {
  std::string file;
  for (const char c : name) {
    const bool strange = static_cast<unsigned char>(c) < 0x20 ||
                         std::string_view("/\\*?[]{}:").find(c) != std::string_view::npos;
    file += strange ? '-' : c;
  }
  return "worlds/" + (file.empty() ? "world" : file) + ".json";
}

Result<Experiment> put_world(const WorldExperiment& what, const std::string& folder) {
  if (what.world == nullptr) return what.experiment;
  std::error_code failed;
  fs::create_directories(fs::path(folder) / "worlds", failed);
  if (failed) return Error{"cannot make the folder '" + folder + "': " + failed.message()};
  Scenario world = *what.world;
  world.map_file.clear();  // with its cells in it: the map's own file may change
  const std::string file = what.experiment.worlds.front().file;
  const auto put = put_file((fs::path(folder) / file).string(), scenario_text(world),
                            "another world than the one in hand");
  if (!put) return Error{put.error()};
  return parse_experiment(experiment_text(what.experiment), kExperimentFile, folder);
}

Result<void> put_experiment(const Experiment& experiment, const std::string& path) {
  return put_file(path, experiment_text(experiment), "another experiment");
}

std::string batch_command_line(const std::string& file, const std::string& folder, std::size_t jobs) {
  return "replan batch " + shell_word(file) + " --out " + shell_word(folder) +
         (jobs > 1 ? " --jobs " + std::to_string(jobs) : "");
}

}  // namespace replan
