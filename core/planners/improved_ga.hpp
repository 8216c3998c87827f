// The improved genetic algorithm: a population of paths that are crossed and changed, generation after generation.
//
//  Tuncer A. & Yildirim M., "Dynamic path planning of mobile robots with improved genetic algorithm", Computers & Electrical
//  Engineering 38(6), 2012, doi 10.1016/j.compeleceng.2012.06.016
//  Huang L. & Zhou F., "Path planning of moving robot based on path optimization of D* Lite algorithm", Control and
//  Decision, 2018, doi 10.13195/j.kzyjc.2018.0583, which compares with it
//
// Line numbers are those of assets/planners/improved-ga.md.
//
// What is settled here:
//  * One iteration makes one child, and a generation is as many children as the population has paths. A child takes the place
//    of the least fit path at once, if it is fitter and no twin of another: the fittest one is never lost.
//  * Children are numbered, and what is random about one is drawn from its number and the seed alone: a run that is taken up
//    goes on with the same ones.
//  * Ways between cells are straight, and held against the obstacles and the robot's radius in whole numbers
//    (core/lattice/body_way.hpp). Lengths are rounded up, and all that is compared is whole numbers.
//  * The paper's first paths are random cells in any order. In a world of many obstacles all of them hit so much that no
//    crossing mends them: of ten worlds of 200 x 200 cells, a sixth of them obstacles, that solved none. So the first paths go
//    by sight: from cell to cell that is seen from there, of two random ones to that nearer to the goal.
//  * A path that hits nothing is fitter than any that does, however small the penalty: what is returned hits nothing, and
//    where no path of the population is so, none was found.
//  * A neighbour may be a cell of the path already: the loop that this closes is deleted, so that mutation takes cells out.
//  * The map or the start changes: lines 13-16. All paths are kept, joined to the new start and held against the new map.
//    A population that has bred for long is much alike, and one obstacle can cut off all of it; so where a path hits something
//    a new one takes its place, if it is fitter, as the first ones were made.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/plan/registry.hpp"
#include "core/plan/visits.hpp"
#include "core/planners/breeding.hpp"
#include "core/planners/first_paths.hpp"

namespace replan {

struct ImprovedGaSwitches {};

inline PlannerInfo describe(ImprovedGaSwitches) {
  PlannerInfo info;
  info.name = "Improved GA";
  info.summary = "A genetic algorithm: paths are crossed and changed, and the fittest ones stay.";
  info.source = "Tuncer & Yildirim 2012, doi 10.1016/j.compeleceng.2012.06.016";
  info.values = {.fields = {fields::kBred},
                 .vertex_fields = {fields::kPathCell, fields::kPathHit, fields::kPathCost},
                 .order = best_first_values().order,
                 .cost = {EventKind::scalar, Scalar::best},
                 .laws = "none"};
  info.step = kChildWords;
  info.any_angle = info.sight = info.evolving = true;
  info.eight_neighbours = true;
  info.incremental = true;
  info.parameters = {parameters::kPopulation,   parameters::kGenerations,   parameters::kGenerationsAgain,
                     parameters::kMostCells,    parameters::kFirstPaths,    parameters::kTournament,
                     parameters::kCrossover,    parameters::kCrossoverRate, parameters::kMutation,
                     parameters::kMutationRate, parameters::kMutationReach, parameters::kHitPenalty,
                     parameters::kBreedingSeed};
  info.length_bound = [](const Settings&) { return std::numeric_limits<double>::infinity(); };
  return info;
}

template <Lattice L, Tracer T>
class ImprovedGa final : public Planner<L> {
 public:
  ImprovedGa(const L& lattice, const Settings& settings, T& tracer, ImprovedGaSwitches)
      : lattice_(lattice),
        tr_(tracer),
        numbers_(tracer),
        population_(numbers_, tracer),
        ways_(lattice, settings, counters_, tracer),
        first_paths_(lattice, settings, ways_),
        breeding_(lattice, settings, ways_, population_, numbers_, tracer),
        visits_(lattice.node_count()),
        members_(static_cast<std::uint32_t>(settings.get(parameters::kPopulation))),
        generations_(static_cast<std::int64_t>(settings.get(parameters::kGenerations))),
        again_(static_cast<std::int64_t>(settings.get(parameters::kGenerationsAgain))),
        seed_(static_cast<std::uint64_t>(settings.get(parameters::kBreedingSeed))) {}

