// Straight ways that a planner holds against the map while it searches.
#pragma once

#include <cstdint>
#include <optional>

#include "core/lattice/body_way.hpp"
#include "core/plan/planner.hpp"
#include "core/trace/tracer.hpp"

namespace replan {

/// The obstacle in the straight way between two points, if there is one (hit_on_way()): a sight check, which is counted and
/// told to the tracer.
template <int D, Tracer T>
std::optional<Cell> hit_on_checked_way(const BoxLattice<D>& known, const Point& from, const Point& to, T& tr,
                                       Counters& counters) {
  ++counters.sight_checks;
  const auto hit = hit_on_way(known, from, to);
  tr.note(EventKind::sight, known.node(cell_of(from)),
          std::uint64_t{known.node(cell_of(to))} | std::uint64_t{!hit} << 32);
  return hit;
}

}  // namespace replan
