// Who belongs to the D* family (dstar.hpp), and what there is to say of each.
#pragma once

#include "core/plan/common_parameters.hpp"
#include "core/plan/registry.hpp"

namespace replan {

struct DStarSwitches {
  bool focused = false;  ///< the open list is ordered by what the robot is away, too
  bool threat = false;   ///< entering a cell near an obstacle costs more
};

/// h, k, tag and back-pointer; OPEN by k, or by f_B, then f, then k.
inline SearchValues dstar_values(bool focused) {
  using namespace fields;
  SearchValues values{.fields = {kH, kLowest, focused ? kQueueByBias : kQueueByLowest, kTag, kBack, kVisit},
                      .order = {"", {EventKind::g, EventKind::g}, [](Cost, Cost, Cost) { return Cost{}; }},
                      .cost = {EventKind::g, Scalar::start},
                      .laws = "back-pointers",
                      .least_cost = true,
                      .waves = true};
  if (!focused) return values;
  values.fields.push_back(kFocused);
  values.order = {"f", {kFocused.kind, kLowest.kind}, [](Cost, Cost f, Cost) { return f; }, "k"};
  return values;
}

inline PlannerInfo describe(DStarSwitches switches) {
  PlannerInfo info;
  info.incremental = info.from_goal = true;
  info.values = dstar_values(switches.focused);
  info.length_bound = [](const Settings&) { return 1.0; };
  if (switches.threat) {
    using namespace parameters;
    info.name = "Threat D*";
    info.summary =
        "Focused D* for whom it costs more to come near an obstacle: its paths keep off, and are repaired.";
    info.source = "Zhu, Sun & Zhu 2021, doi 10.14107/j.cnki.kzgc.20190179";
    info.parameters = {kHeuristic, kThreat, kThreatInner, kThreatOuter, kImpassable, kBorder};
    info.values.fields.push_back(fields::kDist);
    info.clearance = threat_rules_of;
    info.length_bound = threat_bound;
  } else if (switches.focused) {
    info.name = "Focused D*";
    info.summary = "D* that looks towards the robot alone: the same plans, and less work for each repair.";
    info.source = "Stentz, The focussed D* algorithm for real-time replanning, IJCAI 1995";
    info.parameters = {parameters::kHeuristic};
  } else {
    info.name = "D*";
    info.summary =
        "The first planner that repairs: changes run through the map as waves of raised and lowered costs.";
    info.source = "Stentz, Optimal and efficient path planning for partially-known environments, ICRA 1994";
  }
  return info;
}

}  // namespace replan
