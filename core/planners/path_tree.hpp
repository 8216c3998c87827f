// A tree that leads somewhere: it hangs on the search's start, and once it has met the goal it has a path.
//
// Line numbers are those of assets/planners/rrt-star.md.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/plan/path.hpp"
#include "core/planners/checked_way.hpp"
#include "core/planners/grown_tree.hpp"
#include "core/space/free_space.hpp"

namespace replan {

/// Its ends, its root, the goal's vertex and the cost of the path are numbers of the run.
template <int D, Tracer T>
class PathTree : public GrownTree<D, T> {
 public:
  using Tree = GrownTree<D, T>;
  using Tree::kNone;

  PathTree(const FreeSpace<D>& space, RunNumbers<T>& numbers, Counters& counters, T& tracer)
      : Tree({space.extent(0), space.extent(1), space.extent(2)}, numbers, tracer),
        space_(space),
        tr_(tracer),
        numbers_(numbers),
        counters_(counters) {}

  [[nodiscard]] NodeId start() const { return numbers_.number(Scalar::start); }
  [[nodiscard]] NodeId goal() const { return numbers_.number(Scalar::goal); }
  [[nodiscard]] Place start_place() const { return place_in(space_.known().position(start())); }
  [[nodiscard]] Place goal_place() const { return place_in(space_.known().position(goal())); }
  /// What the others hang on; kNone without one.
  [[nodiscard]] std::uint32_t root() const { return numbers_.number(Scalar::root); }
  /// The goal's; kNone without a path.
  [[nodiscard]] std::uint32_t goal_vertex() const { return numbers_.number(Scalar::goal_vertex); }
  /// The cost of the path; infinite without one.
  [[nodiscard]] Cost best() const {
    return goal_vertex() == kNone ? Cost::infinity() : numbers_.cost(Scalar::best);
  }
  /// From the goal to the root; nothing without a path.
  [[nodiscard]] std::vector<std::uint32_t> way() const {
    std::vector<std::uint32_t> way;
    for (std::uint32_t v = goal_vertex(); v != kNone; v = parent(v)) way.push_back(v);
    return way;
  }
  /// From the root to the goal, each point once.
  [[nodiscard]] Path path() const {
    std::vector<Point> points;
    for (const std::uint32_t v : way())
      if (const Point point = point_of(place(v)); points.empty() || points.back() != point)
        points.push_back(point);
    std::reverse(points.begin(), points.end());
    return Path(std::move(points));
  }

  // Line 1: of a tree without vertices. It has no root if an end is blocked.
  void plant_root(bool ends_are_free) {
    lose_path();
    numbers_.set_number(Scalar::root, ends_are_free ? this->plant(start_place()) : kNone);
    if (root() != kNone && start() == goal()) reach_goal(root());
  }
  /// The tree turns round: it hangs on that vertex from now on.
  void turn_to(std::uint32_t v) {
    this->make_root(v);
    numbers_.set_number(Scalar::root, v);
  }
  /// Root and goal are no longer what was cut off.
  void lose_ends_that_are_cut_off() {
    if (root() != kNone && this->cut_off(root())) numbers_.set_number(Scalar::root, kNone);
    if (goal_vertex() != kNone && this->cut_off(goal_vertex())) lose_path();
  }

  // Line 12: of a vertex that is no farther from the goal than that, in units.
  void join_goal(std::uint32_t added, std::int64_t goal_reach) {
    const Place goal = goal_place();
    if (place(added) == goal) return reach_goal(added);
    if (squared_between(place(added), goal) > goal_reach * goal_reach) return;
    if (goal_vertex() != kNone && !(this->cost_over(added, goal) < cost(goal_vertex()))) return;
    if (this->full() || hit_from(added, goal)) return;
    tr_.line(12);
    if (goal_vertex() == kNone)
      reach_goal(this->grow(goal, added));
    else
      this->hang(goal_vertex(), added);
  }
  void reach_goal(std::uint32_t vertex) {
    tr_.line(12);
    const Cost before = best();
    numbers_.set_number(Scalar::goal_vertex, vertex);
    take_gain_over(before);
  }
  /// The path is shorter than it was, if it is.
  void take_gain() {
    if (goal_vertex() != kNone) take_gain_over(best());
  }
  /// The path has changed with the start, for better or worse.
  void take_change() {
    if (start() == goal()) numbers_.set_number(Scalar::goal_vertex, root());
    numbers_.set_cost(Scalar::best, goal_vertex() == kNone ? Cost::zero() : cost(goal_vertex()));
  }

  /// A vertex hangs on another one if the way to it is shorter so, and free; that is on such a line.
  void hang_if_shorter(std::uint32_t v, std::uint32_t added, int line) {
    const Cost sum = this->cost_over(added, place(v)), before = cost(v);
    if (!(sum < before) || hit_from(added, place(v))) return;
    tr_.line(line);
    tr_.note(EventKind::rewired, v, static_cast<std::uint64_t>(before.raw - sum.raw));
    this->hang(v, added);
  }
  /// The obstacle in the way from a vertex to a place.
  std::optional<Cell> hit_from(std::uint32_t v, const Place& to) {
    return hit_on_checked_way(space_.known(), point_of(place(v)), point_of(to), tr_, counters_);
  }

  using Tree::cost;
  using Tree::parent;
  using Tree::place;

 private:
  void lose_path() {
    numbers_.set_number(Scalar::goal_vertex, kNone);
    numbers_.set_cost(Scalar::best, Cost::zero());
  }
  void take_gain_over(Cost before) {
    const Cost now = cost(goal_vertex());
    if (now == before) return;
    numbers_.set_cost(Scalar::best, now);
    numbers_.set_count(Scalar::gain_sample, counters_.expansions);
  }

  const FreeSpace<D>& space_;
  T& tr_;
  RunNumbers<T>& numbers_;
  Counters& counters_;
};

}  // namespace replan
