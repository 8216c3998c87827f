#include "ui/documents/files.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/base/file.hpp"
#include "core/world/choices.hpp"
#include "core/world/ends.hpp"
#include "core/world/map_file.hpp"

namespace replan::ui {
namespace {

Scenario world_of(GridMap map, const Scenario& current) {
  Scenario scenario;
  scenario.map = std::move(map);
  scenario.robot = current.robot;
  if (!require_robot(scenario.robot.kind, scenario.map.box())) scenario.robot = RobotSetup{};
  for (const PlannerChoice& choice : current.planners)
    if (fits(*find_choice(choice.id), scenario.map.box(), scenario.robot.radius))
      scenario.planners.push_back(choice);
  if (scenario.planners.empty()) scenario.planners.push_back({"dstar-lite", {}, {}});
  scenario.goal = {scenario.map.width - 1, scenario.map.height - 1, scenario.map.depth - 1};
  return scenario;
}

/// Whether the file that a scenario names for its map would still hold that map, seen from `folder`.
bool map_file_holds(const Scenario& scenario, const std::string& folder) {
  const std::filesystem::path path = std::filesystem::path(folder) / scenario.map_file;
  const Result<GridMap> map = read_map(path.string(), scenario.map_reading);
  return map && *map == scenario.map;
}

}  // namespace

Result<Scenario> open_document(const std::string& path, const Scenario& current, const MapReading& reading,
                               const StopToken& stop) {
  if (path.empty()) return Error{"Type the path of a scenario (.json), a map (.map) or a picture (.png)."};
  if (file_extension(path) == ".json") {
    Result<Scenario> scenario = read_scenario(path);
    if (!scenario) return scenario;
    return scenario;
  }
  if (file_extension(path) == ".scen")
    return Error{path + ": a .scen file lists problems, not a world; open the .map that it is for"};
  Result<MapFile> file = read_map_file(path, reading);
  if (!file) return Error{file.error()};
  Scenario scenario = world_of(std::move(file->map), current);
  scenario.map_found = std::move(file->found);
  scenario.name = file_stem(path);
  if (!file->start || !file->goal) place_ends(scenario, stop);
  if (file->start) scenario.start = *file->start;
  if (file->goal) scenario.goal = *file->goal;
  return scenario;
}

Scenario empty_world(const Box& size, const Scenario& current) {
  Scenario scenario = world_of(GridMap(size.width(), size.height(), size.depth()), current);
  scenario.name = "New world";
  const int margin = size.width() / 8;
  scenario.start = {margin, size.height() / 2, size.depth() / 2};
  scenario.goal = {size.width() - 1 - margin, size.height() / 2, size.depth() / 2};
  return scenario;
}

bool saves_in_place(const std::string& path) {
  const std::string extension = file_extension(path);
  return extension == ".json" || extension == ".map" || extension == ".3dmap";
}

bool saves_in_place(const Session& session) {
  return saves_in_place(session.file()) && !session.other_world() &&
         (file_extension(session.file()) == ".json" || session.only_cells_edited());
}

Result<void> save_document(const Session& session, const ViewState& view, const std::string& path) {
  if (path.empty())
    return Error{"Type the path of the file to write: NAME.json, or NAME.map for the cells alone."};
  Scenario scenario = session.to_save();
  if (file_extension(path) != ".json") {
    const MapFormat* format = find_map_format(path);
    if (format == nullptr || format->write == nullptr)
      return Error{"End the name with .json for the whole scenario, or with " +
                   map_extensions(MapUse::write) + " for the map alone."};
    return write_map_file(
        {std::move(scenario.map), scenario.start, scenario.goal, std::move(scenario.map_found)}, path);
  }
  if (!scenario.map_file.empty() && !map_file_holds(scenario, file_folder(path))) scenario.map_file.clear();
  scenario.view.overlays.clear();
  for (const OverlayInfo& info : overlays())
    if (view.view.overlays.has(info.overlay)) scenario.view.overlays.emplace_back(info.id);
  return write_scenario(scenario, path);
}

std::string document_name(const Session& session) {
  if (!session.file().empty() && !session.other_world()) return file_name(session.file());
  return session.scenario().name.empty() ? "untitled" : session.scenario().name;
}

std::string document_title(const Session& session) {
  return document_name(session) + (session.modified() ? " — edited" : "");
}

std::string uncommon_words(const Session& session, const std::string& also) {
  const std::string words = session.scenario().name + session.scenario().caption + session.file() + also;
  // Bytes from 0xE3 on begin characters of East Asia and beyond; all below are in the fonts at any time.
  const auto is_wide = [](char c) { return static_cast<unsigned char>(c) >= 0xE3; };
  return std::any_of(words.begin(), words.end(), is_wide) ? words : "";
}

Dropped sort_out(const std::vector<std::string>& paths) {
  const auto worth = [](const std::string& path) {
    std::error_code failed;
    if (std::filesystem::is_directory(path, failed)) return 1;
    if (file_extension(path) == ".json") return 4;
    const MapFormat* format = find_map_format(path);
    return format == nullptr ? 0 : format->picture ? 2 : 3;
  };
  if (paths.empty()) return {};
  const auto best =
      std::max_element(paths.begin(), paths.end(),
                       [&](const std::string& a, const std::string& b) { return worth(a) < worth(b); });
  Dropped dropped{*best, worth(*best) == 1, ""};
  if (worth(*best) == 0) {
    dropped.path.clear();
    dropped.sentence = "'" + file_name(*best) +
                       "' is no world: drop a scenario (.json), or a map that ends in " +
                       map_extensions(MapUse::read) + ".";
  } else if (paths.size() > 1) {
    dropped.sentence = "One world is open at a time: of " + std::to_string(paths.size()) +
                       " dropped files '" + file_name(*best) + "' was taken.";
  }
  return dropped;
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
