#include "core/world/formats/sbpl_cfg.hpp"

#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(sbpl_cfg) {
  auto world = parse_sbpl_cfg(input, "f.cfg");
  require_good_error(world, "f.cfg:");
  if (!world) return;
  world->map.resolution = 1;  // what is written is a nav2d environment, in cells
  const auto again = parse_sbpl_cfg(sbpl_cfg_text(*world), "again.cfg");
  require(again.ok() && *again == *world, "what was written is read back equal");
}
