// A* that pays for coming near obstacles: best-first search (best_first.hpp) by f = g + h, in which entering X costs the
// threat j(X) besides the move.
//
//  Zhu X., Sun B. & Zhu D., "Three-dimensional dynamic path planning of AUV based on improved D* algorithm", Control
//  Engineering of China 28(4), 2021, doi 10.14107/j.cnki.kzgc.20190179: the threat. The search is A*'s.
//
// Line numbers are those of assets/planners/threat-astar.md.
//
// What is settled here: the threat only adds to the cost of moves, so every estimate that is consistent without it stays
// so, and no plan costs less. A plan costs what its moves do and the threats of all its cells but the start's. The field
// is kept from plan to plan and follows the map by its exact local update (core/field/clearance.hpp). With an estimate
// of zero it is Dijkstra's algorithm.
#pragma once

#include <bit>

#include "core/planners/best_first.hpp"
#include "core/planners/ground.hpp"

namespace replan {

struct ThreatAStarSwitches {};

inline PlannerInfo describe(ThreatAStarSwitches) {
  using namespace parameters;
  PlannerInfo info;
  info.name = "Threat A*";
  info.summary =
      "A* that pays for coming near obstacles, by the AUV paper's threat: paths that keep their distance.";
  info.source = "Zhu, Sun & Zhu 2021, doi 10.14107/j.cnki.kzgc.20190179; Hart, Nilsson & Raphael 1968";
  info.key = key_rule<GPlusH>();
  info.values.fields.push_back(fields::kDist);
  info.values.least_cost = true;
  info.clearance = threat_rules_of;
  info.parameters = {kHeuristic, kThreat, kThreatInner, kThreatOuter, kImpassable, kBorder};
  info.length_bound = threat_bound;
  return info;
}

template <Lattice L, Tracer T>
class ThreatAStar final : public BestFirst<L, T, GPlusH, ThreatAStar<L, T>> {
  using Base = BestFirst<L, T, GPlusH, ThreatAStar<L, T>>;
  friend Base;

 public:
  ThreatAStar(const L& lattice, const Settings& settings, T& tracer, ThreatAStarSwitches switches)
      : Base(lattice, settings, tracer, switches),
        ground_(lattice, settings, describe(switches).clearance, false) {}

  // Line 102 of the mission.
  void begin(NodeId start, NodeId goal) override {
    tr_.line(102);
    ground_.make(
        [this](NodeId n, Cost before, Cost after) { tr_.change(EventKind::dist, n, before, after); });
    Base::begin(start, goal);
  }

  // Lines 116 and 117 of the mission.
  void update(const MapChange<L>& change, NodeId start) override {
    tr_.line(116);
    for (const ClearanceChange& changed : ground_.update(change.cells))
      tr_.change(EventKind::dist, changed.node, changed.before, ground_.dist(changed.node));
    Base::update(change, start);
  }

  [[nodiscard]] std::size_t memory_bytes() const override {
    return Base::memory_bytes() + ground_.memory_bytes();
  }

  void restore(const SearchState& state, const Counters& counters) override {
    ground_.make();
    Base::restore(state, counters);
  }

 private:
  using Base::lattice_, Base::nodes_, Base::tr_;
  using typename Base::Expanded;

  // Lines 7-8, for the neighbour of u in direction d.
  void relax(const Expanded& u, int d) {
    const NodeId s = lattice_.neighbour(u.node, d);
    const Cost sum = u.g + L::step_cost(d) + ground_.dist(s);
    if (sum < nodes_[s].g) this->reach(s, static_cast<std::uint32_t>(L::reverse(d)), sum, L::step(u.at, d));
  }

  Ground<L> ground_;
};

}  // namespace replan