  void begin(NodeId start, NodeId goal) override {
    tr_.line(1);
    counters_ = {};
    visits_.begin();
    forget();
    numbers_.set_number(Scalar::goal, goal);
    numbers_.set_number(Scalar::start, start);
    breed_first();
    begin_plan();
  }
  bool advance(std::int64_t iterations) override {
    for (; iterations > 0 && search_needed(); --iterations) breed();
    return !search_needed();
  }
  // Lines 13-16.
  void update(const MapChange<L>&, NodeId start) override {
    tr_.line(13);
    numbers_.set_number(Scalar::start, start);
    if (population_.count() == 0)
      breed_first();
    else if (can_breed())
      repair();
    begin_plan();
  }

  [[nodiscard]] PlanStatus status() const override {
    if (lattice_.blocked(start())) return PlanStatus::start_blocked;
    if (lattice_.blocked(goal())) return PlanStatus::goal_blocked;
    if (start() == goal()) return PlanStatus::found;
    if (search_needed()) return PlanStatus::searching;
    return has_free_path() ? PlanStatus::found : PlanStatus::none_found;
  }
  [[nodiscard]] Cost cost() const override {
    if (status() != PlanStatus::found) return Cost::infinity();
    return start() == goal() ? Cost::zero() : population_.unfitness(leader()).cost;
  }
  [[nodiscard]] Cost best_so_far() const override {
    return has_free_path() ? population_.unfitness(leader()).cost : Cost::infinity();
  }
  bool settle() override {
    settled_ = has_free_path();
    return settled_;
  }
  Path path() override {
    if (status() != PlanStatus::found) return {};
    std::vector<NodeId> nodes(1, start());
    if (start() != goal())
      for (const PathPlace& place : population_.path(leader()))
        if (place.cell != start()) nodes.push_back(place.cell);
    return {lattice_.box(), std::move(nodes)};
  }
  [[nodiscard]] Counters counters() const override { return counters_; }
  [[nodiscard]] std::size_t memory_bytes() const override { return population_.memory_bytes(); }

  void restore(const SearchState& state, const Counters& counters) override {
    counters_ = counters;
    settled_ = false;
    numbers_.restore(state);
    population_.restore(state);
    visits_.restore(state, counters.expansions);
  }

 private:
  [[nodiscard]] NodeId start() const { return numbers_.number(Scalar::start); }
  [[nodiscard]] NodeId goal() const { return numbers_.number(Scalar::goal); }
  [[nodiscard]] std::uint32_t leader() const { return numbers_.number(Scalar::leader); }
  [[nodiscard]] bool has_free_path() const { return numbers_.get(Scalar::best) != 0; }
  [[nodiscard]] bool can_breed() const {
    return !lattice_.blocked(start()) && !lattice_.blocked(goal()) && start() != goal();
  }
  [[nodiscard]] std::int64_t children() const {
    return counters_.expansions - numbers_.count(Scalar::plan_sample);
  }

  // Line 2.
  [[nodiscard]] bool search_needed() const {
    if (!can_breed() || settled_) return false;
    const bool replanned = numbers_.count(Scalar::plan_sample) != 0 && has_free_path();
    return children() < members_ * (replanned ? again_ : generations_);
  }

  void forget() {
    if (population_.count() > 0) {
      tr_.note(EventKind::epoch, start());
      visits_.forget();
      population_.clear();
    }
    for (const Scalar which :
         {Scalar::leader, Scalar::leader_cost, Scalar::mean_cost, Scalar::best, Scalar::generation})
      numbers_.set(which, 0);
    breeding_.take_nobody();
  }

  // Line 1.
  void breed_first() {
    if (!can_breed()) return;
    population_.make_room(members_);
    for (std::uint32_t i = 0; i < members_; ++i) take(i, first_path(i));
    take_leader();
  }
  void take(std::uint32_t i, const BredPath& path) {
    population_.write(i, path);
    population_.set_cost(i, ways_.unfitness_of(path).cost);
  }
  BredPath first_path(std::uint32_t i) { return first_paths_.make(start(), goal(), counters_.expansions, i); }

