#include "app/cli/batch_input.hpp"

#include <algorithm>

#include "core/base/file.hpp"
#include "core/world/formats/movingai.hpp"
#include "core/world/formats/text_lines.hpp"
#include "core/world/map_file.hpp"

namespace replan::cli {
namespace {

bool is_problems(const std::string& file) {
  const std::string extension = file_extension(file);
  return extension == ".scen" || extension == ".3dscen";
}

/// A file of problems as an experiment's world.
Result<ExperimentWorld> world_of(const std::string& file, const BatchArguments& arguments,
                                 std::size_t limit) {
  ExperimentWorld world{.file = file, .map = arguments.map, .limit = limit};
  const auto scen = read_scen(file);
  if (!scen) return Error{scen.error()};
  const auto map = arguments.map.empty() ? map_beside(file, scen->map_name) : arguments.map;
  if (!map) return Error{map.error()};
  const auto how = arguments.reading.reading(*map);
  if (!how) return Error{how.error()};
  world.reading = *how;
  return world;
}

Result<RunList> runs_of_problems(const BatchArguments& arguments) {
  Experiment experiment;
  experiment.surprises = {{ExperimentSurprises::Kind::none, {}}};
  const auto asked = arguments.planners.choose();
  if (!asked) return Error{asked.error()};
  const auto limit = arguments.limit.empty() ? 0 : parse_count("--limit", arguments.limit, 1);
  if (!limit) return Error{limit.error()};
  for (const std::string& file : arguments.files) {
    auto world = world_of(file, arguments, static_cast<std::size_t>(*limit));
    if (!world) return Error{world.error()};
    experiment.worlds.push_back(std::move(world.value()));
  }
  // "all" are those that can plan in the first file's world.
  auto first = load_world(experiment, experiment.worlds.front());
  if (!first) return Error{first.error()};
  auto planners = arguments.planners.choose({}, &first->scenario.map);
  if (!planners) return Error{planners.error()};
  experiment.planners = std::move(planners.value());
  std::vector<LoadedWorld> loaded;
  loaded.push_back(std::move(first.value()));
  return RunList::load(std::move(experiment), std::move(loaded));
}

/// An experiment's file says everything itself.
Result<void> check_nothing_else(const BatchArguments& arguments) {
  const std::string given = !arguments.planners.ids.empty()        ? "--planner"
                            : !arguments.planners.settings.empty() ? "--set"
                            : !arguments.planners.stages.empty()   ? "--stage"
                            : !arguments.map.empty()               ? "--map"
                            : !arguments.limit.empty()             ? "--limit"
                            : arguments.reading.given()            ? "How a map is read"
                                                                   : "";
  if (given.empty()) return {};
  return Error{given + " goes with files of problems; the experiment '" + arguments.files.front() +
               "' says that itself"};
}

}  // namespace

bool BatchArguments::of_problems() const {
  return std::all_of(files.begin(), files.end(), is_problems);
}

Result<RunList> BatchArguments::runs() const {
  if (of_problems()) return runs_of_problems(*this);
  if (files.size() > 1)
    return Error{"give one experiment (.json), or files of problems (.scen, .3dscen) alone"};
  if (file_extension(files.front()) != ".json")
    return Error{"'" + files.front() + "' is no experiment (.json) and no file of problems (.scen, .3dscen)"};
  if (const auto fine = check_nothing_else(*this); !fine) return Error{fine.error()};
  auto experiment = read_experiment(files.front());
  if (!experiment) return Error{experiment.error()};
  return RunList::load(std::move(experiment.value()));
}

Result<Shard> BatchArguments::part() const {
  if (shard.empty()) return Shard{};
  const std::size_t slash = shard.find('/');
  const auto index = number_from<std::int64_t>(shard.substr(0, slash));
  const auto count =
      slash == std::string::npos ? std::nullopt : number_from<std::int64_t>(shard.substr(slash + 1));
  if (!index || !count || *count < 1 || *count > kMostShards || *index < 1 || *index > *count)
    return Error{"--shard cannot be '" + shard + "': give I/N, the part I from 1 to N of N parts"};
  if (folder.empty()) return Error{"--shard needs --out DIR: the parts are put together by 'replan merge'"};
  return Shard{*index - 1, *count};
}

Result<std::size_t> BatchArguments::threads() const {
  constexpr std::int64_t kMostJobs = 1024;
  if (jobs.empty()) return std::size_t{1};
  const auto count = parse_count("--jobs", jobs, 1);
  if (!count) return Error{count.error()};
  if (*count > kMostJobs) return Error{"--jobs can be at most " + std::to_string(kMostJobs)};
  return static_cast<std::size_t>(*count);
}

}  // namespace replan::cli
