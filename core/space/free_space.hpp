// A map as a continuous world: where a robot's centre may be, and which straight ways it may go.
#pragma once

#include <algorithm>
#include <optional>

#include "core/lattice/body_way.hpp"
#include "core/space/place.hpp"

namespace replan {

/// All points of a lattice's world. The lattice must outlive it, and may change.
template <int D>
class FreeSpace {
 public:
  explicit FreeSpace(const BoxLattice<D>& known) : known_(known) {}

  [[nodiscard]] const BoxLattice<D>& known() const { return known_; }
  /// How many units the world is long along an axis; no place has that coordinate, since it lies in no cell.
  [[nodiscard]] std::int64_t extent(std::size_t axis) const {
    return axis < D ? known_.size()[axis] * kPlaceUnits : kPlaceUnits;
  }
  [[nodiscard]] bool contains(const Place& place) const {
    for (std::size_t i = 0; i < D; ++i)
      if (place[i] < 0 || place[i] >= extent(i)) return false;
    return true;
  }
  [[nodiscard]] NodeId node(const Place& place) const { return known_.node(cell_of(point_of(place))); }
  /// Whether the robot may stand there.
  [[nodiscard]] bool free(const Place& place) const { return !hit(place, place); }
  /// The obstacle in a straight way, if there is one: hit_on_way().
  [[nodiscard]] std::optional<Cell> hit(const Place& from, const Place& to) const {
    return hit_on_way(known_, point_of(from), point_of(to));
  }
  [[nodiscard]] bool sees(const Place& from, const Place& to) const { return !hit(from, to); }

 private:
  const BoxLattice<D>& known_;
};

/// The place on the straight way that is no farther than `reach` units from its beginning: the end, or about so far.
inline Place steer(const Place& from, const Place& to, std::int64_t reach) {
  const std::int64_t squared = squared_between(from, to);
  if (squared <= reach * reach) return to;
  const double share = static_cast<double>(reach) / std::sqrt(static_cast<double>(squared));
  Place place = from;
  for (std::size_t i = 0; i < 3; ++i)
    place[i] += static_cast<std::int64_t>(static_cast<double>(to[i] - from[i]) * share);
  return place;
}

}  // namespace replan
