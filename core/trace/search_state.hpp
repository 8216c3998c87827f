// The state of a run at one event of its log, rebuilt from the log alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/cost.hpp"
#include "core/trace/event.hpp"
#include "core/trace/field.hpp"
#include "core/trace/page_order.hpp"
#include "core/trace/paged.hpp"

namespace replan {

/// Everything that a view shows of a run at one moment, and everything that a planner needs to go on from
/// there. Copies are cheap, and for the same thread (see PagedArray). apply() is its own inverse, but for
/// epochs.
class SearchState {
 public:
  SearchState() = default;
  /// The state before the first event of a run over `nodes` nodes: nothing known, all costs infinite. Of the
  /// fields that the planner has declared, those of its own are looked at here.
  explicit SearchState(std::size_t nodes, std::span<const Field> fields = {});
  /// As above, with the robot's map (nonzero = obstacle) and the world (as EventKind::truth holds it) before
  /// the run. Both are read where they are: nothing is copied.
  SearchState(SharedBytes known, SharedBytes truth, std::span<const Field> fields = {});

  [[nodiscard]] std::size_t node_count() const { return narrow_[0].size(); }

  /// Takes the state over the event, forwards or backwards alike; over an epoch forwards only.
  void apply(const Event& event) {
    const auto kind = static_cast<std::size_t>(event.kind);
    if (kind < kWideFields)
      apply_wide(event);
    else if (kind < kWideFields + kNarrowFields)
      narrow_[kind - kWideFields].at(event.node) ^= static_cast<std::uint8_t>(event.delta);
    else if (event.kind == EventKind::scalar)
      scalars_[event.node] ^= event.delta;
    else if (event.kind == EventKind::epoch)
      forget_search();
    else if (is_own_field(event.kind))
      apply_wide(event);
  }

  /// The same over all of a stretch of the log at once, which is much cheaper where they are many: what they
  /// come to together does not depend on their order, so that each page is written once. None may be an
  /// epoch.
  void apply(std::span<const Event> events, PageOrder& order);

  [[nodiscard]] Cost g(NodeId n) const { return cost(EventKind::g, n); }
  [[nodiscard]] Cost rhs(NodeId n) const { return cost(EventKind::rhs, n); }
  [[nodiscard]] Cost dist(NodeId n) const { return cost(EventKind::dist, n); }
  [[nodiscard]] bool queued(NodeId n) const { return wide(EventKind::queue, n) != 0; }
  /// How many nodes are in the open list.
  [[nodiscard]] std::size_t queue_size() const { return queued_; }
  /// First key component of a node in the open list, as stored there; the second is min(g, rhs).
  [[nodiscard]] Cost k1(NodeId n) const { return {static_cast<std::int64_t>(wide(EventKind::queue, n)) - 1}; }
  [[nodiscard]] Cost k2(NodeId n) const { return std::min(g(n), rhs(n)); }
  /// Parents; kNoNode if none.
  [[nodiscard]] NodeId lp(NodeId n) const { return static_cast<NodeId>(wide(EventKind::lp, n)) - 1u; }
  [[nodiscard]] NodeId rp(NodeId n) const { return static_cast<NodeId>(wide(EventKind::rp, n)) - 1u; }
  /// Number of the latest expansion of the node, from 1; 0 = never expanded.
  [[nodiscard]] std::uint32_t order(NodeId n) const {
    return static_cast<std::uint32_t>(wide(EventKind::visit, n));
  }
  [[nodiscard]] std::uint32_t times_expanded(NodeId n) const {
    return static_cast<std::uint32_t>(wide(EventKind::visit, n) >> 32);
  }
  [[nodiscard]] bool known_blocked(NodeId n) const { return narrow_[0][n] != 0; }
  [[nodiscard]] bool truly_blocked(NodeId n) const { return narrow_[1][n] != 0; }
  /// Whether a wall stands there, whatever moves over it, and whether something that moves is there.
  [[nodiscard]] bool wall(NodeId n) const { return (narrow_[1][n] & 1) != 0; }
  [[nodiscard]] bool moving(NodeId n) const { return narrow_[1][n] > 1; }
  [[nodiscard]] std::uint64_t scalar(Scalar which) const { return scalars_[static_cast<std::size_t>(which)]; }
  [[nodiscard]] Cost km() const { return {static_cast<std::int64_t>(scalar(Scalar::km))}; }
  /// Nodes held by scalars (start, goal, robot ...); kNoNode while unset.
  [[nodiscard]] NodeId node(Scalar which) const { return static_cast<NodeId>(scalar(which)) - 1u; }
  /// Where the robot has to go: the search's goal, unless that is only the reachable cell nearest to it.
  [[nodiscard]] NodeId wanted_goal() const {
    return scalar(Scalar::wanted) != 0 ? node(Scalar::wanted) : node(Scalar::goal);
  }

