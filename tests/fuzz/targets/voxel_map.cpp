#include "core/world/formats/voxel_map.hpp"

#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(voxel_map) {
  const auto map = parse_voxel_map(input, "f.3dmap");
  require_good_error(map, "f.3dmap:");
  if (!map || map->blocked.size() > 1'000'000) return;
  const auto again = parse_voxel_map(voxel_map_text(*map), "again.3dmap");
  require(again.ok() && *again == *map, "what was written is read back equal");
  require(voxel_slice(*map, map->depth - 1).ok() && !voxel_slice(*map, map->depth).ok(),
          "slices end with the box");
}
