// The files of an experiment's worlds.
#include "core/base/file.hpp"
#include "core/base/hash.hpp"
#include "core/base/words.hpp"
#include "core/experiment/run_list.hpp"
#include "core/world/generators/list.hpp"
#include "core/world/map_file.hpp"

namespace replan {
namespace {

/// Of the bytes of the files. A map's file may name others (a ROS map its picture), so its cells count besides.
Result<std::uint64_t> digest_of(std::span<const std::string> files, const GridMap& map) {
  std::uint64_t digest = 0;
  for (const std::string& file : files) {
    const auto bytes = read_file(file);
    if (!bytes) return Error{bytes.error()};
    digest = hash_combine(digest, hash_bytes(*bytes));
  }
  std::uint64_t cells = hash_bytes({});
  for (const std::uint8_t cell : map.blocked) cells = (cells ^ cell) * 0x100000001B3ull;
  return hash_combine(digest, cells);
}

Cell cell_of_coordinates(const std::vector<int>& coordinates) {
  return {coordinates[0], coordinates[1], coordinates.size() > 2 ? coordinates[2] : 0};
}

/// A cell as the experiment gives it, if it is on the map.
Result<Cell> cell_on(const std::vector<int>& coordinates, const GridMap& map, const std::string& file,
                     std::string_view what) {
  const Box box = map.box();
  if (coordinates.size() != (box.solid() ? 3u : 2u))
    return Error{file + ": the " + std::string(what) + " needs " + (box.solid() ? "three" : "two") +
                 " coordinates in this world"};
  const Cell cell = cell_of_coordinates(coordinates);
  if (box.contains(cell)) return cell;
  return Error{file + ": the " + std::string(what) + " " + cell_text(cell, box.solid()) +
               " is not on the map"};
}

Result<LoadedWorld> load_problems(const Experiment& experiment, const ExperimentWorld& world,
                                  LoadedWorld loaded) {
  const std::string path = path_in(experiment, world.file);
  auto scen = read_scen(path);
  if (!scen) return Error{scen.error()};
  const auto map_path = world.map.empty() ? map_beside(path, scen->map_name) : path_in(experiment, world.map);
  if (!map_path) return Error{map_path.error()};
  auto file = read_map_file(loaded.map_file = *map_path, world.reading);
  if (!file) return Error{file.error()};
  if (const auto fits = check_scen_fits(*scen, file->map, *map_path); !fits) return Error{fits.error()};
  loaded.notes = file->found.notes_for_planning();
  loaded.scenario.map = std::move(file->map);
  loaded.lengths = scen->lengths;
  loaded.problems = even_sample(scen->problems, world.limit);
  return loaded;
}

Result<LoadedWorld> load_map(const Experiment& experiment, const ExperimentWorld& world, LoadedWorld loaded) {
  const bool generated = is_generator_spec(world.file);
  loaded.map_file = generated ? world.file : path_in(experiment, world.file);
  std::vector<Cell> ends;  // a generated map leaves them free
  for (const auto* given : {&world.start, &world.goal})
    if (generated && *given) ends.push_back(cell_of_coordinates(**given));
  auto file = open_map(loaded.map_file, world.reading, ends);
  if (!file) return Error{file.error()};
  ScenProblem question;
  for (const auto& [what, given, own, cell] :
       {std::tuple{"start", &world.start, &file->start, &question.start},
        std::tuple{"goal", &world.goal, &file->goal, &question.goal}}) {
    if (!*given && !*own)
      return Error{world.file + ": the map has no " + what +
                   ": give one, {\"file\": ..., \"start\": [x, y], \"goal\": [x, y]}"};
    const auto place = *given ? cell_on(**given, file->map, world.file, what) : Result<Cell>(**own);
    if (!place) return Error{place.error()};
    *cell = *place;
  }
  loaded.notes = file->found.notes_for_planning();
  loaded.scenario.map = std::move(file->map);
  loaded.problems = {question};
  return loaded;
}

Result<LoadedWorld> load_scenario(const Experiment& experiment, const ExperimentWorld& world,
                                  LoadedWorld loaded) {
  auto scenario = read_scenario(loaded.map_file = path_in(experiment, world.file));
  if (!scenario) return Error{scenario.error()};
  loaded.notes = scenario->map_found.notes_for_planning();
  loaded.scenario = std::move(scenario.value());
  ScenProblem question;
  question.start = loaded.scenario.start;
  question.goal = loaded.scenario.goal;
  loaded.problems = {question};
  return loaded;
}

}  // namespace

std::vector<ScenProblem> even_sample(const std::vector<ScenProblem>& problems, std::size_t limit) {
  if (limit == 0 || limit >= problems.size()) return problems;
  std::vector<ScenProblem> sample;
  sample.reserve(limit);
  const std::size_t gaps = limit > 1 ? limit - 1 : 1;
  for (std::size_t i = 0; i < limit; ++i) sample.push_back(problems[i * (problems.size() - 1) / gaps]);
  return sample;
}

Result<LoadedWorld> load_world(const Experiment& experiment, const ExperimentWorld& world) {
  const std::string extension = file_extension(world.file);
  LoadedWorld named;
  named.file = world.file;
  auto loaded = extension == ".scen" || extension == ".3dscen"
                    ? load_problems(experiment, world, std::move(named))
                : extension == ".json" ? load_scenario(experiment, world, std::move(named))
                                       : load_map(experiment, world, std::move(named));
  if (!loaded) return loaded;
  std::vector<std::string> files;
  if (!is_generator_spec(world.file)) files = {path_in(experiment, world.file)};
  if (!files.empty() && loaded->map_file != files.front()) files.push_back(loaded->map_file);
  const auto digest = digest_of(files, loaded->scenario.map);
  if (!digest) return Error{digest.error()};
  loaded->digest = *digest;
  return loaded;
}

}  // namespace replan
