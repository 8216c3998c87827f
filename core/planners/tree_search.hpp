// What planners share that grow a tree of random places from the start: samples, what becomes of them, the goal, and how
// the tree is kept when the map or the start changes. What a new place does to the tree is left to each of them.
//
// Line numbers are those of assets/planners/rrt-star.md, which the pages of the others keep to.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/plan/registry.hpp"
#include "core/plan/visits.hpp"
#include "core/planners/grown_tree.hpp"
#include "core/planners/rrt_parameters.hpp"
#include "core/space/sampler.hpp"

namespace replan {

/// What such a tree's log holds.
inline SearchValues tree_values() {
  return {.fields = {fields::kSampled},
          .vertex_fields = {fields::kVertexX, fields::kVertexY, fields::kVertexZ, fields::kVertexParent,
                            fields::kVertexCost, fields::kVertexSide},
          .order = best_first_values().order,
          .cost = {EventKind::scalar, Scalar::best},
          .laws = "none"};
}

/// What can be said of all of them.
inline PlannerInfo describe_tree() {
  PlannerInfo info;
  info.values = tree_values();
  info.step = kSampleWords;
  info.any_angle = info.sight = info.sampling = true;
  info.eight_neighbours = true;
  info.incremental = true;
  info.parameters = {parameters::kStep, parameters::kSamples, parameters::kSamplesAgain,
                     parameters::kSampleRule, parameters::kSeed};
  info.length_bound = [](const Settings&) { return std::numeric_limits<double>::infinity(); };
  return info;
}

template <Lattice L, Tracer T>
class TreeSearch : public Planner<L> {
 public:
  /// `goal_bias`: how often the goal is the sample, until there is a path.
  TreeSearch(const L& lattice, const Settings& settings, T& tracer, double goal_bias = 0)
      : space_(lattice),
        tr_(tracer),
        sampler_(space_, static_cast<SampleRule>(static_cast<int>(settings.get(parameters::kSampleRule))),
                 static_cast<std::uint64_t>(settings.get(parameters::kSeed))),
        tree_({space_.extent(0), space_.extent(1), space_.extent(2)}, tracer),
        step_(units(settings.get(parameters::kStep))),
        visits_(lattice.node_count()),
        goal_bias_(goal_bias),
        samples_(static_cast<std::int64_t>(settings.get(parameters::kSamples))),
        again_(static_cast<std::int64_t>(settings.get(parameters::kSamplesAgain))) {}

  void begin(NodeId start, NodeId goal) final {
    tr_.line(1);
    counters_ = {};
    visits_.begin();
    set_end(Scalar::goal, goal_, goal);
    set_end(Scalar::start, start_, start);
    grow_anew();
  }
  bool advance(std::int64_t iterations) final {
    for (; iterations > 0; --iterations)
      if (!step()) return true;
    return !search_needed();
  }
  void update(const MapChange<L>& change, NodeId start) final {
    tr_.line(13);
    set_end(Scalar::start, start_, start);
    // Of a robot with a size these are the cells that have turned for its centre: what it may touch are others.
    const bool told_all = !space_.known().has_size();
    if (!told_all || std::any_of(change.cells.begin(), change.cells.end(),
                                 [](const CellEdit& edit) { return edit.blocked; }))
      cut_what_is_blocked(told_all ? reach_of(change.cells) : Reach{});
    if (ends_blocked() || tree_.full() || !hang_on_start())
      grow_anew();
    else
      begin_plan();
  }

