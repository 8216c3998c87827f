// What a scene needs of a run's past, read out of the log once, as it grows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/session/run.hpp"
#include "core/trace/expansions.hpp"

namespace replan {

/// A cell of the map (the true one or the robot's) that changed.
struct MapEvent {
  std::size_t event;
  NodeId node;
  EventKind kind;
};

/// A vertex that a replan touched for the first time.
struct Touch {
  std::size_t event;
  NodeId node;
};

/// What made a robot plan again.
struct ReplanCause {
  std::int64_t blocked = 0, freed = 0;  ///< cells that it saw or was told of
  std::int64_t forgotten = 0;           ///< cells where it no longer counts on something that moved
  bool new_goal = false;
  bool put_down = false;
  bool to_nearest = false;     ///< it makes for the reachable cell nearest to the goal, or for another one
  bool to_goal_again = false;  ///< it makes for the goal again
  bool new_start = false;      ///< it has moved, and its planner can repair only from where it was
  /// Whether the planner begins from scratch.
  [[nodiscard]] bool afresh() const { return new_goal || to_nearest || to_goal_again || new_start; }
};

/// A plan or replan. Its touches are [first_touch, last_touch) of RunDigest::touches().
struct PlanSpan {
  std::size_t begin;           ///< of its plan_begin
  std::size_t end = SIZE_MAX;  ///< past its plan_end; SIZE_MAX while there is none
  NodeId start = kNoNode;      ///< where the robot stood
  std::size_t first_touch = 0, last_touch = 0;
  std::int64_t touched = 0;
  ReplanCause cause = {};
};

class RunDigest {
 public:
  /// Reads on to the end of the log; if events were cut off, from where it is still what was read.
  void read(const Run& run);

  [[nodiscard]] std::span<const MapEvent> map_events() const { return map_events_; }
  [[nodiscard]] std::span<const PlanSpan> plans() const { return plans_; }
  [[nodiscard]] std::span<const Touch> touches() const { return touches_; }
  /// Number of plans that began before the position.
  [[nodiscard]] std::size_t plans_before(std::size_t position) const;
  /// The touches of a plan that happened before the position.
  [[nodiscard]] std::span<const Touch> touches_before(const PlanSpan& plan, std::size_t position) const;
  /// Expansions among the first `position` events.
  [[nodiscard]] std::int64_t expansions(const Run& run, std::size_t position) const {
    return counter_at(run, position).count();
  }

 private:
  static constexpr std::size_t kStride = 1024;

  [[nodiscard]] ExpansionCounter counter_at(const Run& run, std::size_t position) const;
  void forget_from(const Run& run, std::size_t position);
  void take(const Event& event, std::size_t index);
  void touch(NodeId node, std::size_t index);
  [[nodiscard]] bool starts_afresh() const { return !plans_.empty() && plans_.back().cause.afresh(); }

  std::uint64_t log_id_ = 0;
  bool incremental_ = true, keeps_start_ = false;
  std::size_t read_ = 0;
  ReplanCause cause_;  // what has happened since the last plan began
  ExpansionCounter counter_;
  std::vector<ExpansionCounter> counters_;  // before each kStride-th event
  std::vector<MapEvent> map_events_;
  std::vector<PlanSpan> plans_;
  std::vector<Touch> touches_;
  PagedArray<std::uint32_t> stamps_;  // stamp of the last plan that touched the node
  std::uint32_t stamp_ = 0;           // another one for every plan, those that were cut off included
};

}  // namespace replan
