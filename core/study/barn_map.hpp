// What the robot of the BARN benchmark knows: what its laser has hit, cell by cell, and the same grown by a radius.
#pragma once

#include <cstdint>
#include <vector>

#include "core/drive/local_obstacles.hpp"
#include "core/lattice/lattice.hpp"
#include "core/study/barn.hpp"

namespace replan {

/// The first things that rays from a pose hit.
class BarnLaser {
 public:
  BarnLaser(const BarnWorld& world, const BarnSettings& settings);
  /// Where rays end on a disc, ray by ray.
  [[nodiscard]] std::vector<Spot> scan(const Pose& from) const;

 private:
  [[nodiscard]] double hit(Spot from, Spot way) const;

  const BarnWorld& world_;
  const BarnSettings& settings_;
  CellFrame frame_;
  std::vector<std::uint8_t> cylinders_;  // by cells of the world
};

/// The robot's map.
class BarnMap {
 public:
  BarnMap(const BarnWorld& world, double cell, double radius);

  [[nodiscard]] const CellFrame& frame() const { return frame_; }
  [[nodiscard]] bool marked(NodeId node) const { return marked_[node] != 0; }
  /// Whether a robot whose centre is in the cell's touches something.
  [[nodiscard]] bool inflated(NodeId node) const { return inflated_[node] != 0; }
  /// Whether a disc of the radius can go straight from a to b, as far as the map tells: cell by cell.
  [[nodiscard]] bool sees(Spot a, Spot b) const;
  /// Marks what was hit; the cells that are closed to a robot's centre now are added to `closed`.
  void mark(const std::vector<Spot>& hits, std::vector<CellEdit>& closed);

  /// The cells of the map, nonzero where marked.
  [[nodiscard]] const std::vector<std::uint8_t>& cells() const { return marked_; }
  /// The cells closed to a robot's centre.
  [[nodiscard]] const std::vector<std::uint8_t>& closed() const { return inflated_; }

 private:
  CellFrame frame_;
  double radius_;
  std::vector<std::uint8_t> marked_, inflated_;
};

}  // namespace replan
