// A* and Dijkstra's algorithm: best-first search (best_first.hpp) by f = g + h.
//
//  A*        Hart, Nilsson & Raphael, "A formal basis for the heuristic determination of minimum cost paths",
//            IEEE Trans. Systems Science and Cybernetics 4(2), 1968, doi 10.1109/TSSC.1968.300136
//  Dijkstra  "A note on two problems in connexion with graphs", Numerische Mathematik 1, 1959,
//            doi 10.1007/BF01386390: the same with no estimate
#pragma once

#include "core/planners/best_first.hpp"

namespace replan {

struct AStarSwitches {
  bool estimate = true;  ///< off: Dijkstra
};

inline PlannerInfo describe(AStarSwitches switches) {
  PlannerInfo info;
  info.key = key_rule<GPlusH>();
  info.length_bound = overestimate;
  if (switches.estimate) {
    info.name = "A*";
    info.summary =
        "Best-first search from the start, drawn to the goal by an estimate; plans afresh each time.";
    info.source = "Hart, Nilsson & Raphael 1968, doi 10.1109/TSSC.1968.300136";
    info.parameters = {parameters::kAnyHeuristic};
  } else {
    info.name = "Dijkstra";
    info.summary = "Searches in all directions by cost; plans afresh each time.";
    info.source = "Dijkstra 1959, doi 10.1007/BF01386390";
  }
  return info;
}

template <Lattice L, Tracer T>
using AStar = BestFirst<L, T, GPlusH>;

}  // namespace replan
