// Parameters that several planners share.
#pragma once

#include <algorithm>
#include <limits>

#include "core/field/clearance.hpp"
#include "core/lattice/lattice.hpp"
#include "core/plan/parameters.hpp"

namespace replan::parameters {

inline const Parameter kMoves{
    .key = "moves",
    .label = "Neighbours",
    .type = ParameterType::choice,
    .choices = {"8", "4"},
    .help = "Which neighbours a cell has: 8 with diagonals, 4 without (26 and 6 in 3D).",
    .choices_in_space = {"26", "6"}};
inline const Parameter kCorners{
    .key = "corners",
    .label = "Corner rule",
    .type = ParameterType::choice,
    .choices = {"none", "one", "any"},
    .help =
        "What may be blocked beside a diagonal move: none of the cells it squeezes past (the rule of the "
        "MovingAI benchmarks), at most one, or any."};
inline const Parameter kHeuristic{
    .key = "heuristic",
    .label = "Heuristic",
    .type = ParameterType::choice,
    .choices = {"octile", "euclidean", "zero"},
    .help =
        "The estimate that draws the search towards its end. Octile is the exact distance on an empty grid "
        "and "
        "expands least; the DLD* Lite paper uses Euclidean; zero searches in all directions."};
inline const Parameter kAnyHeuristic{
    .key = "heuristic",
    .label = "Heuristic",
    .type = ParameterType::choice,
    .choices = {"octile", "euclidean", "chebyshev", "manhattan", "zero"},
    .help =
        "The estimate that draws the search towards the goal. Manhattan overestimates where diagonals are "
        "allowed: fewer expansions, no promise of a shortest path."};
inline const Parameter kStraightHeuristic{
    .key = "heuristic",
    .label = "Heuristic",
    .type = ParameterType::choice,
    .choices = {"euclidean", "octile", "zero"},
    .help =
        "The estimate that draws the search towards the goal. Euclidean is the papers'; octile is the exact "
        "distance on an empty grid, too long where straight ways count; zero searches in all directions."};
inline const Parameter kSight{.key = "sight",
                              .label = "Line of sight",
                              .type = ParameterType::choice,
                              .choices = {"supercover", "bresenham"},
                              .help =
                                  "Which cells must be clear between two cells that see each other: all that "
                                  "the segment touches, or those "
                                  "that a drawn line fills (the paper's rule)."};
inline const Parameter kRemoteParents{
    .key = "remote_parents",
    .label = "Remote parents",
    .type = ParameterType::choice,
    .choices = {"checked", "printed"},
    .help =
        "A remote parent goes stale when the map changes. 'checked' tests it when it is used; 'printed' "
        "trusts it "
        "as the paper's pseudo-code does, and can drive into a wall or in a circle."};
inline const Parameter kSightChecks{
    .key = "sight_checks",
    .label = "Sight checks",
    .type = ParameterType::choice,
    .choices = {"search", "path"},
    .help =
        "When sight is checked. 'search': of each vertex that the search takes, as in the paper. 'path': "
        "only "
        "along the path, once the search is done; the search is then as fast as one without sight, what was "
        "seen is kept until a cell between changes, and Remote parents has no meaning."};
inline const Parameter kRange{
    .key = "range",
    .label = "Clearance range",
    .type = ParameterType::real,
    .initial = 2,
    .low = 1,
    .high = ClearanceRules::kMaxRange,
    .unit = "cells",
    .help = "How far from an obstacle the penalty dist(s) = range - distance + 1 reaches."};
inline const Parameter kTransform{.key = "transform",
                                  .label = "Distance",
                                  .type = ParameterType::choice,
                                  .choices = {"chamfer", "euclidean"},
                                  .help =
                                      "How the distance to the nearest obstacle is measured: the two-pass "
                                      "chamfer transform with weights 1 and "
                                      "sqrt 2 (the paper's), or exactly."};
inline const Parameter kBorder{
    .key = "border",
    .label = "Border is obstacle",
    .type = ParameterType::toggle,
    .help = "Whether coming near the edge of the map costs as much as coming near an obstacle."};

inline const Parameter kPenalty{
    .key = "penalty",
    .label = "Penalty",
    .type = ParameterType::choice,
    .choices = {"linear", "threat"},
    .help =
        "How the penalty falls with the distance d to the nearest obstacle: 'linear', range - d + 1 as the "
        "DLD* Lite "
        "paper has it, or 'threat', the AUV paper's c e^-(d - r_min) with d measured exactly."};
inline const Parameter kThreat{.key = "c",
                               .label = "Threat c",
                               .type = ParameterType::real,
                               .initial = ThreatCurve{}.c,
                               .low = 0.1,
                               .high = ThreatCurve::kMostThreat,
                               .unit = "cells",
                               .help =
                                   "What entering a cell costs that lies r_min or nearer to an obstacle. "
                                   "From there on the threat falls."};
inline const Parameter kThreatInner{
    .key = "r_min",
    .label = "Threat r_min",
    .type = ParameterType::real,
    .initial = ThreatCurve{}.r_min,
    .low = 0,
    .high = ClearanceRules::kMaxRange,
    .unit = "cells",
    .help = "Up to this distance from an obstacle the threat is at its most. It wins where r_max is less."};
inline const Parameter kThreatOuter{.key = "r_max",
                                    .label = "Threat r_max",
                                    .type = ParameterType::real,
                                    .initial = 3,
                                    .low = 1,
                                    .high = ClearanceRules::kMaxRange,
                                    .unit = "cells",
                                    .help = "Beyond this distance from an obstacle there is no threat."};
inline const Parameter kImpassable{.key = "impassable",
                                   .label = "Impassable up to r_min",
                                   .type = ParameterType::toggle,
                                   .help =
                                       "Whether no path may enter a cell that lies r_min or nearer to an "
                                       "obstacle. A goal in such a place cannot be "
                                       "reached."};

/// Whether a planner that asks for lines of sight does so along its path and not in its search.
inline bool checks_along_path(const Settings& settings) {
  return settings.get(kSightChecks) != 0;
}
/// The rules of the AUV paper's threat: kThreat, kThreatInner, kThreatOuter, kImpassable and kBorder.
inline ClearanceRules threat_rules_of(const Settings& settings) {
  const double r_min = settings.get(kThreatInner);
  return {.range = std::max(r_min, settings.get(kThreatOuter)),
          .transform = Transform::euclidean,
          .border_is_obstacle = settings.get(kBorder) != 0,
          .threat = ThreatCurve{settings.get(kThreat), r_min, settings.get(kImpassable) != 0}};
}
/// So many times as long as a shortest path is one that costs least under the threat, at most: each cell costs at most
/// 1 + c times its length. Where cells are impassable there is no bound.
inline double threat_bound(const Settings& settings) {
  if (settings.get(kImpassable) != 0) return std::numeric_limits<double>::infinity();
  return 1 + settings.get(kThreat);
}
/// The rules of the clearance penalty, of which kPenalty says along which curve.
inline ClearanceRules clearance_rules_of(const Settings& settings) {
  if (settings.get(kPenalty) != 0) return threat_rules_of(settings);
  return {.range = settings.get(kRange),
          .transform = static_cast<Transform>(static_cast<int>(settings.get(kTransform))),
          .border_is_obstacle = settings.get(kBorder) != 0};
}

}  // namespace replan::parameters
