// The shortest of all ways through the plane: A* over the corners of obstacles that see each other.
//
//  Lozano-Perez & Wesley, "An algorithm for planning collision-free paths among polyhedral obstacles", Comm. ACM 22(10),
//  1979, doi 10.1145/359156.359164
//
// Line numbers are those of assets/planners/visibility-graph.md.
//
// What is settled here:
//  * Which corners see each other is found when a point is expanded (core/plan/visibility.hpp has that, and what ways may
//    touch): a graph with all edges would be larger than the map.
//  * c(a, b) is 2^30 times the straight way's length, rounded up, and h rounded down, so that h is consistent in whole
//    numbers and no point is expanded twice. Of equal f the one with less left to the goal is taken first.
//  * A way that cannot be part of a shortest one is left out without asking for sight: a string over it would not be taut.
//  * The log is about cells, and up to four corners, the start and the goal may share one: each corner belongs to the free
//    cell across from its obstacle. g of a cell is the least of its points, and its parent is the cell of that one's
//    parent; in the list it stands as the point of it that is taken first. Each expansion of a point is one of its cell.
//    So the log does not hold a search as it is, and one that is taken up is run again up to where it was.
//  * Obstacles are squares for a robot without a size. The corner rule `any` lets ways pass between two that meet
//    diagonally; `one` is the same as `none`: see core/lattice/squares.hpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/plan/open_list.hpp"
#include "core/plan/parameters.hpp"
#include "core/plan/registry.hpp"
#include "core/plan/visibility.hpp"
#include "core/plan/visits.hpp"
#include "core/trace/search_state.hpp"

namespace replan {

namespace parameters {

inline const Parameter kCornersHeuristic{.key = "heuristic",
                                         .label = "Heuristic",
                                         .type = ParameterType::choice,
                                         .choices = {"euclidean", "zero"},
                                         .help =
                                             "The estimate that draws the search towards the goal: the "
                                             "straight way there, or zero, which searches in "
                                             "all directions."};

}  // namespace parameters

namespace fields {

inline constexpr Field kCornersG{EventKind::g,
                                 "g",
                                 FieldType::cost,
                                 "g",
                                 "The cost from the start to the nearest point of the cell: a corner of an "
                                 "obstacle, or the cell's centre.",
                                 kInfinite};
inline constexpr Field kCornersParent{EventKind::lp, "lp", FieldType::node, "parent",
                                      "The cell of the point that its nearest one was reached from."};
inline constexpr Field kLeft{
    own_field(0), "left", FieldType::cost, "left",
    "The estimate of what is left to the goal from the point of the cell that is taken first."};

}  // namespace fields

struct VisibilityGraphSwitches {};

inline PlannerInfo describe(VisibilityGraphSwitches) {
  PlannerInfo info;
  info.name = "Visibility graph";
  info.summary =
      "The shortest of all paths, from corner to corner of obstacles: what others are measured against.";
  info.source = "Lozano-Perez & Wesley 1979, doi 10.1145/359156.359164";
  info.any_angle = info.sight = true;
  info.planar = info.eight_neighbours = true;
  info.point_only =
      "its paths touch obstacles: set the radius to 0, or choose a planner that keeps away from them, such "
      "as "
      "theta-star";
  info.values = {
      .fields = {fields::kCornersG, fields::kF, fields::kCornersParent, fields::kVisit, fields::kLeft},
      .order = {"left", {fields::kLeft.kind, fields::kLeft.kind}, [](Cost, Cost left, Cost) { return left; }},
      .cost = {EventKind::g, Scalar::goal},
      .laws = "none"};
  info.parameters = {parameters::kCornersHeuristic};
  info.length_bound = [](const Settings&) { return 1.0; };
  return info;
}

/// What is known of a point of the graph.
struct VisibilityPoint {
  Cost g = Cost::infinity();
  std::uint32_t parent = Visibility::kStart;
  std::uint32_t slot = 0;  // in the open list
};

/// All of them, as the open list asks for them.
class VisibilityPoints {
 public:
  void reset(std::size_t count) { points_.assign(count, {}); }
  [[nodiscard]] VisibilityPoint& at(std::uint32_t point) { return points_[point]; }
  [[nodiscard]] const VisibilityPoint& operator[](std::uint32_t point) const { return points_[point]; }
  [[nodiscard]] std::size_t get(NodeId point) const { return points_[point].slot; }
  void set(NodeId point, std::uint32_t slot) { points_[point].slot = slot; }
  [[nodiscard]] std::size_t memory_bytes() const { return points_.capacity() * sizeof(VisibilityPoint); }

