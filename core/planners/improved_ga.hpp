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

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/random.hpp"
#include "core/lattice/body_way.hpp"
#include "core/plan/registry.hpp"
#include "core/plan/visits.hpp"
#include "core/planners/ga_parameters.hpp"
#include "core/planners/population.hpp"

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
        visits_(lattice.node_count()),
        members_(static_cast<std::uint32_t>(settings.get(parameters::kPopulation))),
        generations_(static_cast<std::int64_t>(settings.get(parameters::kGenerations))),
        again_(static_cast<std::int64_t>(settings.get(parameters::kGenerationsAgain))),
        most_cells_(static_cast<std::uint32_t>(settings.get(parameters::kMostCells))),
        by_sight_(settings.get(parameters::kFirstPaths) == 0),
        tournament_(static_cast<int>(settings.get(parameters::kTournament))),
        by_position_(settings.get(parameters::kCrossover) != 0),
        crossover_rate_(settings.get(parameters::kCrossoverRate)),
        any_neighbour_(settings.get(parameters::kMutation) != 0),
        mutation_rate_(settings.get(parameters::kMutationRate)),
        reach_(static_cast<int>(settings.get(parameters::kMutationReach))),
        penalty_{std::llround(settings.get(parameters::kHitPenalty) * static_cast<double>(Cost::kScale))},
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
    return counters_.expansions - static_cast<std::int64_t>(numbers_.get(Scalar::plan_sample));
  }

  // Line 2.
  [[nodiscard]] bool search_needed() const {
    if (!can_breed() || settled_) return false;
    const bool replanned = numbers_.get(Scalar::plan_sample) != 0 && has_free_path();
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
    take_nobody();
  }
  /// No child is in hand.
  void take_nobody() {
    for (const Scalar which : {Scalar::mother, Scalar::father, Scalar::taken, Scalar::joined,
                               Scalar::crossed_at, Scalar::changed_from, Scalar::changed_to})
      numbers_.set(which, 0);
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
    population_.set_cost(i, unfitness_of(path).cost);
  }
  BredPath first_path(std::uint32_t i) {
    const auto plan = static_cast<std::uint64_t>(counters_.expansions);
    Random random(hash_combine(hash_combine(hash_combine(seed_, kFirstOnes), plan), i));
    BredPath path = by_sight_ ? path_by_sight(random) : random_path(random);
    delete_loops(path);
    hold_against_map(path);
    return path;
  }
  /// Some free cells of the world in any order, between the two ends.
  BredPath random_path(Random& random) {
    BredPath path(1, {start()});
    for (std::uint32_t left = random.below(most_cells_ + 1); left > 0; --left)
      path.push_back({random_cell(random)});
    path.push_back({goal()});
    return path;
  }
  /// From cell to cell that is seen from there, until that is the goal or the path has its cells.
  BredPath path_by_sight(Random& random) {
    BredPath path(1, {start()});
    while (path.size() <= most_cells_ && hit_between(path.back().cell, goal()) != kNoNode) {
      const NodeId one = seen_on_the_way(path.back().cell, random_cell(random)),
                   other = seen_on_the_way(path.back().cell, random_cell(random));
      const bool nearer = lattice_.squared_distance(other, goal()) < lattice_.squared_distance(one, goal());
      path.push_back({nearer ? other : one});
    }
    path.push_back({goal()});
    return path;
  }
  /// A cell that is seen from another one: `to`, or half as far, and so on.
  NodeId seen_on_the_way(NodeId from, NodeId to) {
    while (to != from && hit_between(from, to) != kNoNode) {
      auto half = lattice_.coordinates(from);
      const auto whole = lattice_.coordinates(to);
      for (std::size_t axis = 0; axis < half.size(); ++axis) half[axis] += (whole[axis] - half[axis]) / 2;
      to = lattice_.node(half);
    }
    return to;
  }
  /// A free cell, or the start in a world that has next to none.
  NodeId random_cell(Random& random) const {
    constexpr int kTries = 100;
    for (int tries = 0; tries < kTries; ++tries) {
      const NodeId cell = random.below(static_cast<std::uint32_t>(lattice_.node_count()));
      if (!lattice_.blocked(cell)) return cell;
    }
    return start();
  }

  // Lines 2-12: one child.
  void breed() {
    tr_.line(2);
    ++counters_.expansions;
    tr_.note(EventKind::pop, start());
    Random random(hash_combine(seed_, static_cast<std::uint64_t>(counters_.expansions)));
    take_nobody();
    const std::uint32_t mother = select(random, Scalar::mother), father = select(random, Scalar::father);
    BredPath child = crossed(random, population_.path(mother), population_.path(father));
    mutate(random, child);
    evaluate(child);
    replace();
    if (children() % members_ == 0) end_generation();
  }

  // Line 3: the fittest of some that are drawn.
  std::uint32_t select(Random& random, Scalar parent) {
    tr_.line(3);
    std::uint32_t fittest = kNoNode;
    for (int i = 0; i < tournament_; ++i) {
      const std::uint32_t drawn = random_member(random);
      tr_.note(EventKind::candidate, drawn,
               static_cast<std::uint64_t>(population_.unfitness(drawn).cost.raw));
      if (fittest == kNoNode || population_.unfitness(drawn) < population_.unfitness(fittest))
        fittest = drawn;
    }
    numbers_.set_number(parent, fittest);
    return fittest;
  }
  std::uint32_t random_member(Random& random) const {
    const std::uint32_t drawn = random.below(members_);
    return drawn < population_.child() ? drawn : drawn + 1;
  }

  /// The child is its mother up to a place, and its father from one on.
  struct Cut {
    std::size_t last;  ///< of its mother
    std::size_t next;  ///< of its father
  };
  // Lines 4-6.
  BredPath crossed(Random& random, const BredPath& mother, const BredPath& father) {
    tr_.line(4);
    const Cut cut = random.chance(crossover_rate_) ? cut_between(random, mother, father)
                                                   : Cut{mother.size() - 1, father.size()};
    numbers_.set(Scalar::taken, cut.last + 1);
    numbers_.set(Scalar::joined, cut.next);
    numbers_.set_number(Scalar::crossed_at, mother[cut.last].cell);
    tr_.line(5);
    const auto beginning = static_cast<std::ptrdiff_t>(cut.last), end = static_cast<std::ptrdiff_t>(cut.next);
    BredPath child(mother.begin(), mother.begin() + beginning + 1);
    child.insert(child.end(), father.begin() + end, father.end());
    if (father.size() > cut.next)
      child[cut.last].hit = father[cut.next - 1].cell == child[cut.last].cell
                                ? father[cut.next - 1].hit
                                : hit_between(child[cut.last].cell, father[cut.next].cell);
    population_.write(population_.child(), child);
    tr_.line(6);
    delete_loops(child);
    population_.write(population_.child(), child);
    return child;
  }
  /// At an inner cell that both have, or as far along both of them; nowhere if the child would have too many cells.
  Cut cut_between(Random& random, const BredPath& mother, const BredPath& father) const {
    const auto below = [&random](std::size_t bound) {
      return random.below(static_cast<std::uint32_t>(bound));
    };
    std::vector<Cut> shared;
    for (std::size_t i = 1; i + 1 < mother.size() && !by_position_; ++i)
      for (std::size_t k = 1; k + 1 < father.size(); ++k)
        if (mother[i].cell == father[k].cell) shared.push_back({i, k + 1});
    Cut cut{};
    if (!shared.empty()) {
      cut = shared[below(shared.size())];
    } else {
      cut.last = below(mother.size() - 1);
      cut.next = 1 + cut.last * (father.size() - 1) / (mother.size() - 1);
    }
    const std::size_t cells = cut.last + 1 + father.size() - cut.next;
    return cells > most_cells_ + 2 ? Cut{mother.size() - 1, father.size()} : cut;
  }

  // Lines 7-9.
  void mutate(Random& random, BredPath& child) {
    if (child.size() < 3 || !random.chance(mutation_rate_)) return;
    tr_.line(7);
    const std::size_t place = 1 + random.below(static_cast<std::uint32_t>(child.size()) - 2);
    const std::vector<NodeId> neighbours = free_neighbours(child[place].cell);
    if (neighbours.empty()) return;
    numbers_.set_number(Scalar::changed_from, child[place].cell);
    child =
        any_neighbour_
            ? with_cell(child, place, neighbours[random.below(static_cast<std::uint32_t>(neighbours.size()))])
            : with_fittest_of(neighbours, child, place);
    tr_.line(9);
    numbers_.set_number(Scalar::changed_to, child[place].cell);
    delete_loops(child);
    population_.write(population_.child(), child);
  }
  [[nodiscard]] std::vector<NodeId> free_neighbours(NodeId cell) const {
    std::vector<NodeId> free;
    lattice_.box().each_cell_around(lattice_.position(cell), reach_, [&](NodeId node) {
      if (node != cell && !lattice_.blocked(node)) free.push_back(node);
    });
    return free;
  }
  // Line 8.
  BredPath with_fittest_of(const std::vector<NodeId>& neighbours, const BredPath& child, std::size_t place) {
    tr_.line(8);
    BredPath fittest;
    Unfitness least;
    for (const NodeId cell : neighbours) {
      BredPath tried = with_cell(child, place, cell);
      const Unfitness unfitness = unfitness_of(tried);
      tr_.note(EventKind::tried, cell, tried_bits(unfitness.cost.raw, unfitness.hits));
      if (!(unfitness < least)) continue;
      least = unfitness;
      fittest = std::move(tried);
    }
    return fittest;
  }
  BredPath with_cell(BredPath path, std::size_t place, NodeId cell) {
    path[place].cell = cell;
    for (const std::size_t from : {place - 1, place})
      path[from].hit = hit_between(path[from].cell, path[from + 1].cell);
    return path;
  }

  // Line 10.
  void evaluate(const BredPath& child) {
    tr_.line(10);
    population_.set_cost(population_.child(), unfitness_of(child).cost);
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
    const auto raw = static_cast<std::uint64_t>(unfitness.cost.raw);
    numbers_.set_number(Scalar::leader, fittest);
    numbers_.set(Scalar::leader_cost, raw);
    numbers_.set(Scalar::best, unfitness.hits ? 0 : raw);
  }
  // Line 12.
  void end_generation() {
    tr_.line(12);
    numbers_.set(Scalar::mean_cost, static_cast<std::uint64_t>(population_.mean_cost().raw));
    numbers_.set(Scalar::generation, numbers_.get(Scalar::generation) + 1);
  }
  void begin_plan() {
    settled_ = false;
    numbers_.set(Scalar::plan_sample, static_cast<std::uint64_t>(counters_.expansions));
  }

  // Lines 14-16.
  void repair() {
    for (std::uint32_t i = 0; i < population_.count(); ++i) {
      if (!population_.is_member(i)) continue;
      tr_.line(14);
      BredPath path = population_.path(i);
      hold_against_map(path);
      tr_.line(15);
      take(i, joined_to_start(path));
      if (!population_.unfitness(i).hits) continue;
      tr_.line(16);
      if (const BredPath fresh = first_path(i); unfitness_of(fresh) < population_.unfitness(i))
        take(i, fresh);
    }
    take_nobody();
    take_leader();
  }
  /// From the start straight to the cell of the path over which it becomes fittest, and on as it was.
  BredPath joined_to_start(const BredPath& path) {
    if (path.front().cell == start()) return path;
    BredPath fittest;
    Unfitness least;
    for (auto from = path.begin() + 1; from != path.end(); ++from) {
      BredPath joined(1, {start(), hit_between(start(), from->cell)});
      joined.insert(joined.end(), from, path.end());
      delete_loops(joined);
      const Unfitness unfitness = unfitness_of(joined);
      if (!(unfitness < least)) continue;
      least = unfitness;
      fittest = std::move(joined);
    }
    return fittest;
  }

  /// Where a path comes to a cell again, what lies between goes.
  static void delete_loops(BredPath& path) {
    for (std::size_t i = 0; i < path.size(); ++i)
      for (std::size_t again = path.size() - 1; again > i; --again)
        if (path[again].cell == path[i].cell) {
          path[i].hit = path[again].hit;
          path.erase(path.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     path.begin() + static_cast<std::ptrdiff_t>(again) + 1);
          break;
        }
  }
  void hold_against_map(BredPath& path) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      path[i].hit = hit_between(path[i].cell, path[i + 1].cell);
  }
  /// The obstacle in the straight way between two cells; kNoNode if it is free.
  NodeId hit_between(NodeId from, NodeId to) {
    ++counters_.sight_checks;
    const auto hit =
        hit_on_way(lattice_, centre_of(lattice_.position(from)), centre_of(lattice_.position(to)));
    tr_.note(EventKind::sight, from, std::uint64_t{to} | std::uint64_t{!hit} << 32);
    return hit ? lattice_.node(*hit) : kNoNode;
  }
  /// Length, and the penalty for each way that hits something.
  [[nodiscard]] Unfitness unfitness_of(const BredPath& path) const {
    Unfitness unfitness{false, Cost::zero()};
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      unfitness.cost =
          unfitness.cost + euclidean_ceil(lattice_.squared_distance(path[i].cell, path[i + 1].cell));
      if (path[i].hit == kNoNode) continue;
      unfitness.hits = true;
      unfitness.cost = unfitness.cost + penalty_;
    }
    return unfitness;
  }

  static constexpr std::uint64_t kFirstOnes = 0xF1257;  // so that the first paths' numbers are of their own

  const L& lattice_;
  T& tr_;
  RunNumbers<T> numbers_;
  Population<T> population_;
  Visits<T> visits_;
  const std::uint32_t members_;
  const std::int64_t generations_, again_;
  const std::uint32_t most_cells_;
  const bool by_sight_;
  const int tournament_;
  const bool by_position_;
  const double crossover_rate_;
  const bool any_neighbour_;
  const double mutation_rate_;
  const int reach_;
  const Cost penalty_;
  const std::uint64_t seed_;
  Counters counters_;
  bool settled_ = false;
};

}  // namespace replan
