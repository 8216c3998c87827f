#include "core/world/ends.hpp"

#include <vector>

namespace replan {
namespace {

/// Free cells around a start or goal each way, where the region has such places: a robot at the rim of a scan
/// would see little of the world.
constexpr int kRoom = 3;

/// The two cells of a set that are nearest to the first corner of the world, the upper left one, and to the last.
struct Ends {
  std::size_t first = 0, last = 0;
  std::size_t nearest = SIZE_MAX, farthest = 0;  ///< x + y + z of the two
  bool found = false;

  [[nodiscard]] bool wants(std::size_t diagonal) const {
    return !found || diagonal < nearest || diagonal >= farthest;
  }
  void take(std::size_t cell, std::size_t diagonal) {
    if (!found || diagonal < nearest) nearest = diagonal, first = cell;
    if (!found || diagonal >= farthest) farthest = diagonal, last = cell;
    found = true;
  }
  [[nodiscard]] std::size_t spread() const { return farthest - nearest; }
};

/// Free cells that can be reached from one another by straight moves.
struct Region {
  std::size_t cells = 0;
  Ends any, roomy;

  /// The roomy ones, unless all the room is in one part of the region. What keeping off the rim takes at both ends is no
  /// nearness.
  [[nodiscard]] const Ends& ends() const {
    const bool apart = roomy.first != roomy.last && 2 * (roomy.spread() + 4 * kRoom) >= any.spread();
    return roomy.found && apart ? roomy : any;
  }
};

bool has_room(const GridMap& map, std::size_t index) {
  const Cell at = map.box().position(static_cast<NodeId>(index));
  const int layers = map.depth > 1 ? kRoom : 0;
  for (int z = at.z - layers; z <= at.z + layers; ++z)
    for (int y = at.y - kRoom; y <= at.y + kRoom; ++y)
      for (int x = at.x - kRoom; x <= at.x + kRoom; ++x)
        if (!map.contains({x, y, z}) || map.at({x, y, z})) return false;
  return true;
}

/// The region around `from`, whose cells it marks in `seen`. Only the rim of what was reached is kept in
/// memory: the largest maps have 2^26 cells.
Region region_around(const GridMap& map, std::size_t from, std::vector<std::uint8_t>& seen,
                     const StopToken& stop) {
  const auto width = static_cast<std::size_t>(map.width), height = static_cast<std::size_t>(map.height),
             layer = width * height;
  Region region;
  std::vector<std::size_t> rim = {from}, next;
  seen[from] = 1;
  for (; !rim.empty() && !stop.stop_requested(); rim.swap(next), next.clear())
    for (const std::size_t at : rim) {
      // Divisions are most of the cost of this walk over up to 2^26 cells: a plane is spared two of them.
      const std::size_t row = at / width, z = map.depth > 1 ? row / height : 0, y = row - z * height,
                        x = at - row * width, here = x + y + z;
      const auto visit = [&](bool inside, std::size_t cell) {
        if (!inside || seen[cell] != 0 || map.blocked[cell] != 0) return;
        seen[cell] = 1;
        next.push_back(cell);
      };
      ++region.cells;
      region.any.take(at, here);
      if (region.roomy.wants(here) && has_room(map, at)) region.roomy.take(at, here);
      visit(x > 0, at - 1);
      visit(x + 1 < width, at + 1);
      visit(y > 0, at - width);
      visit(y + 1 < height, at + width);
      visit(z > 0, at - layer);
      visit(at + layer < map.blocked.size(), at + layer);
    }
  return region;
}

}  // namespace

void place_ends(Scenario& scenario, const StopToken& stop) {
  const GridMap& map = scenario.map;
  std::vector<std::uint8_t> seen(map.blocked.size());
  Region largest;
  for (std::size_t i = 0; i < map.blocked.size() && !stop.stop_requested(); ++i) {
    if (seen[i] != 0 || map.blocked[i] != 0) continue;
    const Region found = region_around(map, i, seen, stop);
    if (found.cells > largest.cells) largest = found;
  }
  if (largest.cells == 0) return;
  const auto cell = [&map](std::size_t index) { return map.box().position(static_cast<NodeId>(index)); };
  scenario.start = cell(largest.ends().first);
  scenario.goal = cell(largest.ends().last);
}

std::string unknown_end_sentence(const Scenario& scenario, bool start) {
  const std::size_t cell = scenario.map.index(start ? scenario.start : scenario.goal);
  if (!scenario.map_found.is_unknown(scenario.map, cell) || scenario.map.blocked[cell] == kFree) return "";
  return std::string(start ? "The start" : "The goal") +
         " is unknown on the map, and unknown cells are obstacles here: move it, or read them as free (" +
         (scenario.map_file.empty() ? "--unknown free, or in the Open dialog"
                                    : "\"unknown\": \"free\" beside the map's \"file\"") +
         ").";
}

}  // namespace replan
