#include "core/world/generators/parts.hpp"

#include <string>

#include "core/plan/parameters.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

constexpr Cell kSides[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

Cell sum(Cell a, Cell b) {
  return {a.x + b.x, a.y + b.y};
}

/// Digs from one cell to the nearest free one, found in rings around it.
void dig(GridMap& map, Cell from) {
  std::vector<Cell> came(map.blocked.size(), Cell{-1, -1});
  std::vector<Cell> ring{from};
  came[map.index(from)] = from;
  for (std::size_t next = 0; next < ring.size(); ++next) {
    const Cell here = ring[next];
    if (here != from && !map.at(here)) {
      for (Cell back = here; back != from; back = came[map.index(back)]) map.set(back, false);
      break;
    }
    for (const Cell step : kSides) {
      const Cell there = sum(here, step);
      if (!map.contains(there) || came[map.index(there)] != Cell{-1, -1}) continue;
      came[map.index(there)] = here;
      ring.push_back(there);
    }
  }
  map.set(from, false);
}

}  // namespace

Result<void> check_fraction(const char* name, double fraction, double low, double high) {
  if (fraction >= low && fraction <= high) return {};
  return Error{std::string(name) + " cannot be " + std::to_string(fraction) + ": give a number from " +
               plain_number(low).dump() + " to " + plain_number(high).dump()};
}

std::vector<Passage> random_tree(int columns, int rows, Random& random) {
  std::vector<std::uint8_t> met(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  const auto index = [&](Cell place) {
    return static_cast<std::size_t>(place.y) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(place.x);
  };
  std::vector<Passage> tree;
  std::vector<Cell> way{{0, 0}};
  met[0] = 1;
  while (!way.empty()) {
    const Cell here = way.back();
    Cell choices[4];
    std::uint32_t count = 0;
    for (const Cell step : kSides) {
      const Cell there = sum(here, step);
      const bool inside = there.x >= 0 && there.y >= 0 && there.x < columns && there.y < rows;
      if (inside && met[index(there)] == 0) choices[count++] = step;
    }
    if (count == 0) {
      way.pop_back();
      continue;
    }
    tree.push_back({here, choices[random.below(count)]});
    way.push_back(sum(here, tree.back().step));
    met[index(way.back())] = 1;
  }
  return tree;
}

void dig_to_open(GridMap& map, std::span<const Cell> cells) {
  for (const Cell cell : cells)
    if (map.contains(cell) && map.at(cell)) dig(map, cell);
}

}  // namespace replan
