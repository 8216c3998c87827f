#include "core/sim/senses.hpp"

#include <algorithm>

#include "core/lattice/sight.hpp"
#include "core/sim/mover.hpp"

namespace replan {

bool Senses::in_sight(NodeId node) const {
  const Cell at = known_.position(robot_), cell = known_.position(node);
  const std::int64_t squared = squared_distance(at, cell);
  if (squared <= 2) return true;
  if (static_cast<double>(squared) > setup_.sensor_radius * setup_.sensor_radius) return false;
  const auto clear = [&](NodeId passed, int) { return passed == node || truth_[passed] == 0; };
  return !setup_.sensor_blocked || walk_supercover(known_, robot_, node, clear);
}

std::vector<CellEdit> Senses::sense() const {
  std::vector<CellEdit> seen;
  const Cell at = known_.position(robot_);
  const int reach = std::max(1, static_cast<int>(setup_.sensor_radius));
  for (int y = std::max(0, at.y - reach); y <= std::min(known_.height() - 1, at.y + reach); ++y)
    for (int x = std::max(0, at.x - reach); x <= std::min(known_.width() - 1, at.x + reach); ++x) {
      const NodeId node = known_.node(Cell{x, y});
      const bool blocked = truth_[node] != 0;
      if (blocked && node == robot_ && !setup_.robot_cell_blocks) continue;
      if (blocked != known_.blocked(node) && in_sight(node)) seen.push_back({node, blocked});
    }
  return seen;
}

std::vector<CellEdit> Senses::out_of_sight(const Sightings& sightings) const {
  std::vector<CellEdit> lost;
  for (const NodeId node : sightings)
    if (known_.blocked(node) && !in_sight(node)) lost.push_back({node, false});
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
