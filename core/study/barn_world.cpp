#include <nlohmann/json.hpp>

#include "core/base/file.hpp"
#include "core/study/barn.hpp"
#include "core/world/formats/movingai.hpp"

namespace replan {
namespace {

using nlohmann::json;

BarnWorld world_of(const json& common, const json& entry, const GridMap& map) {
  BarnWorld world;
  world.number = entry.at("world").get<int>();
  world.cell = common.at("resolution").get<double>();
  world.width = map.width * world.cell;
  world.height = map.height * world.cell;
  world.disc_radius = common.at("cylinder_radius").get<double>();
  const json &start = common.at("start"), &goal = common.at("goal");
  world.start = {start.at("x").get<double>(), start.at("y").get<double>(), start.at("heading").get<double>()};
  world.goal = {goal.at("x").get<double>(), goal.at("y").get<double>()};
  world.tolerance = common.at("goal_tolerance").get<double>();
  world.timeout = common.at("timeout").get<double>();
  world.optimal_time = entry.at("optimal_time").get<double>();
  const CellFrame frame{map.box(), world.cell};
  for (NodeId node = 0; node < map.box().node_count(); ++node)
    if (map.blocked[node] != 0) world.discs.push_back(frame.centre(map.box().position(node)));
  return world;
}

}  // namespace

Result<std::vector<BarnWorld>> read_barn(const std::string& folder) {
  const std::string path = folder + "/index.json";
  const auto text = read_file(path);
  if (!text) return Error{text.error()};
  std::vector<BarnWorld> worlds;
  try {
    const json index = json::parse(*text);
    for (const json& entry : index.at("worlds")) {
      const auto map = read_movingai_map(folder + "/" + entry.at("file").get<std::string>());
      if (!map) return Error{map.error()};
      worlds.push_back(world_of(index.at("common"), entry, *map));
    }
  } catch (const json::exception& error) {
    return Error{path + " is not an index of BARN worlds: " + error.what() + "."};
  }
  return worlds;
}

}  // namespace replan
