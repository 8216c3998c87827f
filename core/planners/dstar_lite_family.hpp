// Who belongs to the D* Lite family (dstar_lite.hpp), and what there is to say of each.
#pragma once

#include <limits>

#include "core/plan/common_parameters.hpp"
#include "core/plan/registry.hpp"

namespace replan {

struct DStarLiteSwitches {
  bool sight = false;
  bool clearance = false;
};

inline PlannerInfo describe(DStarLiteSwitches switches) {
  using namespace parameters;
  PlannerInfo info;
  info.incremental = info.from_goal = true;
  info.values = lookahead_values();
  info.values.fields.push_back(fields::kRp);
  info.values.fields.back().shown = switches.sight;  // without sight it is the local one and nothing reads it
  if (switches.clearance) info.values.fields.push_back(fields::kDist);
  info.any_angle = info.sight = switches.sight;
  if (switches.clearance) info.clearance = clearance_rules_of;
  info.parameters = {kHeuristic};
  info.source = "Koenig & Likhachev, D* Lite, AAAI 2002";
  if (switches.sight || switches.clearance)
    info.source = "Huang & Zhou, Control and Decision 2018, doi 10.13195/j.kzyjc.2018.0583";
  if (switches.sight) info.parameters.insert(info.parameters.end(), {kSight, kSightChecks, kRemoteParents});
  if (switches.clearance) {
    info.parameters.insert(info.parameters.end(), {kRange, kTransform, kBorder});
    info.parameters.insert(info.parameters.end(),
                           {kPenalty, kThreat, kThreatInner, kThreatOuter, kImpassable});
  }
  if (switches.sight && switches.clearance) {
    info.name = "DLD* Lite";
    info.summary =
        "D* Lite with lazy line-of-sight checks and a penalty near obstacles: smooth, safe paths that can be "
        "repaired.";
  } else if (switches.sight) {
    info.name = "Los D* Lite";
    info.summary = "D* Lite with lazy line-of-sight checks: any-angle paths that hug corners.";
  } else if (switches.clearance) {
    info.name = "Dist D* Lite";
    info.summary = "D* Lite with a penalty near obstacles: lattice paths that keep their distance.";
  } else {
    info.name = "D* Lite";
    info.summary = "Searches from the goal and repairs its plan when the map changes.";
  }
  // A path costs no more than the shortest one, of which each cell costs at most 1 + range times its length, or 1 + c
  // times under the threat.
  static constexpr auto kBound = [](const Settings& settings, double by_clearance) {
    const bool trusts = settings.get(kRemoteParents) != 0 && !checks_along_path(settings);
    return trusts ? std::numeric_limits<double>::infinity() : by_clearance;
  };
  info.length_bound =
      switches.clearance
          ? +[](const Settings& settings) { 
              return kBound(settings, settings.get(kPenalty) != 0 ? threat_bound(settings) : 1 + settings.get(kRange));
            }
          : +[](const Settings& settings) { return kBound(settings, 1); };
  return info;
}

/// Nothing is wrong. What a policy that puts mistakes in answers is in broken_dstar_lite.hpp.
struct NoFaults {
  static constexpr bool kAny = false;
  explicit NoFaults(const Settings&) {}
};

}  // namespace replan
