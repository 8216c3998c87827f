// What map formats cannot hold, so that nothing is dropped in silence.
#include <algorithm>

#include "core/world/json_reader.hpp"
#include "core/world/map_file.hpp"
#include "core/world/scenario.hpp"

namespace replan {
namespace {

std::string number(double value) {
  return plain_number(value).dump();
}

std::string cell(Cell c) {
  return "(" + std::to_string(c.x) + ", " + std::to_string(c.y) + ")";
}

std::string many(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// How a file of that extension begins a sentence of loss.
std::string cannot_hold(std::string_view extension) {
  return std::string(extension) + " cannot hold ";
}

void lost_ends(const MapFile& file, const MapFormat& format, std::vector<std::string>& lost) {
  const bool text = format.extension == ".txt";
  for (const auto& [name, end] : {std::pair{"start", &file.start}, std::pair{"goal", &file.goal}}) {
    if (!end->has_value()) continue;
    const std::string what = std::string("the ") + name + " " + cell(**end);
    if (!format.ends)
      lost.push_back(cannot_hold(format.extension) + what);
    else if (text && file.map.at(**end))
      lost.push_back(cannot_hold(format.extension) + what + ", which lies in an obstacle");
  }
  if (text && file.start && file.start == file.goal && !file.map.at(*file.start))
    lost.push_back(cannot_hold(format.extension) + "the goal, which is the start");
}

}  // namespace

std::vector<std::string> lost_in(std::string_view extension, const MapFile& file) {
  std::vector<std::string> lost;
  const MapFormat* format = find_map_format("x" + std::string(extension));
  if (format == nullptr) return lost;
  const GridMap& map = file.map;
  const auto unmapped =
      static_cast<std::size_t>(std::count(map.blocked.begin(), map.blocked.end(), kUnmapped));
  if (!format->resolution && map.resolution != 1)
    lost.push_back(cannot_hold(extension) + "the resolution (" + number(map.resolution) + " a cell)");
  if (!format->resolution && map.origin != std::array<double, 3>{})
    lost.push_back(cannot_hold(extension) + "the origin (" + number(map.origin[0]) + ", " +
                   number(map.origin[1]) + ", " + number(map.origin[2]) + ")");
  if (unmapped > 0 && !format->unmapped)
    lost.push_back(cannot_hold(extension) + "that " + many(unmapped, "obstacle") + " " +
                   (unmapped == 1 ? "is" : "are") + " unmapped: there they are plain obstacles");
  if (unmapped > 0 && format->unknown)
    lost.push_back(
        "a ROS map has unmapped obstacles as unknown cells: only read with 'unmapped' for unknown cells "
        "are they what they were");
  lost_ends(file, *format, lost);
  return lost;
}

std::vector<std::string> lost_in(std::string_view extension, const Scenario& scenario) {
  if (extension == ".json") return {};
  std::vector<std::string> lost = lost_in(extension, MapFile{scenario.map, scenario.start, scenario.goal});
  const std::string planners = many(scenario.planners.size(), "planner");
  std::string rest = "the " + (scenario.planners.size() == 1 ? "planner" : planners) + " and the robot";
  if (!scenario.surprises.empty()) rest = many(scenario.surprises.size(), "surprise") + ", " + rest;
  lost.push_back(cannot_hold(extension) + rest);
  if (!scenario.name.empty() || !scenario.caption.empty() || scenario.view != ViewSetup{})
    lost.push_back(cannot_hold(extension) + "name, caption and view");
  return lost;
}

}  // namespace replan
