// What planners share that grow a tree of random places from the start: the plan, its samples, and what becomes of them up
// to a new place. What that does to the tree is left to each of them.
//
// Line numbers are those of assets/planners/rrt-star.md, which the pages of the others keep to.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/plan/registry.hpp"
#include "core/plan/visits.hpp"
#include "core/planners/path_tree.hpp"
#include "core/planners/rrt_parameters.hpp"
#include "core/planners/tree_repair.hpp"
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
        numbers_(tracer),
        sampler_(space_, static_cast<SampleRule>(static_cast<int>(settings.get(parameters::kSampleRule))),
                 static_cast<std::uint64_t>(settings.get(parameters::kSeed))),
        tree_(space_, numbers_, counters_, tracer),
        step_(units(settings.get(parameters::kStep))),
        repair_(tree_, space_, tracer, step_),
        visits_(lattice.node_count()),
        goal_bias_(goal_bias),
        samples_(static_cast<std::int64_t>(settings.get(parameters::kSamples))),
        again_(static_cast<std::int64_t>(settings.get(parameters::kSamplesAgain))) {}

  void begin(NodeId start, NodeId goal) final {
    tr_.line(1);
    counters_ = {};
    visits_.begin();
    numbers_.set_number(Scalar::goal, goal);
    numbers_.set_number(Scalar::start, start);
    grow_anew();
  }
  bool advance(std::int64_t iterations) final {
    for (; iterations > 0 && search_needed(); --iterations) grow_towards(draw());
    return !search_needed();
  }
  // Lines 13-18.
  void update(const MapChange<L>& change, NodeId start) final {
    tr_.line(13);
    numbers_.set_number(Scalar::start, start);
    repair_.cut_what_is_blocked(change.cells);
    if (ends_blocked() || tree_.full() || !repair_.hang_on_start())
      grow_anew();
    else
      begin_plan();
  }

  [[nodiscard]] PlanStatus status() const final {
    if (space_.known().blocked(tree_.start())) return PlanStatus::start_blocked;
    if (space_.known().blocked(tree_.goal())) return PlanStatus::goal_blocked;
    if (search_needed()) return PlanStatus::searching;
    return has_path() ? PlanStatus::found : PlanStatus::none_found;
  }
  [[nodiscard]] Cost cost() const final {
    return status() == PlanStatus::found ? tree_.best() : Cost::infinity();
  }
  [[nodiscard]] Cost best_so_far() const final { return tree_.best(); }
  /// The log does not tell of it: a search that is taken up behind it goes on.
  bool settle() final {
    settled_ = has_path();
    return settled_;
  }
  Path path() final { return status() == PlanStatus::found ? tree_.path() : Path{}; }
  [[nodiscard]] Counters counters() const final { return counters_; }
  [[nodiscard]] std::size_t memory_bytes() const final { return tree_.memory_bytes(); }

  void restore(const SearchState& state, const Counters& counters) final {
    counters_ = counters;
    settled_ = false;
    numbers_.restore(state);
    tree_.restore(state);
    visits_.restore(state, counters.expansions);
  }

 protected:
  static constexpr int D = L::kDimensions;
  static constexpr std::uint32_t kNone = PathTree<D, T>::kNone;

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
    if (const auto hit = tree_.hit_from(nearest, place)) {
      reject(SampleFault::blocked, space_.known().node(*hit));
      return std::nullopt;
    }
    return Offshoot{place, nearest};
  }
  void tell_nearest(std::uint32_t vertex) { numbers_.set_number(Scalar::nearest, vertex); }
  Place steer_from(std::uint32_t vertex, const Place& sample) {
    const Place place = steer(tree_.place(vertex), sample, step_);
    numbers_.template set_place<D>(Scalar::new_x, place);
    return place;
  }
  /// Line 7.
  void tell_ball(std::int64_t reach) {
    tr_.line(7);
    numbers_.set_length(Scalar::ball, reach);
  }
  void reject(SampleFault why, NodeId cell) {
    tr_.note(EventKind::rejected, cell, static_cast<std::uint64_t>(why));
  }

  [[nodiscard]] bool has_path() const { return tree_.goal_vertex() != kNone; }
  /// Samples since the path became shorter.
  [[nodiscard]] std::int64_t without_gain() const {
    return counters_.expansions - numbers_.count(Scalar::gain_sample);
  }
  static std::int64_t units(double cells) { return std::llround(cells * kPlaceUnits); }

  const FreeSpace<D> space_;
  T& tr_;
  Counters counters_;
  RunNumbers<T> numbers_;
  const Sampler<D> sampler_;
  PathTree<D, T> tree_;
  const std::int64_t step_;  // units

 private:
  // Line 1.
  void grow_anew() {
    if (tree_.size() > 0) {
      tr_.note(EventKind::epoch, tree_.start());
      tree_.clear();
      visits_.forget();
    }
    tree_.plant_root(!ends_blocked());
    begin_plan();
  }
  void begin_plan() {
    settled_ = false;
    if (tree_.root() != kNone) planted();
    numbers_.set_count(Scalar::plan_sample, counters_.expansions);
    numbers_.set_count(Scalar::gain_sample, counters_.expansions);
  }

  // Line 2.
  [[nodiscard]] bool search_needed() const {
    if (ends_blocked() || tree_.start() == tree_.goal() || tree_.full() || settled_) return false;
    const std::int64_t before = numbers_.count(Scalar::plan_sample), drawn = counters_.expansions - before;
    if (!has_path()) return drawn < samples_;
    return drawn < (before == 0 ? samples_ : again_) && path_could_gain();
  }

  // Line 3.
  Place draw() {
    tr_.line(sampling_line());
    const std::int64_t number = ++counters_.expansions;
    const Place sample = sample_of(number);
    const NodeId cell = space_.node(sample);
    tr_.note(EventKind::pop, cell);
    visits_.record(tr_, cell);
    numbers_.template set_place<D>(Scalar::sample_x, sample);
    return sample;
  }
  [[nodiscard]] Place sample_of(std::int64_t number) const {
    constexpr std::uint64_t kBias = 0x60A1;  // so that what the bias is decided by are numbers of their own
    if (has_path()) return sample_with_path(number);
    Random bias(sampler_.numbers(number).next() ^ kBias);
    return bias.chance(goal_bias_) ? tree_.goal_place() : sampler_.anywhere(number);
  }
  [[nodiscard]] bool ends_blocked() const {
    return space_.known().blocked(tree_.start()) || space_.known().blocked(tree_.goal());
  }

  TreeRepair<D, T> repair_;
  Visits<T> visits_;
  const double goal_bias_;
  const std::int64_t samples_, again_;
  bool settled_ = false;
};

}  // namespace replan
