// Who plans, whatever it searches in: the map that the robot knows, a planner on it, and the stages that its paths go
// through. What drives a robot knows of planners nothing but this.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/base/point.hpp"
#include "core/base/shared_array.hpp"
#include "core/lattice/box.hpp"
#include "core/plan/planner.hpp"
#include "core/plan/planner_choice.hpp"

namespace replan {

class Recorder;

class Navigator {
 public:
  virtual ~Navigator() = default;

  /// The cells of the robot's map. A robot with a size plans its centre's way over what its radius leaves free of
  /// them (core/lattice/inflation.hpp); from a place that is too near an obstacle it drives out first, by the
  /// shortest way on which it comes no nearer (core/lattice/way_out.hpp), and plans from its end.
  [[nodiscard]] virtual Box box() const = 0;
  /// What it holds for an obstacle: nonzero. Valid until the map changes.
  [[nodiscard]] virtual std::span<const std::uint8_t> known() const = 0;

  /// Forgets everything but the map and sets up a plan between two points of it.
  virtual void begin(const Point& start, const Point& goal) = 0;
  /// Runs at most `iterations` iterations of the planner's main loop. Returns true when the plan stands.
  virtual bool advance(std::int64_t iterations) = 0;
  /// The map changes: each cell once, with its new value. What follows is update(), or begin().
  virtual void learn(std::span<const CellEdit> edits) = 0;
  /// The robot stands at `start` now, and the map has changed as was learnt just before.
  virtual void update(const Point& start) = 0;

  [[nodiscard]] virtual PlanStatus status() const = 0;
  /// Cost of the plan, penalties included; infinite without a path. A way out ahead of it is not counted.
  [[nodiscard]] virtual Cost cost() const = 0;
  /// As Planner::best_so_far() and settle().
  [[nodiscard]] virtual Cost best_so_far() const { return cost(); }
  virtual bool settle() { return false; }
  /// The path after its stages, from the robot on.
  virtual Path path() = 0;
  [[nodiscard]] virtual Counters counters() const = 0;
  /// One of the numbers that the planner declares (SearchValues::numbers), of the latest plan.
  [[nodiscard]] virtual Cost number(Scalar) const { return Cost::zero(); }
  /// Bytes held by the planner, the map not counted; the open list with its peak.
  [[nodiscard]] virtual std::size_t memory_bytes() const = 0;
  /// PlannerInfo::blind: whatever the robot learns, the plan is none the better for it.
  [[nodiscard]] virtual bool blind() const { return false; }
  /// Where a robot at `robot` makes for if its goal cannot be reached: core/lattice/nearest.hpp.
  [[nodiscard]] virtual NodeId nearest_reachable(NodeId robot, NodeId goal) const = 0;
  /// Takes up map and search as `state` shows them, as Planner::restore().
  virtual void restore(const SearchState& state, const Counters& counters) = 0;
};

/// The navigator of a planner, which must be in the registry as its stages must, for a robot that knows these cells
/// (nonzero = obstacle) of the box and has that radius. `recorder`, if there is one, is told what the planner does and
/// must outlive it.
std::unique_ptr<Navigator> make_navigator(const PlannerChoice& choice, const Box& box,
                                          const SharedBytes& known, double radius,
                                          Recorder* recorder = nullptr);

/// Runs the plan to its end.
PlanStatus finish(Navigator& navigator);

}  // namespace replan