  [[nodiscard]] PlanStatus status() const final {
    if (space_.known().blocked(start_)) return PlanStatus::start_blocked;
    if (space_.known().blocked(goal_)) return PlanStatus::goal_blocked;
    if (search_needed()) return PlanStatus::searching;
    return best_.is_infinite() ? PlanStatus::none_found : PlanStatus::found;
  }
  [[nodiscard]] Cost cost() const final { return status() == PlanStatus::found ? best_ : Cost::infinity(); }
  [[nodiscard]] Cost best_so_far() const final { return best_; }
  /// The log does not tell of it: a search that is taken up behind it goes on.
  bool settle() final {
    settled_ = !best_.is_infinite();
    return settled_;
  }
  Path path() final {
    if (status() != PlanStatus::found) return {};
    std::vector<Point> way;
    for (std::uint32_t v = goal_vertex_; v != kNone; v = tree_.parent(v))
      if (const Point point = point_of(tree_.place(v)); way.empty() || way.back() != point)
        way.push_back(point);
    std::reverse(way.begin(), way.end());
    return Path(std::move(way));
  }
  [[nodiscard]] Counters counters() const final { return counters_; }
  [[nodiscard]] std::size_t memory_bytes() const final { return tree_.memory_bytes(); }

  void restore(const SearchState& state, const Counters& counters) final {
    counters_ = counters;
    start_ = state.node(Scalar::start);
    goal_ = state.node(Scalar::goal);
    tree_.restore(state);
    root_ = static_cast<std::uint32_t>(state.scalar(Scalar::root)) - 1u;
    best_ = {static_cast<std::int64_t>(state.scalar(Scalar::best))};
    goal_vertex_ = static_cast<std::uint32_t>(state.scalar(Scalar::goal_vertex)) - 1u;
    if (goal_vertex_ == kNone) best_ = Cost::infinity();
    plan_sample_ = static_cast<std::int64_t>(state.scalar(Scalar::plan_sample));
    gain_sample_ = static_cast<std::int64_t>(state.scalar(Scalar::gain_sample));
    settled_ = false;
    told_ = told_in(state);
    visits_.restore(state, counters.expansions);
  }

 protected:
  static constexpr int D = L::kDimensions;
  static constexpr std::uint32_t kNone = GrownTree<D, T>::kNone;

  /// Lines 4-12: what a sample comes to.
  virtual void grow_towards(const Place& sample) = 0;
  /// The tree has a root, and its plan begins.
  virtual void planted() {}
  /// Where the sample of that number lies, once there is a path.
  [[nodiscard]] virtual Place sample_with_path(std::int64_t number) const = 0;
  /// The line on which samples are drawn now.
  [[nodiscard]] virtual int sampling_line() const { return 3; }
  /// Whether samples can make the path that there is any better.
  [[nodiscard]] virtual bool path_could_gain() const = 0;

  /// Lines 4-6: a place within a step of the nearest vertex, on the way to the sample, and that vertex; nothing if the
  /// sample is given up.
  struct Offshoot {
    Place place;
    std::uint32_t nearest;
  };
  std::optional<Offshoot> offshoot(const Place& sample, TreeSide side = TreeSide::start) {
    tr_.line(4);
    const std::uint32_t nearest = tree_.nearest(sample, side);
    tell_nearest(nearest);
    tr_.line(5);
    const Place place = steer_from(nearest, sample);
    if (place == tree_.place(nearest)) {
      reject(SampleFault::taken, space_.node(place));
      return std::nullopt;
    }
    tr_.line(6);
    if (const auto hit = hit_from(nearest, place)) {
      reject(SampleFault::blocked, space_.known().node(*hit));
      return std::nullopt;
    }
    return Offshoot{place, nearest};
  }
  void tell_nearest(std::uint32_t vertex) {
    tell(Scalar::nearest, std::uint64_t{told_.nearest + 1u}, std::uint64_t{vertex + 1u});
    told_.nearest = vertex;
  }
  Place steer_from(std::uint32_t vertex, const Place& sample) {
    const Place place = steer(tree_.place(vertex), sample, step_);
    tell_place(Scalar::new_x, told_.place, place);
    return place;
  }
  /// Line 7.
  void tell_ball(std::int64_t reach) {
    tr_.line(7);
    tell(Scalar::ball, coordinate_bits(told_.ball), coordinate_bits(reach));
    told_.ball = reach;
  }
  void reject(SampleFault why, NodeId cell) {
    tr_.note(EventKind::rejected, cell, static_cast<std::uint64_t>(why));
  }

