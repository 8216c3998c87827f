// Regions of free cells that straight steps join, in the plane and in space.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/world/generators/parts.hpp"

namespace replan {
namespace {

constexpr std::array<Cell, 6> kStraightSteps = {
    {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

/// The cells of a map by number, with what a search through them has met. Cells are plain, not shared: a search writes
/// and asks millions of them.
class RegionSearch {
 public:
  explicit RegionSearch(const GridMap& map)
      : box_(map.box()), blocked_(map.blocked.plain()), region_(blocked_.size()) {}

  /// Numbers the regions from 1 on, and returns the number of the largest, the first of several; 0 if there is none.
  std::uint32_t number_regions() {
    std::size_t most = 0;
    std::uint32_t largest = 0, next = 1;
    for (NodeId node = 0; node < blocked_.size(); ++node) {
      if (blocked_[node] != kFree || region_[node] != 0) continue;
      const std::size_t cells = mark_region(node, next);
      if (cells > most) most = cells, largest = next;
      ++next;
    }
    return largest;
  }
  [[nodiscard]] std::uint32_t region(NodeId node) const { return region_[node]; }

  template <class Visit>
  void each_neighbour(NodeId node, Visit visit) const {
    const Cell at = box_.position(node);
    for (const Cell& step : kStraightSteps)
      if (const Cell there{at.x + step.x, at.y + step.y, at.z + step.z}; box_.contains(there))
        visit(box_.node(there));
  }

 private:
  std::size_t mark_region(NodeId first, std::uint32_t number) {
    std::size_t cells = 0;
    open_.assign(1, first);
    region_[first] = number;
    while (!open_.empty()) {
      const NodeId node = open_.back();
      open_.pop_back();
      ++cells;
      each_neighbour(node, [&](NodeId next) {
        if (blocked_[next] != kFree || region_[next] != 0) return;
        region_[next] = number;
        open_.push_back(next);
      });
    }
    return cells;
  }

  Box box_;
  std::vector<std::uint8_t> blocked_;
  std::vector<std::uint32_t> region_;
  std::vector<NodeId> open_;
};

/// Frees the cells from `from` to the nearest one for which `at_end` holds.
template <class AtEnd>
void dig_to(GridMap& map, const RegionSearch& search, NodeId from, const AtEnd& at_end) {
  std::vector<NodeId> came(map.blocked.size(), kNoNode), ring{from};
  came[from] = from;
  for (std::size_t next = 0; next < ring.size(); ++next) {
    const NodeId here = ring[next];
    if (at_end(here)) {
      for (NodeId back = here; back != from; back = came[back]) map.blocked[back] = kFree;
      return;
    }
    search.each_neighbour(here, [&](NodeId there) {
      if (came[there] != kNoNode) return;
      came[there] = here;
      ring.push_back(there);
    });
  }
}

}  // namespace

bool keep_largest_region(GridMap& map) {
  RegionSearch search(map);
  const std::uint32_t largest = search.number_regions();
  std::vector<std::uint8_t> cells(map.blocked.size(), kObstacle);
  for (NodeId node = 0; node < cells.size(); ++node)
    if (largest != 0 && search.region(node) == largest) cells[node] = kFree;
  map.blocked = cells;
  return largest != 0;
}

void dig_to_largest_region(GridMap& map, std::span<const Cell> cells) {
  if (std::none_of(cells.begin(), cells.end(), [&](Cell cell) { return map.contains(cell); }))
    return;  // nothing to look for regions for, which takes as long as all else
  for (const Cell cell : cells)
    if (map.contains(cell)) map.set(cell, false);
  RegionSearch search(map);
  const std::uint32_t largest = search.number_regions();
  for (const Cell cell : cells) {
    if (!map.contains(cell) || search.region(map.box().node(cell)) == largest) continue;
    dig_to(map, search, map.box().node(cell), [&](NodeId node) { return search.region(node) == largest; });
  }
}

}  // namespace replan
