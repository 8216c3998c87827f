// What a robot that drives takes into account when it decides, from its map and where it stands: the same for the robot
// itself and for who asks later why it decided so.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/drive/dynamic_window.hpp"
#include "core/drive/local_obstacles.hpp"
#include "core/drive/sub_goals.hpp"
#include "core/plan/path.hpp"
#include "core/sim/body.hpp"
#include "core/sim/mission.hpp"

namespace replan {

/// `known[node]` is the robot's map, nonzero where there is an obstacle.
class DriveSense {
 public:
  /// Of a robot that drives in a scenario; nothing of either is kept.
  DriveSense(const Scenario& scenario, const RobotSetup& robot);

  [[nodiscard]] const CellFrame& frame() const { return frame_; }
  /// With the robot's radius in metres.
  [[nodiscard]] const DriveSettings& settings() const { return settings_; }
  /// With the top speed at which it can still turn to its sub-goal.
  [[nodiscard]] DriveSettings settings_towards(const DriveState& state, Spot goal) const;
  [[nodiscard]] Point in_cells(Spot spot) const { return {spot.x / frame_.side, spot.y / frame_.side, 0.5}; }
  /// The cell of the map where a node of a path lies.
  [[nodiscard]] Cell cell_of(Spot node) const {
    const Cell cell = frame_.cell(node);
    return {std::clamp(cell.x, 0, frame_.box.width() - 1), std::clamp(cell.y, 0, frame_.box.height() - 1), 0};
  }
  /// How it stands when it sets out from a cell: in its middle, at rest.
  [[nodiscard]] DriveState first_state(Cell cell) const;
  /// The nodes of a path in metres.
  [[nodiscard]] std::vector<Spot> nodes_of(const Path& path) const;

  /// Whether its body can go straight from one place to another.
  template <class Known>
  [[nodiscard]] bool sees(Spot from, Spot to, const Known& known) const {
    const double radius = std::max(radius_, 1e-6), free = radius - Body::kTouch;
    return Body(frame_.box, radius, in_cells(from), in_cells(to)).nearest(known) >= free * free;
  }
  /// Whether it has lost sight of its sub-goal: it drove past, or something drove it off. Not again within a second.
  template <class Known>
  [[nodiscard]] bool has_strayed(const Decision& now, Spot robot, Spot goal, const Known& known) const {
    return now.time >= now.drive.planned + kSecond && !sees(robot, goal, known);
  }
  /// Which of the nodes it makes for, if it was `at` one.
  template <class Known>
  [[nodiscard]] std::size_t sub_goal(const std::vector<Spot>& nodes, std::size_t at, Spot robot,
                                     const Known& known) const {
    if (at == 0 && nodes.size() > 1 && frame_.cell(nodes[0]) == frame_.cell(robot)) at = 1;  // it is there
    return next_sub_goal(nodes, at, robot, near_, [&](Spot node) { return sees(robot, node, known); });
  }
  /// What stands about it. Something on the cell that it is in is in nobody's way while it stands there.
  template <class Known>
  [[nodiscard]] LocalObstacles obstacles(const DriveState& state, const Known& known) const {
    const Spot at = state.pose.spot();
    const NodeId own = frame_.box.node(frame_.cell(at));
    const auto around = [&](bool mapped) {
      return cells_around(frame_, at, reach(), false, [&](NodeId node) {
        return known[node] != 0 && node != own && (mapped_[node] != 0) == mapped;
      });
    };
    std::vector<Spot> walls = around(true);
    add_edge(walls, at);
    const ObstacleShape cell{frame_.side / 2, 0};
    LocalObstacles obstacles;
    obstacles.known = ObstacleSet(cell, walls);
    obstacles.unknown = ObstacleSet(cell, around(false));
    return obstacles;
  }

 private:
  /// How far away something can be that matters.
  [[nodiscard]] double reach() const {
    return settings_.limits.v_max * settings_.horizon + settings_.limits.radius + settings_.reach +
           frame_.side;
  }
  void add_edge(std::vector<Spot>& walls, Spot at) const;

  CellFrame frame_;
  DriveSettings settings_;
  double radius_;       // cells
  double near_;         // m; so near a sub-goal the next one follows
  double heading_;      // rad, that it sets out with
  SharedBytes mapped_;  // its map before it set out
};

/// Why a robot decides as it does at a moment of its run.
struct DriveWhy {
  DriveState state;
  Spot goal;  ///< the sub-goal
  CellFrame frame;
  LocalObstacles obstacles;
  DriveSettings settings;  ///< with the top speed at which it can still turn to its sub-goal
  DriveLimits limits;      ///< with its own
  Explanation explanation;
  bool strayed = false;  ///< it has lost sight of its sub-goal, and plans again instead of deciding
};
/// Nothing where the robot does not drive or has no plan. `choice` is the run's among the scenario's planners, `state` the
/// log's at the decision.
std::optional<DriveWhy> why_it_drives(const Scenario& scenario, const PlannerChoice& choice,
                                      const Decision& decision, const SearchState& state);
/// What came of a motion: of the nearest sample, or, where none is near, of the motion itself.
DriveSample sample_of(const DriveWhy& why, const Twist& motion);
/// Whether the robot drives that the scenario has for this one of its planners.
bool drives(const Scenario& scenario, const PlannerChoice& choice);
/// Whether it does for any of them.
bool drives(const Scenario& scenario);

}  // namespace replan