  // Line 12: of a vertex that is no farther from the goal than that, in units.
  void join_goal(std::uint32_t added, std::int64_t goal_reach) {
    const Place goal = goal_place();
    if (tree_.place(added) == goal) return reach_goal(added);
    if (squared_between(tree_.place(added), goal) > goal_reach * goal_reach) return;
    if (goal_vertex_ != kNone && !(tree_.cost_over(added, goal) < tree_.cost(goal_vertex_))) return;
    if (tree_.full() || hit_from(added, goal)) return;
    tr_.line(12);
    if (goal_vertex_ == kNone)
      reach_goal(tree_.grow(goal, added));
    else
      tree_.hang(goal_vertex_, added);
  }
  void reach_goal(std::uint32_t vertex) {
    tr_.line(12);
    set_goal_vertex(vertex);
    take_gain();
  }
  /// The path is shorter than it was, if it is.
  void take_gain() {
    if (goal_vertex_ == kNone || tree_.cost(goal_vertex_) == best_) return;
    set_best(tree_.cost(goal_vertex_));
    set_count(Scalar::gain_sample, gain_sample_, counters_.expansions);
  }

  /// A vertex hangs on another one if the way to it is shorter so, and free; that is on such a line.
  void hang_if_shorter(std::uint32_t v, std::uint32_t added, int line) {
    const Cost sum = tree_.cost_over(added, tree_.place(v)), before = tree_.cost(v);
    if (!(sum < before) || hit_from(added, tree_.place(v))) return;
    tr_.line(line);
    tr_.note(EventKind::rewired, v, static_cast<std::uint64_t>(before.raw - sum.raw));
    tree_.hang(v, added);
  }
  /// The obstacle in the way from a vertex to a place.
  std::optional<Cell> hit_from(std::uint32_t v, const Place& place) {
    ++counters_.sight_checks;
    const auto hit = space_.hit(tree_.place(v), place);
    tr_.note(EventKind::sight, space_.node(tree_.place(v)),
             std::uint64_t{space_.node(place)} | std::uint64_t{!hit} << 32);
    return hit;
  }
  [[nodiscard]] Place place_in_world(NodeId node) const { return place_in(space_.known().position(node)); }
  [[nodiscard]] Place start_place() const { return place_in_world(start_); }
  [[nodiscard]] Place goal_place() const { return place_in_world(goal_); }
  static std::uint64_t bits(Cost cost) { return static_cast<std::uint64_t>(cost.raw); }
  /// Samples since the path became shorter.
  [[nodiscard]] std::int64_t without_gain() const { return counters_.expansions - gain_sample_; }
  [[nodiscard]] Cost best() const { return best_; }
  /// The goal's; kNone without a path.
  [[nodiscard]] std::uint32_t goal_vertex() const { return goal_vertex_; }
  static std::int64_t units(double cells) { return std::llround(cells * kPlaceUnits); }

  const FreeSpace<D> space_;
  T& tr_;
  const Sampler<D> sampler_;
  GrownTree<D, T> tree_;
  const std::int64_t step_;  // units

 private:
  static constexpr auto kFar = std::numeric_limits<std::int64_t>::max();

  /// The places that a change of the map may have blocked, a box around them: at first all.
  struct Reach {
    Place low{-kFar, -kFar, -kFar}, high{kFar, kFar, kFar};
    [[nodiscard]] bool meets(const Place& a, const Place& b) const {
      for (std::size_t i = 0; i < D; ++i)
        if (std::max(a[i], b[i]) < low[i] || std::min(a[i], b[i]) > high[i]) return false;
      return true;
    }
  };

  // Line 1.
  void grow_anew() {
    if (tree_.size() > 0) {
      tr_.note(EventKind::epoch, start_);
      tell(Scalar::vertices, tree_.size(), 0);
      visits_.forget();
      tree_.clear();
    }
    set_goal_vertex(kNone);
    set_best(Cost::infinity());
    set_root(ends_blocked() ? kNone : tree_.plant(start_place()));
    if (root_ != kNone && start_ == goal_) reach_goal(root_);
    begin_plan();
  }
  void begin_plan() {
    settled_ = false;
    if (root_ != kNone) planted();
    set_count(Scalar::plan_sample, plan_sample_, counters_.expansions);
    set_count(Scalar::gain_sample, gain_sample_, counters_.expansions);
  }