  /// What a value per node is before anything is written.
  [[nodiscard]] std::uint64_t initial_value(EventKind kind) const {
    return is_wide(kind) ? wide_[wide_slot(kind)].initial() : 0;
  }
  /// The values per node that an epoch makes the initial ones again.
  [[nodiscard]] KindSet forgotten() const { return forgotten_; }
  /// The raw value of any kind, as events hold it; `node` is the Scalar for EventKind::scalar.
  [[nodiscard]] std::uint64_t value(EventKind kind, NodeId node) const;
  /// True if the page of `node` (kPage nodes) was ever written for that kind; false lets readers skip it.
  [[nodiscard]] bool touched(EventKind kind, NodeId node) const;
  /// The page of `node` for a 64-bit kind, as PagedArray::page(): for readers of long stretches.
  [[nodiscard]] const std::uint64_t* page(EventKind kind, NodeId node) const {
    return wide_[wide_slot(kind)].page(node);
  }
  /// The same of the robot's map (EventKind::known) or the true one (EventKind::truth); nonzero = obstacle.
  [[nodiscard]] const std::uint8_t* map_page(EventKind kind, NodeId node) const {
    return narrow_[static_cast<std::size_t>(kind) - kWideFields].page(node);
  }
  /// The robot's map as a whole; nonzero = obstacle. Shares what it has never changed with the map before the
  /// run.
  [[nodiscard]] SharedBytes known_map() const { return narrow_[0].values(); }
  static constexpr std::size_t kPage = PagedArray<std::uint64_t>::kPage;

  /// A hash over all values: equal states have equal hashes, whichever way they were reached. See StateHash where that
  /// takes too long.
  [[nodiscard]] std::uint64_t hash() const;
  /// Bytes of the pages that this state reaches, shared with its copies or not.
  [[nodiscard]] std::size_t page_bytes() const;
  /// Bytes of all pages of this state and its copies together, each counted once.
  [[nodiscard]] std::size_t family_bytes() const;
  /// How many states of the family there are: this one, and its copies and theirs.
  [[nodiscard]] std::size_t family_size() const {
    return static_cast<std::size_t>(wide_pool_.use_count()) / (wide_count_ + 1);
  }
  /// Bytes that each copy takes without its pages.
  [[nodiscard]] std::size_t table_bytes() const;

 private:
  friend class StateHash;

  void forget_search();
  [[nodiscard]] std::span<const PagedArray<std::uint64_t>> declared() const {
    return std::span(wide_).first(wide_count_);
  }
  void apply_wide(const Event& event) { write(wide_[wide_slot(event.kind)].at(event.node), event); }
  void write(std::uint64_t& value, const Event& event) {
    if (event.kind == EventKind::queue) {
      if (value != 0) --queued_;
      if (value != event.delta) ++queued_;
    }
    value ^= event.delta;
  }
  [[nodiscard]] std::uint64_t wide(EventKind kind, NodeId n) const { return wide_[wide_slot(kind)][n]; }
  [[nodiscard]] Cost cost(EventKind kind, NodeId n) const {
    return {static_cast<std::int64_t>(wide(kind, n))};
  }

  // Where the pages of all fields lie, those of copies too.
  std::shared_ptr<PagePool<std::uint64_t>> wide_pool_;
  std::shared_ptr<PagePool<std::uint8_t>> narrow_pool_;
  std::array<PagedArray<std::uint64_t>, kWideSlots>
      wide_;  // by wide_slot(); those that are not declared are empty
  std::size_t wide_count_ = kWideFields;
  std::size_t longest_ = 0;  // of all fields
  KindSet forgotten_ = kForgotten;
  std::array<PagedArray<std::uint8_t>, kNarrowFields> narrow_;
  std::array<std::uint64_t, static_cast<std::size_t>(Scalar::count)> scalars_{};
  std::size_t queued_ = 0;
};

}  // namespace replan
