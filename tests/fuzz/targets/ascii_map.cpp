#include "core/world/formats/ascii_map.hpp"

#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(ascii_map) {
  for (const std::optional<double> occupied : {std::optional<double>(), std::optional<double>(1)}) {
    const auto world = parse_ascii_map(input, "f.txt", occupied);
    require_good_error(world, "f.txt:");
    if (!world) continue;
    const auto again = parse_ascii_map(ascii_text(*world), "again.txt");
    require(again.ok() && *again == *world, "what was written is read back equal");
    for (const double number : world->found.numbers)
      require(parse_ascii_map(input, "f.txt", number).ok(), "any of its numbers can be the obstacle");
  }
}