  // Line 2.
  [[nodiscard]] bool search_needed() const {
    if (ends_blocked() || start_ == goal_ || tree_.full() || settled_) return false;
    const std::int64_t drawn = counters_.expansions - plan_sample_;
    if (best_.is_infinite()) return drawn < samples_;
    return drawn < (plan_sample_ == 0 ? samples_ : again_) && path_could_gain();
  }

  // Lines 2-12: one sample.
  bool step() {
    if (!search_needed()) return false;
    grow_towards(draw());
    return true;
  }

  Place draw() {
    tr_.line(sampling_line());
    const std::int64_t number = ++counters_.expansions;
    const Place sample = sample_of(number);
    const NodeId cell = space_.node(sample);
    tr_.note(EventKind::pop, cell);
    visits_.record(tr_, cell);
    tell_place(Scalar::sample_x, told_.sample, sample);
    return sample;
  }
  [[nodiscard]] Place sample_of(std::int64_t number) const {
    constexpr std::uint64_t kBias = 0x60A1;  // so that what the bias is decided by are numbers of their own
    if (!best_.is_infinite()) return sample_with_path(number);
    Random bias(sampler_.numbers(number).next() ^ kBias);
    return bias.chance(goal_bias_) ? goal_place() : sampler_.anywhere(number);
  }

  // Lines 14 and 15.
  void cut_what_is_blocked(const Reach& changed) {
    tr_.line(14);
    for (std::uint32_t v = 0; v < tree_.size(); ++v) {
      if (tree_.cut_off(v)) continue;
      const Place& from = tree_.parent(v) == kNone ? tree_.place(v) : tree_.place(tree_.parent(v));
      if (changed.meets(from, tree_.place(v)) && space_.hit(from, tree_.place(v))) tree_.cut(v);
    }
    if (root_ != kNone && tree_.cut_off(root_)) set_root(kNone);
    if (goal_vertex_ == kNone || !tree_.cut_off(goal_vertex_)) return;
    set_goal_vertex(kNone);
    set_best(Cost::infinity());
  }
  /// Lines 16-18: the start is the root, and near vertices hang on it that are nearer by it. False if nothing sees it.
  bool hang_on_start() {
    const Place start = start_place();
    tr_.line(16);
    if (root_ == kNone) return false;
    if (tree_.place(root_) != start) {
      const std::vector<std::uint32_t> way = way_of_path();
      const std::uint32_t link = vertex_seen_from(start, way);
      if (link == kNone) return false;
      tree_.make_root(link);
      set_root(link);
      if (tree_.place(link) != start) hang_on_new_root(start, way);
    }
    if (start_ == goal_) set_goal_vertex(root_);
    take_change();
    return true;
  }
  void hang_on_new_root(const Place& start, const std::vector<std::uint32_t>& way) {
    const std::uint32_t added = tree_.grow(start, root_);
    tree_.make_root(added);
    set_root(added);
    for (const std::uint32_t v : near_start(start, way))
      if (v != added) hang_if_shorter(v, added, 18);
  }
  /// From the goal to the root; nothing without a path.
  [[nodiscard]] std::vector<std::uint32_t> way_of_path() const {
    std::vector<std::uint32_t> way;
    for (std::uint32_t v = goal_vertex_; v != kNone; v = tree_.parent(v)) way.push_back(v);
    return way;
  }
  /// The vertices within a step, and those of the path: its ways may be longer than a step.
  [[nodiscard]] std::vector<std::uint32_t> near_start(const Place& start,
                                                      const std::vector<std::uint32_t>& way) const {
    std::vector<std::uint32_t> near = tree_.within(start, step_);
    for (const std::uint32_t v : way)
      if (squared_between(tree_.place(v), start) > step_ * step_) near.push_back(v);
    return near;
  }
  /// The nearest vertex, or of those near the start the nearest that the way is free to.
  std::uint32_t vertex_seen_from(const Place& start, const std::vector<std::uint32_t>& way) {
    std::vector<std::uint32_t> near(1, tree_.nearest(start));
    if (near[0] == kNone) return kNone;
    const auto found = near_start(start, way);
    near.insert(near.end(), found.begin(), found.end());
    std::stable_sort(near.begin(), near.end(), [&](std::uint32_t a, std::uint32_t b) {
      return squared_between(tree_.place(a), start) < squared_between(tree_.place(b), start);
    });
    for (const std::uint32_t v : near)
      if (!hit_from(v, start)) return v;
    return kNone;
  }
  /// The path changes with the start, for better or worse.
  void take_change() { set_best(goal_vertex_ == kNone ? Cost::infinity() : tree_.cost(goal_vertex_)); }

