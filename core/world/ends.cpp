#include "core/world/ends.hpp"

#include <algorithm>
#include <vector>

namespace replan {
namespace {

/// The free cells that can be reached from `from` by straight moves; marks them in `seen`.
std::vector<std::size_t> region(const GridMap& map, std::size_t from, std::vector<std::uint8_t>& seen) {
  std::vector<std::size_t> cells = {from};
  seen[from] = 1;
  const auto width = static_cast<std::size_t>(map.width);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t at = cells[i], x = at % width;
    const auto visit = [&](bool inside, std::size_t next) {
      if (!inside || seen[next] != 0 || map.blocked[next] != 0) return;
      seen[next] = 1;
      cells.push_back(next);
    };
    visit(x > 0, at - 1);
    visit(x + 1 < width, at + 1);
    visit(at >= width, at - width);
    visit(at + width < map.blocked.size(), at + width);
  }
  return cells;
}

}  // namespace

void place_ends(Scenario& scenario) {
  const GridMap& map = scenario.map;
  std::vector<std::uint8_t> seen(map.blocked.size());
  std::vector<std::size_t> largest;
  for (std::size_t i = 0; i < map.blocked.size(); ++i) {
    if (seen[i] != 0 || map.blocked[i] != 0) continue;
    std::vector<std::size_t> found = region(map, i, seen);
    if (found.size() > largest.size()) largest = std::move(found);
  }
  if (largest.empty()) return;
  const auto width = static_cast<std::size_t>(map.width);
  const auto diagonal = [width](std::size_t cell) { return cell % width + cell / width; };
  const auto [first, last] =
      std::minmax_element(largest.begin(), largest.end(),
                          [&](std::size_t a, std::size_t b) { return diagonal(a) < diagonal(b); });
  const auto cell = [width](std::size_t index) {
    return Cell{static_cast<int>(index % width), static_cast<int>(index / width)};
  };
  scenario.start = cell(*first);
  scenario.goal = cell(*last);
}

}  // namespace replan
