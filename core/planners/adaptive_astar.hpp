// A* whose estimate counts more the fewer obstacles there are: f = g + (1 - ln K) h, the improved A* of
//
//  Liu J., Xue L., Zhang H. & Liu Z., "Robot dynamic path planning based on improved A* and DWA algorithm" (Henan
//  University of Technology)
//
// K = N / A, with A the cells of the rectangle (box) that start and goal span, and N the obstacles among them on the
// robot's map. Without obstacles the search is greedy; where all is blocked it is A*.
//
// Settled here:
//  * K = 0 is taken for 1 / A, so that the weight stays finite.
//  * h is Euclidean, as in the paper, rounded down.
//  * The weight is worked out once for each plan, in whole cells counted and one logarithm of our own
//    (core/base/logarithm.hpp), and kept as a number of 2^-30, rounded down. It stands in the log with K.
//  * No path costs more than that weight times the cheapest, and no vertex is taken twice, as of Weighted A*
//    (weighted_astar.hpp).
//  * Each plan is made from scratch, on the robot's map as it is then: K changes with what the robot finds.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/logarithm.hpp"
#include "core/planners/best_first.hpp"

namespace replan {

struct AdaptiveAStarSwitches {};

/// f with the weight that the search has worked out.
struct GPlusGivenWeightH {
  static constexpr const char* kLaw = "a key in the list is g + (1 - ln K) h";
  static constexpr bool kOnce = true;
  explicit GPlusGivenWeightH(const Settings&) {}
  Cost operator()(Cost g, Cost h, Cost weight) const { return g + weighted(h, weight); }
};

/// How full of obstacles a rectangle is, and what the estimate counts there.
struct ObstacleShare {
  std::int64_t obstacles = 0, cells = 1;

  /// K, as a number of 2^-30, rounded down.
  [[nodiscard]] Cost share() const {
    return {static_cast<std::int64_t>((static_cast<double>(counted()) / static_cast<double>(cells)) *
                                      static_cast<double>(Cost::kScale))};
  }
  /// 1 - ln K, as a number of 2^-30, rounded down; at least 1.
  [[nodiscard]] Cost weight() const {
    const double weight = 1 + natural_log(static_cast<double>(cells) / static_cast<double>(counted()));
    return {static_cast<std::int64_t>(std::floor(weight * static_cast<double>(Cost::kScale)))};
  }

 private:
  [[nodiscard]] std::int64_t counted() const { return obstacles == 0 ? 1 : obstacles; }
};

/// Of the rectangle (box) that two nodes span, both counted.
template <int D>
ObstacleShare obstacle_share(const BoxLattice<D>& lattice, NodeId a, NodeId b) {
  auto low = lattice.coordinates(a), high = lattice.coordinates(b);
  ObstacleShare result;
  for (std::size_t axis = 0; axis < D; ++axis) {
    if (low[axis] > high[axis]) std::swap(low[axis], high[axis]);
    result.cells *= high[axis] - low[axis] + 1;
  }
  const auto blocked = lattice.cells();
  const auto row = static_cast<std::size_t>(high[0] - low[0]) + 1;
  for (auto at = low;;) {  // a row from low[0] on
    const auto first = blocked.begin() + static_cast<std::ptrdiff_t>(lattice.node(at));
    result.obstacles += std::count_if(first, first + static_cast<std::ptrdiff_t>(row),
                                      [](std::uint8_t cell) { return cell != 0; });
    std::size_t axis = 1;
    for (; axis < D && at[axis] == high[axis]; ++axis) at[axis] = low[axis];
    if (axis == D) return result;
    ++at[axis];
  }
}

inline PlannerInfo describe(AdaptiveAStarSwitches) {
  PlannerInfo info;
  info.name = "Adaptive A*";
  info.summary = "A* whose estimate counts more the fewer obstacles lie between start and goal.";
  info.source = "Liu, Xue, Zhang & Liu, robot dynamic path planning: improved A* fused with DWA";
  info.key = key_rule<GPlusGivenWeightH>();
  info.values.numbers = {
      {Scalar::share, "obstacle_share", "K",
       "How much of the rectangle between start and goal is obstacle, on the robot's map; one cell of it if "
       "none."},
      {Scalar::weight, "weight", "1 − ln K",
       "What the estimate counts in the plan that stands: a path costs at most so many times the cheapest."}};
  for (Field& field : info.values.fields)
    if (field.kind == EventKind::queue) field.help = "g + (1 − ln K) h while it waits in the open list.";
  info.parameters = {parameters::kStraightHeuristic};
  // 1 + ln of the most cells that a map may have.
  info.length_bound = [](const Settings&) { return 1 + 27 * std::numbers::ln2; };
  return info;
}

template <Lattice L, Tracer T>
class AdaptiveAStar final : public BestFirst<L, T, GPlusGivenWeightH, AdaptiveAStar<L, T>> {
  using Base = BestFirst<L, T, GPlusGivenWeightH, AdaptiveAStar<L, T>>;
  friend Base;

 public:
  using Base::Base;

  [[nodiscard]] Cost number(Scalar which) const override {
    return which == Scalar::weight ? weight_ : which == Scalar::share ? share_ : Cost::zero();
  }
  void restore(const SearchState& state, const Counters& counters) override {
    weight_ = {static_cast<std::int64_t>(state.scalar(Scalar::weight))};
    share_ = {static_cast<std::int64_t>(state.scalar(Scalar::share))};
    Base::restore(state, counters);
  }

 private:
  using Base::goal_, Base::lattice_, Base::start_, Base::tr_;

  // Lines 13-15.
  void prepare() {
    tr_.line(14);
    const ObstacleShare share = obstacle_share(lattice_, start_, goal_);
    set_number(Scalar::share, share_, share.share());
    tr_.line(15);
    set_number(Scalar::weight, weight_, share.weight());
  }
  [[nodiscard]] Cost weight() const { return weight_; }

  void set_number(Scalar which, Cost& held, Cost number) {
    tr_.change(which, Base::raw(held), Base::raw(number));
    held = number;
  }

  Cost share_, weight_;
};

}  // namespace replan
