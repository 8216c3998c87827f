// What map formats cannot hold, so that nothing is dropped in silence.
#include <algorithm>

#include "core/base/words.hpp"
#include "core/world/json_reader.hpp"
#include "core/world/map_file.hpp"
#include "core/world/scenario.hpp"

namespace replan {
namespace {

std::string number(double value) {
  return plain_number(value).dump();
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
    const std::string what = std::string("the ") + name + " " + cell_text(**end, file.map.depth > 1);
    if (!format.ends)
      lost.push_back(cannot_hold(format.extension) + what);
    else if (text && file.map.at(**end))
      lost.push_back(cannot_hold(format.extension) + what + ", which lies in an obstacle");
  }
  if (text && file.start && file.start == file.goal && !file.map.at(*file.start))
    lost.push_back(cannot_hold(format.extension) + "the goal, which is the start");
}

/// Unknown cells stay unknown in a ROS map alone; in others they are what they were read as.
void lost_unknown(const MapFile& file, const MapFormat& format, std::vector<std::string>& lost) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < file.map.blocked.size(); ++i)
    count += file.found.is_unknown(file.map, i) ? 1 : 0;
  if (count == 0 || format.unknown) return;
  const std::uint8_t kind = file.found.unknown_as;
  const bool one = count == 1;
  const char* become = kind == kFree ? (one ? "a free cell" : "free cells")
                       : kind == kUnmapped && format.unmapped
                           ? (one ? "an unmapped obstacle" : "unmapped obstacles")
                           : (one ? "an obstacle" : "obstacles");
  lost.push_back(cannot_hold(format.extension) + "that " + many(count, "cell") + (one ? " is" : " are") +
                 " unknown on the map: there " + (one ? "it is " : "they are ") + become);
}

}  // namespace

std::vector<std::string> lost_in(std::string_view extension, const MapFile& file) {
  std::vector<std::string> lost;
  constexpr MapFormat kScenario{
      .extension = ".json", .name = "scenario", .resolution = true, .unmapped = true, .ends = true};
  const MapFormat* format =
      extension == kScenario.extension ? &kScenario : find_map_format("x" + std::string(extension));
  if (format == nullptr) return lost;
  const GridMap& map = file.map;
  std::size_t unmapped = 0;  // but for the unknown ones, which are told apart
  for (std::size_t i = 0; i < map.blocked.size(); ++i)
    unmapped += map.blocked[i] == kUnmapped && !file.found.is_unknown(map, i) ? 1 : 0;
  if (!format->resolution && map.resolution != 1)
    lost.push_back(cannot_hold(extension) + "the resolution (" + number(map.resolution) + " a cell)");
  if (!format->resolution && map.origin != std::array<double, 3>{})
    lost.push_back(cannot_hold(extension) + "the origin (" + number(map.origin[0]) + ", " +
                   number(map.origin[1]) + ", " + number(map.origin[2]) + ")");
  lost_unknown(file, *format, lost);
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
  if (extension == ".json" && !scenario.map_file.empty()) return {};
  std::vector<std::string> lost =
      lost_in(extension, MapFile{scenario.map, scenario.start, scenario.goal, scenario.map_found});
  if (extension == ".json") return lost;
  const std::string planners = many(scenario.planners.size(), "planner");
  std::string rest = "the " + (scenario.planners.size() == 1 ? "planner" : planners) + " and the robot";
  if (!scenario.surprises.empty()) rest = many(scenario.surprises.size(), "surprise") + ", " + rest;
  lost.push_back(cannot_hold(extension) + rest);
  if (!scenario.name.empty() || !scenario.caption.empty() || scenario.view != ViewSetup{})
    lost.push_back(cannot_hold(extension) + "name, caption and view");
  return lost;
}

}  // namespace replan
