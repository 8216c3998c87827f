#include "ui/shell/documents.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/base/file.hpp"
#include "core/world/ends.hpp"
#include "core/world/map_file.hpp"

namespace replan::ui {
namespace {

Scenario world_of(GridMap map, const Scenario& current) {
  Scenario scenario;
  scenario.map = std::move(map);
  scenario.planners = current.planners;
  scenario.robot = current.robot;
  scenario.goal = {scenario.map.width - 1, scenario.map.height - 1};
  return scenario;
}

/// Whether the file that a scenario names for its map would still hold that map, seen from `folder`.
bool map_file_holds(const Scenario& scenario, const std::string& folder) {
  const std::filesystem::path path = std::filesystem::path(folder) / scenario.map_file;
  const Result<GridMap> map = read_map(path.string(), scenario.map_reading);
  return map && *map == scenario.map;
}

}  // namespace

Result<Scenario> open_document(const std::string& path, const Scenario& current) {
  if (path.empty()) return Error{"Type the path of a scenario (.json), a map (.map) or a picture (.png)."};
  if (file_extension(path) == ".json") return read_scenario(path);
  if (file_extension(path) == ".scen")
    return Error{path + ": a .scen file lists problems, not a world; open the .map that it is for"};
  Result<GridMap> map = read_map(path);
  if (!map) return Error{map.error()};
  Scenario scenario = world_of(*std::move(map), current);
  scenario.name = file_stem(path);
  place_ends(scenario);
  return scenario;
}

Scenario empty_world(int width, int height, const Scenario& current) {
  Scenario scenario = world_of(GridMap(width, height), current);
  scenario.name = "New world";
  scenario.start = {width / 8, height / 2};
  scenario.goal = {width - 1 - width / 8, height / 2};
  return scenario;
}

bool saves_in_place(const std::string& path) {
  return file_extension(path) == ".json" || file_extension(path) == ".map";
}

Result<void> save_document(const Session& session, const ViewState& view, const std::string& path) {
  const std::string kind = file_extension(path);
  if (path.empty())
    return Error{"Type the path of the file to write: NAME.json, or NAME.map for the cells alone."};
  Scenario scenario = session.to_save();
  if (kind == ".map") return write_map(scenario.map, path);
  if (kind != ".json")
    return Error{"End the name with .json for the whole scenario, or with .map for the cells alone."};
  if (!scenario.map_file.empty() && !map_file_holds(scenario, file_folder(path))) scenario.map_file.clear();
  scenario.view.overlays.clear();
  for (const OverlayInfo& info : overlays())
    if (view.view.overlays.has(info.overlay)) scenario.view.overlays.emplace_back(info.id);
  return write_scenario(scenario, path);
}

std::string document_name(const Session& session) {
  if (!session.file().empty()) return file_name(session.file());
  return session.scenario().name.empty() ? "untitled" : session.scenario().name;
}

std::string typed_path(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  std::string path = text.substr(first, text.find_last_not_of(" \t") - first + 1);
  const char* home = std::getenv("HOME");
  if (home != nullptr && (path == "~" || path.starts_with("~/"))) path.replace(0, 1, home);
  return path;
}

}  // namespace replan::ui
