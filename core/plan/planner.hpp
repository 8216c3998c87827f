// What every lattice planner looks like from outside, whatever it does inside.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/cost.hpp"
#include "core/lattice/lattice.hpp"
#include "core/plan/path.hpp"
#include "core/trace/event.hpp"

namespace replan {

class SearchState;

/// How a plan stands.
enum class PlanStatus : std::uint8_t {
  searching,      ///< advance() has not finished
  found,          ///< there is a path
  no_path,        ///< start and goal are free and nothing leads from one to the other
  start_blocked,  ///< the start is inside an obstacle
  goal_blocked,   ///< the goal is inside an obstacle
  found_nearest,  ///< there is no path to the goal, but one to the reachable cell nearest to it
  none_found,     ///< the samples have run out before there was a path: there may be one
};

/// Whether there is a path, be it to the goal or to the reachable cell nearest to it.
constexpr bool has_path(PlanStatus status) {
  return status == PlanStatus::found || status == PlanStatus::found_nearest;
}

/// Whether the goal may be out of reach: of samples alone that is not certain.
constexpr bool may_be_unreachable(PlanStatus status) {
  return status == PlanStatus::no_path || status == PlanStatus::goal_blocked ||
         status == PlanStatus::none_found;
}

/// The status as its fixed name in JSON output: "found", "no-path", "start-blocked", ...
const char* status_name(PlanStatus status);
/// The status as a sentence for a user. For a robot with a size a cell is blocked that is too near an obstacle, too.
const char* status_sentence(PlanStatus status, bool has_size = false);

/// Work done since begin(), replans included.
struct Counters {
  std::int64_t expansions = 0;        ///< vertices taken from the open list and settled or raised
  std::int64_t queue_operations = 0;  ///< inserts, removals, re-keyings and pops; one `queue` event each
  std::int64_t sight_checks = 0;      ///< line-of-sight questions, in the search and along paths

  friend Counters operator+(const Counters& a, const Counters& b) {
    return {a.expansions + b.expansions, a.queue_operations + b.queue_operations,
            a.sight_checks + b.sight_checks};
  }
  friend Counters operator-(const Counters& a, const Counters& b) {
    return {a.expansions - b.expansions, a.queue_operations - b.queue_operations,
            a.sight_checks - b.sight_checks};
  }
};

/// A change of the map that the lattice shows already.
template <class L>
struct MapChange {
  std::span<const CellEdit> cells;                ///< each changed cell once, with its new value
  std::span<const typename L::MoveChange> moves;  ///< what L::apply() returned
};

/// A planner over a lattice that its owner changes. Call begin(), then advance() until it returns true; after
/// the map or the start has changed, update() and advance() again. The lattice must outlive the planner.
template <class L>
class Planner {
 public:
  virtual ~Planner() = default;

  /// Forgets everything and sets up a plan from `start` to `goal` (both on the lattice).
  virtual void begin(NodeId start, NodeId goal) = 0;
  /// Runs at most `iterations` iterations of the main loop (at least one). Returns true when the plan stands.
  virtual bool advance(std::int64_t iterations) = 0;
  /// The robot stands at `start` now and the map has changed as told (possibly not at all). A search under
  /// way is taken along.
  virtual void update(const MapChange<L>& change, NodeId start) = 0;

  [[nodiscard]] virtual PlanStatus status() const = 0;
  /// Cost of the plan: of the lattice path, penalties included; infinite without a path.
  [[nodiscard]] virtual Cost cost() const = 0;
  /// Of one that betters its path while it searches: the cost of the best one so far. Of others as cost().
  [[nodiscard]] virtual Cost best_so_far() const { return cost(); }
  /// Ends a search under way with the best path so far. False, and nothing happens, if there is none by then.
  virtual bool settle() { return false; }
  /// The path from the start, read out of the search. Counts the sight checks that this takes.
  virtual Path path() = 0;
  [[nodiscard]] virtual Counters counters() const = 0;
  /// One of the numbers that it declares (SearchValues::numbers), of the latest plan.
  [[nodiscard]] virtual Cost number(Scalar) const { return Cost::zero(); }
  /// Bytes held, the lattice not counted; the open list with its peak.
  [[nodiscard]] virtual std::size_t memory_bytes() const = 0;
  /// Takes up the search as `state` shows it: the state before a `pop` event of this planner's own log, or
  /// while it stands still. `counters` is the work done until then. The lattice must show the map as known
  /// then. What follows is the same, event for event, as if the search had never stopped.
  virtual void restore(const SearchState& state, const Counters& counters) = 0;
};

/// Runs the plan to its end.
template <class L>
PlanStatus finish(Planner<L>& planner) {
  while (!planner.advance(std::int64_t{1} << 20)) {
  }
  return planner.status();
}

}  // namespace replan
