#include "core/sim/senses.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/lattice/sight.hpp"
#include "core/sim/mover.hpp"

namespace replan {

bool Senses::feels(Cell cell) const {
  const Cell at = box_.position(robot_);
  double squared = 0;
  int farthest = 0;
  for (const int by : {at.x - cell.x, at.y - cell.y, at.z - cell.z}) {
    farthest = std::max(farthest, std::abs(by));
    const double beyond = std::max(std::abs(by) - 2, 0);
    squared += beyond * beyond;
  }
  return farthest <= 1 || squared < setup_.radius * setup_.radius;
}

bool Senses::in_sight(NodeId node) const {
  const Cell at = box_.position(robot_), cell = box_.position(node);
  const std::int64_t squared = squared_distance(at, cell);
  if (feels(cell)) return true;
  if (static_cast<double>(squared) > setup_.sensor_radius * setup_.sensor_radius) return false;
  if (!cone_.holds(course_towards(centre_of(at), centre_of(cell)))) return false;
  const auto clear = [&](NodeId passed) { return passed == node || truth_[passed] == 0; };
  return !setup_.sensor_blocked || walk_supercover(box_, robot_, node, clear);
}

std::vector<CellEdit> Senses::sense() const {
  std::vector<CellEdit> seen;
  const int felt = static_cast<int>(std::ceil(setup_.radius)) + 1;
  const int reach = std::max(felt, static_cast<int>(setup_.sensor_radius));
  box_.each_cell_around(box_.position(robot_), reach, [&](NodeId node) {
    const bool obstacle = truth_[node] != 0;
    if (obstacle && node == robot_ && !setup_.robot_cell_blocks) return;
    if (obstacle != blocked(node) && in_sight(node)) seen.push_back({node, obstacle});
  });
  return seen;
}

std::vector<CellEdit> Senses::out_of_sight(const Sightings& sightings) const {
  std::vector<CellEdit> lost;
  for (const NodeId node : sightings)
    if (blocked(node) && !in_sight(node)) lost.push_back({node, false});
  return lost;
}

Sightings noted(Sightings sightings, std::span<const CellEdit> edits, std::span<const std::uint8_t> truth) {
  for (const CellEdit& edit : edits) {
    const auto place = std::lower_bound(sightings.begin(), sightings.end(), edit.node);
    const bool listed = place != sightings.end() && *place == edit.node;
    const bool moves = edit.blocked && (truth[edit.node] & kWallBit) == 0;
    if (moves && !listed) sightings.insert(place, edit.node);
    if (!moves && listed) sightings.erase(place);
  }
  return sightings;
}

}  // namespace replan
