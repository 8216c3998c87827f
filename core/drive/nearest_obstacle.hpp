// Which obstacle is the nearest: the point of it that a distance is measured to.
#pragma once

#include <algorithm>
#include <optional>

#include "core/drive/local_obstacles.hpp"

namespace replan {

/// The point of the nearest of these obstacles; nothing where there is none.
inline std::optional<Spot> nearest_point(const ObstacleSet& obstacles, Spot at) {
  const auto [half, radius] = obstacles.shape();
  std::optional<Spot> nearest;
  double least = 0;
  for (const Spot& centre : obstacles.centres()) {
    const Spot square{std::clamp(at.x, centre.x - half, centre.x + half),
                      std::clamp(at.y, centre.y - half, centre.y + half)};
    const double far = distance(at, square);
    if (nearest && far >= least) continue;
    least = far;
    const double part = far > radius ? (far - radius) / far : 0;
    nearest = {at.x + (square.x - at.x) * part, at.y + (square.y - at.y) * part};
  }
  return nearest;
}

}  // namespace replan
