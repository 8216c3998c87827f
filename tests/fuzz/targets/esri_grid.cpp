#include "core/world/formats/esri_grid.hpp"

#include <algorithm>

#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(esri_grid) {
  auto grid = parse_esri_grid(input, "f.asc");
  require_good_error(grid, "f.asc:");
  if (!grid || grid->heights.size() > 100'000) return;
  const auto columns = static_cast<std::size_t>(grid->width) * static_cast<std::size_t>(grid->height);
  require(grid->heights.size() == columns, "there is a height for each column");
  for (const int reduce : {0, 3}) {
    const auto world = world_over(*grid, {.layers = 5, .reduce = reduce}, "f.asc");
    require_good_error(world, "f.asc:");
    if (!world) continue;
    const GridMap& map = world->map;
    require(map.depth == 5 && !world->found.notes.empty(),
            "there are as many layers as asked for, and a note");
    for (int z = 1; z < map.depth; ++z)
      for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
          require(!map.at({x, y, z}) || map.at({x, y, z - 1}), "below an obstacle there is rock");
  }
}