  [[nodiscard]] Reach reach_of(std::span<const CellEdit> cells) const {
    Reach reach{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
    constexpr std::int64_t margin = 2 * kPlaceUnits;
    for (const CellEdit& edit : cells) {
      const Place at = place_in_world(edit.node);
      for (std::size_t i = 0; i < 3; ++i) {
        reach.low[i] = std::min(reach.low[i], at[i] - margin);
        reach.high[i] = std::max(reach.high[i], at[i] + margin);
      }
    }
    return reach;
  }

  [[nodiscard]] bool ends_blocked() const {
    return space_.known().blocked(start_) || space_.known().blocked(goal_);
  }
  // What the log holds besides the tree.
  void set_end(Scalar which, NodeId& held, NodeId node) {
    tr_.change(which, std::uint64_t{held + 1u}, std::uint64_t{node + 1u});
    held = node;
  }
  void set_goal_vertex(std::uint32_t vertex) {
    tell(Scalar::goal_vertex, std::uint64_t{goal_vertex_ + 1u}, std::uint64_t{vertex + 1u});
    goal_vertex_ = vertex;
  }
  void set_root(std::uint32_t vertex) {
    tell(Scalar::root, std::uint64_t{root_ + 1u}, std::uint64_t{vertex + 1u});
    root_ = vertex;
  }
  void set_best(Cost cost) {
    const auto held = [](Cost best) { return best.is_infinite() ? 0 : bits(best); };
    tell(Scalar::best, held(best_), held(cost));
    best_ = cost;
  }
  void set_count(Scalar which, std::int64_t& held, std::int64_t count) {
    tell(which, static_cast<std::uint64_t>(held), static_cast<std::uint64_t>(count));
    held = count;
  }
  void tell(Scalar which, std::uint64_t before, std::uint64_t after) { tr_.change(which, before, after); }
  /// Three scalars from `first` on.
  void tell_place(Scalar first, Place& held, const Place& place) {
    for (std::size_t i = 0; i < D; ++i)
      tell(static_cast<Scalar>(static_cast<std::size_t>(first) + i), coordinate_bits(held[i]),
           coordinate_bits(place[i]));
    held = place;
  }

  /// Of the latest sample.
  struct Told {
    Place sample{}, place{};
    std::uint32_t nearest = kNone;
    std::int64_t ball = 0;
  };
  [[nodiscard]] static Told told_in(const SearchState& state) {
    Told told;
    const auto read = [&](Scalar first, Place& place) {
      for (std::size_t i = 0; i < D; ++i)
        place[i] = units_of(state.scalar(static_cast<Scalar>(static_cast<std::size_t>(first) + i)));
    };
    read(Scalar::sample_x, told.sample);
    read(Scalar::new_x, told.place);
    told.nearest = static_cast<std::uint32_t>(state.scalar(Scalar::nearest)) - 1u;
    told.ball = units_of(state.scalar(Scalar::ball));
    return told;
  }

  Visits<T> visits_;
  const double goal_bias_;
  const std::int64_t samples_, again_;
  NodeId start_ = kNoNode, goal_ = kNoNode;
  std::uint32_t root_ = kNone, goal_vertex_ = kNone;
  Cost best_ = Cost::infinity();
  std::int64_t plan_sample_ = 0, gain_sample_ = 0;
  bool settled_ = false;
  Told told_;
  Counters counters_;
};

}  // namespace replan
