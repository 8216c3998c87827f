#include "core/world/formats/npy_map.hpp"

#include <algorithm>

#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(npy_map) {
  for (const std::optional<double> occupied : {std::optional<double>(), std::optional<double>(1)}) {
    const auto world = parse_npy_map(input, "f.npy", occupied);
    require_good_error(world, "f.npy:");
    if (!world) continue;
    const auto& cells = world->map.blocked;
    require(cells.size() ==
                static_cast<std::size_t>(world->map.width) * static_cast<std::size_t>(world->map.height),
            "there are as many cells as the shape says");
    const auto& numbers = world->found.numbers;
    require(std::is_sorted(numbers.begin(), numbers.end()) && !numbers.empty(),
            "the numbers are told in order");
    for (const double number : numbers)
      require(parse_npy_map(input, "f.npy", number).ok(), "any of its numbers can be the obstacle");
  }
}
