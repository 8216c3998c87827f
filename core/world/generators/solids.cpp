// Solid things thrown into a world of layers.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/world/generators/generators.hpp"
#include "core/world/generators/parts.hpp"

namespace replan {
namespace {

/// Of things thrown in a row without covering a new cell: after that many nothing more is to be hoped for.
constexpr int kMaxVainSolids = 10'000;

Result<void> check_sides(int shortest, int longest) {
  if (shortest >= 1 && longest >= shortest) return {};
  return Error{"sides cannot go from " + std::to_string(shortest) + " to " + std::to_string(longest) +
               ": give a smallest side from 1 and a longest one that is no shorter"};
}

/// A world that is filled box by box. Cells are plain, not shared: there are millions.
class SolidWorld {
 public:
  SolidWorld(const Box& size, std::span<const Cell> keep_free)
      : size_(size), cells_(size.node_count(), kFree), keep_free_(keep_free) {}

  /// How many cells of a row were free before it is filled.
  std::int64_t fill_row(int from, int to, int y, int z) {
    std::int64_t count = 0;
    for (NodeId node = size_.node({from, y, z}), end = node + static_cast<NodeId>(to - from + 1); node < end;
         ++node) {
      count += cells_[node] == kFree ? 1 : 0;
      cells_[node] = kObstacle;
    }
    return count;
  }
  [[nodiscard]] std::span<const Cell> kept() const { return keep_free_; }

  /// The map, in which a way joins the cells that were to be kept free.
  GridMap finished() {
    GridMap map(size_.width(), size_.height(), size_.depth());
    map.blocked = cells_;
    dig_to_largest_region(map, keep_free_);
    return map;
  }

 private:
  Box size_;
  std::vector<std::uint8_t> cells_;
  std::span<const Cell> keep_free_;
};

bool holds(const CellBox& box, Cell c) {
  return c.x >= box.low.x && c.x <= box.high.x && c.y >= box.low.y && c.y <= box.high.y && c.z >= box.low.z &&
         c.z <= box.high.z;
}

std::int64_t add_box(SolidWorld& world, const CellBox& box) {
  std::int64_t covered = 0;
  if (std::any_of(world.kept().begin(), world.kept().end(), [&](Cell c) { return holds(box, c); })) return 0;
  for (int z = box.low.z; z <= box.high.z; ++z)
    for (int y = box.low.y; y <= box.high.y; ++y) covered += world.fill_row(box.low.x, box.high.x, y, z);
  return covered;
}

/// Calls `row(y, from, to)` for the rows of a disc of that diameter whose square lies at (left, top). Lengths are
/// doubled, so that the middle of an even one is whole too.
template <class Row>
void each_row_of_disc(int left, int top, int diameter, const Row& row) {
  for (int y = 0; y < diameter; ++y) {
    int inset = 0;
    const auto outside = [&](int x) {
      const int dx = 2 * x + 1 - diameter, dy = 2 * y + 1 - diameter;
      return dx * dx + dy * dy > diameter * diameter;
    };
    while (outside(inset)) ++inset;
    row(top + y, left + inset, left + diameter - 1 - inset);
  }
}

/// How much of the ground is newly covered by a pillar of so many layers; none stands where a cell is to be kept free.
std::int64_t add_pillar(SolidWorld& world, int left, int top, int diameter, int layers) {
  bool kept = false;
  each_row_of_disc(left, top, diameter, [&](int y, int from, int to) {
    for (const Cell c : world.kept()) kept = kept || (c.y == y && c.x >= from && c.x <= to && c.z < layers);
  });
  std::int64_t covered = 0;
  if (kept) return 0;
  each_row_of_disc(left, top, diameter, [&](int y, int from, int to) {
    covered += world.fill_row(from, to, y, 0);
    for (int z = 1; z < layers; ++z) world.fill_row(from, to, y, z);
  });
  return covered;
}

/// Throws things, each of which says how much it covered, until that is enough or nothing new has been covered for
/// long.
template <class Throw>
void throw_until(double wanted, const Throw& once) {
  std::int64_t covered = 0;
  for (int vain = 0; static_cast<double>(covered) < wanted && vain < kMaxVainSolids;) {
    const std::int64_t gained = once();
    covered += gained;
    vain = gained == 0 ? vain + 1 : 0;
  }
}

}  // namespace

Result<GridMap> random_boxes(const Box& size, double fraction, int min_side, int max_side, std::uint64_t seed,
                             std::span<const Cell> keep_free) {
  if (auto checked = check_world_size(size); !checked) return Error{checked.error()};
  if (auto checked = check_fraction("the covered fraction", fraction, 0, 0.9); !checked)
    return Error{checked.error()};
  if (auto checked = check_sides(min_side, max_side); !checked) return Error{checked.error()};
  SolidWorld world(size, keep_free);
  Random random(seed);
  const auto side = [&](int longest) { return std::min(random.between(min_side, max_side), longest); };
  throw_until(fraction * static_cast<double>(size.node_count()), [&] {
    const int width = side(size.width()), height = side(size.height()), depth = side(size.depth());
    Cell low;
    low.x = random.between(0, size.width() - width);
    low.y = random.between(0, size.height() - height);
    low.z = random.between(0, size.depth() - depth);
    return add_box(world, {low, {low.x + width - 1, low.y + height - 1, low.z + depth - 1}});
  });
  return world.finished();
}

Result<GridMap> pillars(const Box& size, const PillarsShape& shape, std::uint64_t seed,
                        std::span<const Cell> keep_free) {
  if (auto checked = check_world_size(size); !checked) return Error{checked.error()};
  if (auto checked = check_fraction("the covered fraction", shape.fraction, 0, 0.9); !checked)
    return Error{checked.error()};
  if (auto checked = check_fraction("the fraction of pillars up to the top", shape.whole, 0, 1); !checked)
    return Error{checked.error()};
  if (auto checked = check_sides(shape.min_side, shape.max_side); !checked) return Error{checked.error()};
  SolidWorld world(size, keep_free);
  Random random(seed);
  const int widest = std::min(size.width(), size.height());
  throw_until(shape.fraction * size.width() * size.height(), [&] {
    const int diameter = std::min(random.between(shape.min_side, shape.max_side), widest);
    const int left = random.between(0, size.width() - diameter),
              top = random.between(0, size.height() - diameter);
    const int layers = random.chance(shape.whole) ? size.depth() : random.between(1, size.depth());
    return add_pillar(world, left, top, diameter, layers);
  });
  return world.finished();
}

}  // namespace replan
