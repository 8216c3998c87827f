// How a child comes of a population of paths: its parents are selected and crossed, and it is changed.
//
// Line numbers are those of assets/planners/improved-ga.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/random.hpp"
#include "core/planners/bred_ways.hpp"
#include "core/planners/population.hpp"

namespace replan {

/// The operators. What they come to is written to the population's child and to the numbers of the run.
template <Lattice L, Tracer T>
class Breeding {
 public:
  Breeding(const L& lattice, const Settings& settings, BredWays<L, T>& ways, Population<T>& population,
           RunNumbers<T>& numbers, T& tracer)
      : lattice_(lattice),
        tr_(tracer),
        ways_(ways),
        population_(population),
        numbers_(numbers),
        tournament_(static_cast<int>(settings.get(parameters::kTournament))),
        by_position_(settings.get(parameters::kCrossover) != 0),
        crossover_rate_(settings.get(parameters::kCrossoverRate)),
        most_cells_(static_cast<std::uint32_t>(settings.get(parameters::kMostCells))),
        any_neighbour_(settings.get(parameters::kMutation) != 0),
        mutation_rate_(settings.get(parameters::kMutationRate)),
        reach_(static_cast<int>(settings.get(parameters::kMutationReach))) {}

  /// No child is in hand.
  void take_nobody() {
    for (const Scalar which : {Scalar::mother, Scalar::father, Scalar::taken, Scalar::joined,
                               Scalar::crossed_at, Scalar::changed_from, Scalar::changed_to})
      numbers_.set(which, 0);
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

  // Lines 4-6.
  BredPath cross(Random& random, const BredPath& mother, const BredPath& father) {
    tr_.line(4);
    const Cut cut = random.chance(crossover_rate_) ? cut_between(random, mother, father)
                                                   : Cut{mother.size() - 1, father.size()};
    numbers_.set(Scalar::taken, cut.last + 1);
    numbers_.set(Scalar::joined, cut.next);
    numbers_.set_number(Scalar::crossed_at, mother[cut.last].cell);
    tr_.line(5);
    BredPath child = joined_at(cut, mother, father);
    population_.write(population_.child(), child);
    tr_.line(6);
    delete_loops(child);
    population_.write(population_.child(), child);
    return child;
  }

  // Lines 7-9.
  void mutate(Random& random, BredPath& child) {
    if (child.size() < 3 || !random.chance(mutation_rate_)) return;
    tr_.line(7);
    const std::size_t place = 1 + below(random, child.size() - 2);
    const std::vector<NodeId> neighbours = free_neighbours(child[place].cell);
    if (neighbours.empty()) return;
    numbers_.set_number(Scalar::changed_from, child[place].cell);
    child = any_neighbour_ ? ways_.with_cell(child, place, neighbours[below(random, neighbours.size())])
                           : with_fittest_of(neighbours, child, place);
    tr_.line(9);
    numbers_.set_number(Scalar::changed_to, child[place].cell);
    delete_loops(child);
    population_.write(population_.child(), child);
  }

 private:
  static std::uint32_t below(Random& random, std::size_t bound) {
    return random.below(static_cast<std::uint32_t>(bound));
  }
  std::uint32_t random_member(Random& random) const {
    const std::uint32_t drawn = below(random, population_.count() - 1);
    return drawn < population_.child() ? drawn : drawn + 1;
  }

  /// The child is its mother up to a place, and its father from one on.
  struct Cut {
    std::size_t last;  ///< of its mother
    std::size_t next;  ///< of its father
  };
  /// At an inner cell that both have, or as far along both of them; nowhere if the child would have too many cells.
  Cut cut_between(Random& random, const BredPath& mother, const BredPath& father) const {
    std::vector<Cut> shared;
    for (std::size_t i = 1; i + 1 < mother.size() && !by_position_; ++i)
      for (std::size_t k = 1; k + 1 < father.size(); ++k)
        if (mother[i].cell == father[k].cell) shared.push_back({i, k + 1});
    Cut cut{};
    if (!shared.empty()) {
      cut = shared[below(random, shared.size())];
    } else {
      cut.last = below(random, mother.size() - 1);
      cut.next = 1 + cut.last * (father.size() - 1) / (mother.size() - 1);
    }
    const std::size_t cells = cut.last + 1 + father.size() - cut.next;
    return cells > most_cells_ + 2 ? Cut{mother.size() - 1, father.size()} : cut;
  }
  // Line 5. Of its ways only that from its mother's last cell to its father's first one can be a new one.
  BredPath joined_at(const Cut& cut, const BredPath& mother, const BredPath& father) {
    const auto last = static_cast<std::ptrdiff_t>(cut.last), next = static_cast<std::ptrdiff_t>(cut.next);
    BredPath child(mother.begin(), mother.begin() + last + 1);
    child.insert(child.end(), father.begin() + next, father.end());
    if (father.size() > cut.next)
      child[cut.last].hit = father[cut.next - 1].cell == child[cut.last].cell
                                ? father[cut.next - 1].hit
                                : ways_.hit_between(child[cut.last].cell, father[cut.next].cell);
    return child;
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
      BredPath tried = ways_.with_cell(child, place, cell);
      const Unfitness unfitness = ways_.unfitness_of(tried);
      tr_.note(EventKind::tried, cell, tried_bits(unfitness.cost.raw, unfitness.hits));
      if (!(unfitness < least)) continue;
      least = unfitness;
      fittest = std::move(tried);
    }
    return fittest;
  }

  const L& lattice_;
  T& tr_;
  BredWays<L, T>& ways_;
  Population<T>& population_;
  RunNumbers<T>& numbers_;
  const int tournament_;
  const bool by_position_;
  const double crossover_rate_;
  const std::uint32_t most_cells_;
  const bool any_neighbour_;
  const double mutation_rate_;
  const int reach_;
};

}  // namespace replan