  // Lines 2-12: one child.
  void breed() {
    tr_.line(2);
    ++counters_.expansions;
    tr_.note(EventKind::pop, start());
    Random random(hash_combine(seed_, static_cast<std::uint64_t>(counters_.expansions)));
    breeding_.take_nobody();
    const std::uint32_t mother = breeding_.select(random, Scalar::mother),
                        father = breeding_.select(random, Scalar::father);
    BredPath child = breeding_.cross(random, population_.path(mother), population_.path(father));
    breeding_.mutate(random, child);
    evaluate(child);
    replace();
    if (children() % members_ == 0) end_generation();
  }

  // Line 10.
  void evaluate(const BredPath& child) {
    tr_.line(10);
    population_.set_cost(population_.child(), ways_.unfitness_of(child).cost);
    const NodeId changed = numbers_.number(Scalar::changed_to);
    visits_.record(tr_, changed != kNoNode ? changed : numbers_.number(Scalar::crossed_at));
  }
  // Line 11.
  void replace() {
    tr_.line(11);
    const std::uint32_t child = population_.child(), leaves = population_.least_fit();
    if (population_.has_twin())
      reject(SampleFault::twin);
    else if (!(population_.unfitness(child) < population_.unfitness(leaves)))
      reject(SampleFault::unfit);
    else
      population_.take_in_for(leaves);
    take_leader();
  }
  void reject(SampleFault why) { tr_.note(EventKind::rejected, start(), static_cast<std::uint64_t>(why)); }
  void take_leader() {
    const std::uint32_t fittest = population_.fittest();
    const Unfitness& unfitness = population_.unfitness(fittest);
    numbers_.set_number(Scalar::leader, fittest);
    numbers_.set_cost(Scalar::leader_cost, unfitness.cost);
    numbers_.set_cost(Scalar::best, unfitness.hits ? Cost::zero() : unfitness.cost);
  }
  // Line 12.
  void end_generation() {
    tr_.line(12);
    numbers_.set_cost(Scalar::mean_cost, population_.mean_cost());
    numbers_.set_count(Scalar::generation, numbers_.count(Scalar::generation) + 1);
  }
  void begin_plan() {
    settled_ = false;
    numbers_.set_count(Scalar::plan_sample, counters_.expansions);
  }

  // Lines 14-16.
  void repair() {
    for (std::uint32_t i = 0; i < population_.count(); ++i) {
      if (!population_.is_member(i)) continue;
      tr_.line(14);
      BredPath path = population_.path(i);
      ways_.hold_against_map(path);
      tr_.line(15);
      take(i, joined_to_start(path));
      if (!population_.unfitness(i).hits) continue;
      tr_.line(16);
      if (const BredPath fresh = first_path(i); ways_.unfitness_of(fresh) < population_.unfitness(i))
        take(i, fresh);
    }
    breeding_.take_nobody();
    take_leader();
  }
  /// From the start straight to the cell of the path over which it becomes fittest, and on as it was. A cell that is seen
  /// from the start comes before any that is not: where an obstacle has cut off all paths, the straight way to the goal hits
  /// it but once, and would be the fittest of each of them, so that no cell of theirs were left.
  BredPath joined_to_start(const BredPath& path) {
    if (path.front().cell == start()) return path;
    BredPath fittest;
    std::pair<bool, Unfitness> least{true, Unfitness{}};
    for (auto from = path.begin() + 1; from != path.end(); ++from) {
      BredPath joined(1, {start(), ways_.hit_between(start(), from->cell)});
      const bool unseen = joined.front().hit != kNoNode;
      joined.insert(joined.end(), from, path.end());
      delete_loops(joined);
      const std::pair<bool, Unfitness> rank{unseen, ways_.unfitness_of(joined)};
      if (!fittest.empty() && !(rank < least)) continue;
      least = rank;
      fittest = std::move(joined);
    }
    return fittest;
  }

  const L& lattice_;
  T& tr_;
  Counters counters_;
  RunNumbers<T> numbers_;
  Population<T> population_;
  BredWays<L, T> ways_;
  FirstPaths<L, T> first_paths_;
  Breeding<L, T> breeding_;
  Visits<T> visits_;
  const std::uint32_t members_;
  const std::int64_t generations_, again_;
  const std::uint64_t seed_;
  bool settled_ = false;
};

}  // namespace replan
