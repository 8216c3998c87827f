// What the robot sees from where it stands, and what it remembers of things that move.
#pragma once

#include <span>
#include <vector>

#include "core/lattice/box.hpp"
#include "core/lattice/lattice.hpp"
#include "core/sim/course.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// Cells that the robot holds for obstacles because it saw something moving there, ascending.
using Sightings = std::vector<NodeId>;

/// The sensor at one place. `known` is the robot's map, nonzero = obstacle; `truth` the world as EventKind::truth
/// holds it. Both must outlive this. The sensor looks along `course`, its cone's axis.
class Senses {
 public:
  Senses(const Box& box, std::span<const std::uint8_t> known, std::span<const std::uint8_t> truth,
         const RobotSetup& setup, NodeId robot, const Course& course = {})
      : box_(box),
        known_(known),
        truth_(truth),
        setup_(setup),
        robot_(robot),
        cone_(course, setup.sensor_angle) {}

  /// Whether the sensor reaches the cell: some are always felt, others lie within its radius, in its cone
  /// and, if obstacles hide what is behind them, in plain view: all of it between centres of cells.
  [[nodiscard]] bool in_sight(NodeId node) const;
  /// What is in sight and differs from the robot's map, row by row; but not an obstacle on the robot's own
  /// cell, unless RobotSetup::robot_cell_blocks: that is in nobody's way while it stands there.
  [[nodiscard]] std::vector<CellEdit> sense() const;
  /// The sightings that cannot be seen from here, as edits that make them free.
  [[nodiscard]] std::vector<CellEdit> out_of_sight(const Sightings& sightings) const;

 private:
  /// The cells around (8, or 26 in space), and all that a robot with a size could touch anywhere in them: those whose
  /// squares are nearer to one of theirs than its radius.
  [[nodiscard]] bool feels(Cell cell) const;
  [[nodiscard]] bool blocked(NodeId node) const { return known_[node] != 0; }

  Box box_;
  std::span<const std::uint8_t> known_, truth_;
  const RobotSetup& setup_;
  NodeId robot_;
  Cone cone_;
};

/// The sightings after the robot has learnt the edits: those that moving obstacles account for come in, all
/// others go out.
Sightings noted(Sightings sightings, std::span<const CellEdit> edits, std::span<const std::uint8_t> truth);

}  // namespace replan
