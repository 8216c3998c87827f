#include "core/world/formats/movingai.hpp"
#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(movingai_map) {
  const auto map = parse_movingai_map(input, "f.map");
  require_good_error(map, "f.map:");
  if (!map) return;
  const auto again = parse_movingai_map(movingai_map_text(*map), "again.map");
  require(again.ok() && *again == *map, "what was written is read back equal");
}
