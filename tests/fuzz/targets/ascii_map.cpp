#include "core/world/ascii_map.hpp"

#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(ascii_map) {
  const auto world = parse_ascii_map(input, "f.txt");
  require_good_error(world, "f.txt:");
  if (!world) return;
  const auto again = parse_ascii_map(ascii_text(*world), "again.txt");
  require(again.ok() && *again == *world, "what was written is read back equal");
}
