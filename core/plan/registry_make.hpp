// make_planner() for one lattice and one tracer. Included by one source file for each pair, so that the
// planners compile in parallel and nowhere else.
#pragma once

#define REPLAN_PLANNER_HEADERS
#include "core/planners/planners.def"
#undef REPLAN_PLANNER_HEADERS

namespace replan {

template <class L, class T>
std::unique_ptr<Planner<L>> make_planner(const PlannerInfo& info, const L& lattice, const Settings& settings,
                                         T& tracer) {
#define REPLAN_PLANNER(ID, CLASS, SWITCHES)         \
  if constexpr (requires { typename CLASS<L, T>; }) \
    if (info.id == ID) return std::make_unique<CLASS<L, T>>(lattice, settings, tracer, SWITCHES);
#include "core/planners/planners.def"
#undef REPLAN_PLANNER
  return nullptr;
}

}  // namespace replan
