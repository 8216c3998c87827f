#include "core/world/scenario_places.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "core/base/words.hpp"
#include "core/lattice/box_words.hpp"

namespace replan {
namespace {

constexpr std::size_t kMaxListed = std::size_t{1} << 22;  // cells that are listed, in all surprises or as obstacles

/// What is expected of a list of numbers, in a plane and in space.
struct Expected {
  const char* plane;
  const char* space;
};
constexpr Expected kCell{"a cell [x, y]", "a cell [x, y, z] (the map has more than one layer)"};
constexpr Expected kSize{"a size [width, height]",
                         "a size [width, height, depth] (the map has more than one layer)"};
constexpr Expected kBox{"a rectangle [x, y, width, height]", "a box [x, y, z, width, height, depth]"};

/// The numbers of one place: `each` for every axis of the world.
std::vector<JsonNode> numbers(const JsonNode& node, const Box& world, const Expected& expected,
                              std::size_t each = 1) {
  const std::size_t count = each * (world.solid() ? 3 : 2);
  return node.items(count, count, world.solid() ? expected.space : expected.plane);
}

}  // namespace

Cell PlaceReader::cell(const JsonNode& node) const {
  const auto parts = numbers(node, world_, kCell);
  if (parts.empty()) return {};
  const auto whole = [&](std::size_t axis) {
    return static_cast<int>(parts[axis].whole(INT32_MIN, INT32_MAX));
  };
  const Cell result{whole(0), whole(1), world_.solid() ? whole(2) : 0};
  if (!world_.contains(result))
    node.fail(cell_text(result, world_.solid()) + " is outside the map: " + range_text(world_));
  return result;
}

void PlaceReader::size(const JsonNode& node, MovingObstacle& mover) const {
  const auto parts = numbers(node, world_, kSize);
  if (parts.empty()) return;
  const auto side = [&](std::size_t axis) { return static_cast<int>(parts[axis].whole(1, kMaxMoverSide)); };
  mover.width = side(0);
  mover.height = side(1);
  if (world_.solid()) mover.depth = side(2);
}

void PlaceReader::cells(const JsonNode& node, bool blocked, std::vector<CellChange>& changes) {
  if (!node.expect_object({"cells", "rectangles", "boxes"})) return;
  const auto cells = node.find("cells"), rectangles = node.find("rectangles"), boxes = node.find("boxes");
  if (rectangles && world_.solid())
    return rectangles->fail(
        "the map has more than one layer: give 'boxes', each [x, y, z, width, height, depth]");
  if (boxes && !world_.solid())
    return boxes->fail("the map is a plane: give 'rectangles', each [x, y, width, height]");
  if (cells)
    for (const JsonNode& item : cells->items(0, kMaxListed, "a list of cells"))
      if (take(item, 1)) changes.push_back({cell(item), blocked});
  if (const auto& listed = world_.solid() ? boxes : rectangles)
    for (const JsonNode& item :
         listed->items(0, kMaxListed, world_.solid() ? "a list of boxes" : "a list of rectangles"))
      box(item, blocked, changes);
}

void PlaceReader::box(const JsonNode& node, bool blocked, std::vector<CellChange>& changes) {
  const auto parts = numbers(node, world_, kBox, 2);
  if (parts.empty()) return;
  const std::size_t axes = parts.size() / 2;
  const std::array sides = world_.sides<3>();
  std::array<int, 3> first{0, 0, 0}, size{1, 1, 1};
  for (std::size_t axis = 0; axis < axes; ++axis) {
    first[axis] = static_cast<int>(parts[axis].whole(0, sides[axis] - 1));
    size[axis] = static_cast<int>(parts[axes + axis].whole(1, sides[axis] - first[axis]));
  }
  const Box inside(size[0], size[1], size[2]);
  if (!take(node, inside.node_count())) return;
  for (NodeId node_inside = 0; node_inside < inside.node_count(); ++node_inside) {
    const Cell at = inside.position(node_inside);
    changes.push_back({{first[0] + at.x, first[1] + at.y, first[2] + at.z}, blocked});
  }
}

/// Counts listed cells, so that a small file cannot ask for endless memory.
bool PlaceReader::take(const JsonNode& node, std::size_t count) {
  listed_ += count;
  if (listed_ > kMaxListed)
    node.fail("more than " + std::to_string(kMaxListed) + " cells are listed");
  return listed_ <= kMaxListed;
}

void PlaceReader::tidy(const JsonNode& node, std::vector<CellChange>& changes) const {
  const auto key = [](const CellChange& c) { return std::tuple(c.cell.z, c.cell.y, c.cell.x, c.blocked); };
  std::sort(changes.begin(), changes.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  changes.erase(std::unique(changes.begin(), changes.end()), changes.end());
  const auto twice = std::adjacent_find(changes.begin(), changes.end(),
                                        [](const auto& a, const auto& b) { return a.cell == b.cell; });
  if (twice != changes.end())
    node.fail("cell " + cell_text(twice->cell, world_.solid()) + " is both added and removed");
}

}  // namespace replan
