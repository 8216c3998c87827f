#include "core/world/formats/voxel_map.hpp"
#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(voxel_scen) {
  const auto scen = parse_voxel_scen(input, "f.3dscen");
  require_good_error(scen, "f.3dscen:");
  if (!scen) return;
  const auto again = parse_voxel_scen(scen_text(*scen), "again.3dscen");
  require(again.ok(), "what was written is read back");
  require(scen_text(*again) == scen_text(*scen), "and is written the same again");
}
