// What stands near a robot, and how far it is: exact distances, from a grid of bins.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/drive/motion.hpp"
#include "core/lattice/box.hpp"

namespace replan {

/// The shape of an obstacle: a square with sides along the axes, grown by a radius. A cell has no radius, a disc no
/// square.
struct ObstacleShape {
  double half = 0;    ///< m, of the square's side
  double radius = 0;  ///< m
};

/// Obstacles of one shape, sorted into bins.
class ObstacleSet {
 public:
  ObstacleSet() = default;
  /// Around these centres.
  ObstacleSet(ObstacleShape shape, std::span<const Spot> centres);

  [[nodiscard]] bool empty() const { return centres_.empty(); }
  [[nodiscard]] const ObstacleShape& shape() const { return shape_; }
  [[nodiscard]] std::span<const Spot> centres() const { return centres_; }
  /// The distance from there to the nearest obstacle, or `most` if that is nearer. Below 0 inside a disc; 0 inside a
  /// square.
  [[nodiscard]] double distance(Spot at, double most) const;

 private:
  [[nodiscard]] int column(double x) const;
  [[nodiscard]] int row(double y) const;
  void look_at(int row, int left, int right, Spot at, double& least) const;

  ObstacleShape shape_;
  std::vector<Spot> centres_;         // bin by bin
  std::vector<std::uint32_t> first_;  // of each bin; one more for the end
  Spot corner_;
  double bin_ = 1;  // m, side of a bin
  int columns_ = 0, rows_ = 0;
};

/// What a robot takes into account when it decides.
struct LocalObstacles {
  ObstacleSet known;           ///< that its plan was made with
  ObstacleSet unknown;         ///< that its plan was not made with
  ObstacleSet moving;          ///< of the unknown ones those that may move
  double speed_of_moving = 0;  ///< m/s, that these do not exceed

  /// The distance from there, at most `most`, to what stands still.
  [[nodiscard]] double to_known(Spot at, double most) const { return known.distance(at, most); }
  [[nodiscard]] double to_unknown(Spot at, double most) const {
    return moving.distance(at, unknown.distance(at, most));
  }
  [[nodiscard]] double to_still(Spot at, double most) const {
    return unknown.distance(at, known.distance(at, most));
  }
  /// To what may move, after it has had `time` seconds to come nearer. What lies behind a robot that looks that way even
  /// then is left out: what comes from there would run into the robot, not the robot into it.
  [[nodiscard]] double to_moving(Spot at, const SineCosine& heading, double time, double most) const;
};

/// Where the cells of a map lie in metres: cell (x, y) covers x .. x + 1 times the side, y likewise.
struct CellFrame {
  Box box;
  double side = 1;  ///< m
  [[nodiscard]] Spot centre(Cell cell) const { return {(cell.x + 0.5) * side, (cell.y + 0.5) * side}; }
  [[nodiscard]] Cell cell(Spot at) const {
    return {static_cast<int>(std::floor(at.x / side)), static_cast<int>(std::floor(at.y / side)), 0};
  }
};

/// The centres of the obstacle cells whose squares come within `reach` metres of `at` along both axes, those left out
/// that obstacle cells surround on all four sides: who is outside meets another one first. `obstacle(node)` says what
/// is one; what is outside the map is one if `walled`, cell by cell along its border.
template <class Obstacle>
std::vector<Spot> cells_around(const CellFrame& frame, Spot at, double reach, bool walled,
                               Obstacle&& obstacle) {
  const Cell low = frame.cell({at.x - reach, at.y - reach}), high = frame.cell({at.x + reach, at.y + reach});
  const auto is = [&](int x, int y) {
    const Cell cell{x, y, 0};
    return frame.box.contains(cell) ? static_cast<bool>(obstacle(frame.box.node(cell))) : walled;
  };
  std::vector<Spot> found;
  const int border = walled ? 1 : 0;
  for (int y = std::max(low.y, -border); y <= std::min(high.y, frame.box.height() - 1 + border); ++y)
    for (int x = std::max(low.x, -border); x <= std::min(high.x, frame.box.width() - 1 + border); ++x)
      if (is(x, y) && !(is(x - 1, y) && is(x + 1, y) && is(x, y - 1) && is(x, y + 1)))
        found.push_back(frame.centre({x, y, 0}));
  return found;
}

}  // namespace replan
