// The planners there are. Menus, sliders, command line, help, conformance tests and benchmarks are all made
// from planners/planners.def; nothing else names a planner.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/field/clearance.hpp"
#include "core/lattice/box_lattice.hpp"
#include "core/plan/key_rule.hpp"
#include "core/plan/parameters.hpp"
#include "core/plan/planner.hpp"
#include "core/plan/search_values.hpp"
#include "core/plan/step_words.hpp"
#include "core/trace/tracer.hpp"

namespace replan {

/// What can be said of a planner without running it.
struct PlannerInfo {
  std::string_view id;       ///< as on the command line: "dstar-lite"
  std::string_view name;     ///< as in the window: "D* Lite"
  std::string_view summary;  ///< one sentence
  std::string_view source;   ///< authors, year, DOI
  std::vector<Parameter> parameters;
  SearchValues values = best_first_values();
  KeyRule key = key_rule<GPlusH>();  ///< of best_first_values()
  StepWords step = kExpansionWords;  ///< what a round of its main loop is called
  bool exercise = false;             ///< broken on purpose, to learn finding it: not among "all" planners
  bool incremental = false;          ///< repairs its plan instead of starting afresh
  bool keeps_start = false;          ///< repairs only while its start stays, else starts afresh
  bool planar = false;               ///< plans in worlds of one layer alone
  bool eight_neighbours = false;     ///< has no setting `moves`: there are always diagonals
  bool any_angle = false;            ///< its paths leave the lattice's directions
  bool from_goal = false;            ///< searches from the goal: g is the cost to go
  bool sight = false;                ///< asks for lines of sight
  bool sampling = false;             ///< grows out of random samples: it may find none where there is a path
  bool evolving = false;             ///< breeds a population of paths: it may find none where there is one
  bool informed = false;  ///< draws samples, once it has a path, from where a shorter one could lead
  /// Why it plans for a robot without a size alone, and what to do about it; empty: it does not.
  std::string_view point_only;
  bool blind = false;  ///< no planner: its path is the same whatever stands there
  /// The penalty that it pays for coming near obstacles with these settings: entering a cell costs that besides the
  /// move. Null: it pays none.
  ClearanceRules (*clearance)(const Settings& settings) = nullptr;
  /// With these settings a path is at most so many times as long as a shortest lattice path: 1 if it is never
  /// longer, infinite if there is no bound.
  double (*length_bound)(const Settings& settings) = nullptr;

  /// Whether it may find none where there is a path.
  [[nodiscard]] bool can_miss() const { return sampling || evolving; }
  /// The end that its values are distances from.
  [[nodiscard]] Scalar root() const { return from_goal ? Scalar::goal : Scalar::start; }
  /// The end that it searches for.
  [[nodiscard]] Scalar target() const { return from_goal ? Scalar::start : Scalar::goal; }
  /// Whether it finds a shortest lattice path with these settings.
  [[nodiscard]] bool optimal(const Settings& settings) const {
    return !any_angle && length_bound(settings) == 1;
  }
};

/// All of planners.def, in its order: planners, and what is blind behind them.
std::span<const PlannerInfo> listed_planners();
/// All planners, in that order; what is blind is none.
std::span<const PlannerInfo> planners();
/// All but the exercises, which come last of them.
std::span<const PlannerInfo> sound_planners();
/// Those of them that find a path wherever there is one; what samples may miss it, and comes behind them.
std::span<const PlannerInfo> complete_planners();
/// The values that planners keep of their own, each name once.
std::span<const Field> own_fields();
/// The planner of that id, or what is blind; else nullptr.
const PlannerInfo* find_planner(std::string_view id);
/// As find_planner(), with an error that suggests the nearest id.
Result<const PlannerInfo*> require_planner(std::string_view id);

/// Nothing, or why it cannot plan in a world of that size, or for a robot of that radius.
Result<void> fits(const PlannerInfo& info, const Box& box, double radius);

/// Makes a planner that fits the lattice's box. `lattice` and `tracer` must outlive it.
/// Instantiated for Grid2 and Voxel3 with NoTrace and Recorder.
template <class L, class T>
std::unique_ptr<Planner<L>> make_planner(const PlannerInfo& info, const L& lattice, const Settings& settings,
                                         T& tracer);

/// The estimate that a planner of these settings makes: `zero` if it has no setting for it.
Heuristic heuristic_of(const PlannerInfo& info, const Settings& settings);

/// The parameters `moves` and `corners`, which every lattice planner has.
std::span<const Parameter> lattice_parameters();
/// The rules that these settings ask for, for a robot of that radius.
MoveRules move_rules(const Settings& settings, double radius = 0);

}  // namespace replan
