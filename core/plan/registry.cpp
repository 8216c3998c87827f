#include "core/plan/registry.hpp"

#include <algorithm>
#include <functional>

#include "core/plan/named.hpp"

#define REPLAN_PLANNER_HEADERS
#include "core/planners/planners.def"
#undef REPLAN_PLANNER_HEADERS

namespace replan {
namespace {

template <class Switches>
PlannerInfo entry(std::string_view id, Switches switches) {
  PlannerInfo info = describe(switches);
  info.id = id;
  for (const Parameter& common : lattice_parameters())
    if (!info.eight_neighbours || common.key != parameters::kMoves.key) info.parameters.push_back(common);
  return info;
}

/// Those that stand before the first of which that holds.
std::span<const PlannerInfo> before_first(std::span<const PlannerInfo> all, auto PlannerInfo::*trait) {
  return {all.begin(), std::find_if(all.begin(), all.end(), std::mem_fn(trait))};
}

}  // namespace

std::span<const PlannerInfo> listed_planners() {
  static const std::vector<PlannerInfo> all = {
#define REPLAN_PLANNER(ID, CLASS, SWITCHES) entry(ID, SWITCHES),
#include "core/planners/planners.def"
#undef REPLAN_PLANNER
  };
  return all;
}

std::span<const PlannerInfo> planners() {
  static const auto all = before_first(listed_planners(), &PlannerInfo::blind);
  return all;
}

std::span<const PlannerInfo> sound_planners() {
  static const auto all = before_first(planners(), &PlannerInfo::exercise);
  return all;
}

std::span<const PlannerInfo> complete_planners() {
  static const auto all = before_first(sound_planners(), &PlannerInfo::can_miss);
  return all;
}

std::span<const Field> own_fields() {
  static const std::vector<Field> all = [] {
    std::vector<Field> fields;
    for (const PlannerInfo& info : planners())
      for (const Field& field : info.values.all_fields()) {
        const auto same = [&](const Field& other) { return other.name == field.name; };
        const bool of_path = field.table == FieldTable::paths || field.table == FieldTable::places;
        if (is_own_field(field.kind) && !of_path && std::none_of(fields.begin(), fields.end(), same))
          fields.push_back(field);
      }
    return fields;
  }();
  return all;
}

const PlannerInfo* find_planner(std::string_view id) {
  return find_by_id(listed_planners(), id);
}

Result<const PlannerInfo*> require_planner(std::string_view id) {
  return require_by_id(planners(), id, "planner");
}

Result<void> fits(const PlannerInfo& info, const Box& box, double radius) {
  if (radius > 0 && !info.point_only.empty())
    return Error{"'" + std::string(info.id) + "' plans for a robot without a size alone, since " +
                 std::string(info.point_only)};
  constexpr int kLongestSide =
      1 << 17;  // cells: longer ways do not fit the whole numbers that they are held in
  if (info.can_miss() && std::max({box.width(), box.height(), box.depth()}) > kLongestSide)
    return Error{"'" + std::string(info.id) + "' plans in worlds of at most " + std::to_string(kLongestSide) +
                 " cells along each side"};
  if (!info.planar || !box.solid()) return {};
  return Error{"'" + std::string(info.id) + "' plans in the plane alone, and this world has " +
               std::to_string(box.depth()) + " layers"};
}

Heuristic heuristic_of(const PlannerInfo& info, const Settings& settings) {
  const Parameter* parameter = find_parameter(info.parameters, parameters::kAnyHeuristic.key);
  if (parameter == nullptr) return Heuristic::zero;
  // By name: not all planners offer all of them.
  const std::string_view name = parameter->choices[static_cast<std::size_t>(settings.get(*parameter))];
  const auto& all = parameters::kAnyHeuristic.choices;
  return static_cast<Heuristic>(std::find(all.begin(), all.end(), name) - all.begin());
}

std::span<const Parameter> lattice_parameters() {
  static const std::vector<Parameter> all = {parameters::kMoves, parameters::kCorners};
  return all;
}

MoveRules move_rules(const Settings& settings, double radius) {
  return {.corners = static_cast<CornerRule>(static_cast<int>(settings.get(parameters::kCorners))),
          .diagonals = settings.get(parameters::kMoves) == 0,
          .radius = radius};
}

}  // namespace replan