 private:
  std::vector<VisibilityPoint> points_;
};

/// Points are taken by f, by what is left, and by their cell, so that the list of cells in a log has their order; those
/// of one cell by their numbers.
struct VisibilityKey {
  struct Rest {
    Cost left;
    NodeId cell = kNoNode;
    friend constexpr auto operator<=>(const Rest&, const Rest&) = default;
  };
  Cost k1;
  Rest k2;
};

template <Lattice L, Tracer T>
requires(L::kDimensions == 2) class VisibilityGraph final : public Planner<L> {
 public:
  VisibilityGraph(const L& lattice, const Settings& settings, T& tracer, VisibilityGraphSwitches)
      : lattice_(lattice), tr_(tracer), settings_(settings), graph_(lattice), visits_(lattice.node_count()) {}

  void begin(NodeId start, NodeId goal) override {
    counters_ = {};
    visits_.begin();
    set_end(Scalar::goal, goal_, goal);
    plan(start);
  }
  bool advance(std::int64_t iterations) override {
    for (; iterations > 0; --iterations)
      if (!step()) return true;
    return !search_needed();
  }
  void update(const MapChange<L>&, NodeId start) override { plan(start); }

  [[nodiscard]] PlanStatus status() const override {
    if (lattice_.blocked(start_)) return PlanStatus::start_blocked;
    if (lattice_.blocked(goal_)) return PlanStatus::goal_blocked;
    if (search_needed()) return PlanStatus::searching;
    return points_[kGoal].g.is_infinite() ? PlanStatus::no_path : PlanStatus::found;
  }
  [[nodiscard]] Cost cost() const override {
    return status() == PlanStatus::found ? points_[kGoal].g : Cost::infinity();
  }
  Path path() override {
    if (status() != PlanStatus::found) return {};
    std::vector<Point> way = {point_of(graph_.at(kGoal))};
    if (start_ != goal_)
      for (std::uint32_t u = kGoal; u != kStart; way.push_back(point_of(graph_.at(u)))) u = points_[u].parent;
    std::reverse(way.begin(), way.end());
    Path path(std::move(way));
    path.touches = true;
    return path;
  }
  [[nodiscard]] Counters counters() const override { return counters_; }
  [[nodiscard]] std::size_t memory_bytes() const override {
    return graph_.memory_bytes() + points_.memory_bytes() + open_.peak_bytes();
  }

  void restore(const SearchState& state, const Counters& counters) override {
    NoTrace nobody;
    VisibilityGraph<L, NoTrace> again(lattice_, settings_, nobody, {});
    again.begin(state.node(Scalar::start), state.node(Scalar::goal));
    if (const std::int64_t taken = expansions_in(state); taken > 0) again.advance(taken);
    start_ = again.start_;
    goal_ = again.goal_;
    look_at_map();
    points_ = std::move(again.points_);
    open_ = std::move(again.open_);
    counters_ = counters;
    searched_ = true;
    visits_.restore(state, counters.expansions);
  }

 private:
  template <Lattice OtherL, Tracer OtherT>
  requires(OtherL::kDimensions == 2) friend class VisibilityGraph;

  static constexpr std::uint32_t kStart = Visibility::kStart, kGoal = Visibility::kGoal;

  // Lines 1-3.
  void plan(NodeId start) {
    tr_.line(1);
    if (searched_) tr_.note(EventKind::epoch, start);
    searched_ = true;
    visits_.forget();
    set_end(Scalar::start, start_, start);
    look_at_map();
    open_.clear(points_);
    points_.reset(graph_.size());
    tr_.line(2);
    reach(kStart, kStart, Cost::zero());
  }
  void look_at_map() {
    if (std::exchange(seen_, lattice_.revision()) != lattice_.revision()) graph_.look_at_map();
    graph_.set_ends(half_centre(lattice_.position(start_)), half_centre(lattice_.position(goal_)));
  }
  void set_end(Scalar which, NodeId& held, NodeId node) {
    tr_.change(which, std::uint64_t{held + 1u}, std::uint64_t{node + 1u});
    held = node;
  }

  // Line 4.
  [[nodiscard]] bool search_needed() const {
    if (lattice_.blocked(start_) || lattice_.blocked(goal_)) return false;
    return !open_.empty() && open_.top().node != kGoal;
  }

  // Lines 5-9: one expansion.
  bool step() {
    if (!search_needed()) return false;
    tr_.line(5);
    const std::uint32_t u = take_out_top();
    ++counters_.expansions;
    visits_.record(tr_, cell_of(u));
    graph_.each_offered(u, [this, u](std::uint32_t v) { relax(u, v); });
    return true;
  }

  // Lines 7-9.
  void relax(std::uint32_t u, std::uint32_t v) {
    const Cost sum = points_[u].g + way_up(u, v);
    if (!(sum < points_[v].g) || !graph_.bends_taut(points_[u].parent, u, v)) return;
    tr_.line(8);
    if (in_sight(u, v)) reach(v, u, sum);
  }

  // Lines 10-13: a shorter way to v.
  void reach(std::uint32_t v, std::uint32_t u, Cost sum) {
    const NodeId cell = cell_of(v);
    const Shown before = shown(cell);
    points_.at(v).g = sum;
    points_.at(v).parent = u;
    if (points_[v].slot != 0)
      open_.update(points_, key_of(v), v);
    else
      open_.push(points_, key_of(v), v);
    const Shown after = shown(cell);
    tr_.line(11);
    tr_.change(EventKind::g, cell, before.g, after.g);
    tr_.line(12);
    tr_.change(EventKind::lp, cell, std::uint64_t{before.parent + 1u}, std::uint64_t{after.parent + 1u});
    tr_.line(13);
    log_queue(cell, before, after);
  }
  std::uint32_t take_out_top() {
    const std::uint32_t u = open_.top().node;
    const NodeId cell = cell_of(u);
    const Shown before = shown(cell);
    tr_.note(EventKind::pop, cell);
    open_.pop(points_);
    log_queue(cell, before, shown(cell));
    return u;
  }

  [[nodiscard]] VisibilityKey key_of(std::uint32_t u) const {
    const Cost left = estimate(u);
    return {points_[u].g + left, {left, cell_of(u)}};
  }
  /// The length of the straight way, rounded up. Points are in halves of a cell.
  [[nodiscard]] Cost way_up(std::uint32_t a, std::uint32_t b) const {
    return {(euclidean_ceil(squared_halves(a, b)).raw + 1) / 2};
  }
  [[nodiscard]] Cost estimate(std::uint32_t u) const {
    if (settings_.get(parameters::kCornersHeuristic) != 0) return Cost::zero();
    return {euclidean_floor(squared_halves(u, kGoal)).raw / 2};
  }
  [[nodiscard]] std::int64_t squared_halves(std::uint32_t a, std::uint32_t b) const {
    const HalfPoint p = graph_.at(a), q = graph_.at(b);
    return std::int64_t{p.x - q.x} * (p.x - q.x) + std::int64_t{p.y - q.y} * (p.y - q.y);
  }
  bool in_sight(std::uint32_t u, std::uint32_t v) {
    ++counters_.sight_checks;
    const bool seen = graph_.sees(u, v);
    tr_.note(EventKind::sight, cell_of(u), std::uint64_t{cell_of(v)} | std::uint64_t{seen} << 32);
    return seen;
  }

  // What the log tells of a cell.
  struct Shown {
    Cost g = Cost::infinity();
    NodeId parent = kNoNode;
    std::uint64_t queue = 0;
    Cost left = Cost::zero();
  };
  [[nodiscard]] NodeId cell_of(std::uint32_t point) const { return lattice_.node(graph_.cell_beside(point)); }
  /// By its points as they are now; nothing if nobody listens.
  [[nodiscard]] Shown shown(NodeId cell) const {
    Shown shown;
    if constexpr (T::kEnabled) {
      Cost least = Cost::infinity(), least_left = Cost::infinity();
      each_point_of(cell, [&](std::uint32_t u) {
        const VisibilityPoint& point = points_[u];
        if (point.g < shown.g) {
          shown.g = point.g;
          shown.parent = u == kStart ? kNoNode : cell_of(point.parent);
        }
        if (point.slot == 0) return;
        const Cost left = estimate(u), f = point.g + left;
        if (f > least || (f == least && left >= least_left)) return;
        least = f;
        least_left = shown.left = left;
        shown.queue = static_cast<std::uint64_t>(f.raw + 1);
      });
    }
    return shown;
  }
  /// By their numbers.
  template <class Visit>
  void each_point_of(NodeId cell, Visit&& visit) const {
    if (cell == start_) visit(kStart);
    if (cell == goal_) visit(kGoal);
    const Cell at = lattice_.position(cell);
    for (const int y : {at.y, at.y + 1})
      for (const int x : {at.x, at.x + 1})
        if (const std::uint32_t u = graph_.corner_at(x, y); u != kStart && cell_of(u) == cell) visit(u);
  }
  void log_queue(NodeId cell, const Shown& before, const Shown& after) {
    ++counters_.queue_operations;
    tr_.note(EventKind::queue, cell, before.queue ^ after.queue);
    tr_.change(fields::kLeft.kind, cell, before.left, after.left);
  }
  [[nodiscard]] static std::int64_t expansions_in(const SearchState& state) {
    std::int64_t sum = 0;
    for (NodeId n = 0; n < state.node_count(); ++n)
      if (n % SearchState::kPage == 0 && !state.touched(EventKind::visit, n))
        n += SearchState::kPage - 1;
      else
        sum += state.times_expanded(n);
    return sum;
  }

  const L& lattice_;
  T& tr_;
  const Settings settings_;
  Visibility graph_;
  std::uint64_t seen_ = 0;  // the lattice's revision that the graph is of
  VisibilityPoints points_;
  OpenList<VisibilityKey> open_;
  Visits<T> visits_;
  NodeId start_ = kNoNode, goal_ = kNoNode;
  Counters counters_;
  bool searched_ = false;
};

}  // namespace replan
