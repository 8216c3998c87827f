// What a planner's values are, declared: all that the debugger, windows and exports know of them.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "core/trace/field.hpp"
#include "core/trace/search_state.hpp"

namespace replan {

/// How an open list is ordered: by the first key component, which the queue values hold, then by a second one, if it
/// has a name, and a third one, if it has one, then by the node; the least comes out first.
struct ListOrder {
  std::string_view second;                   ///< what the second one is called: "k2"
  std::array<EventKind, 2> reads{};          ///< the costs that it is made of, besides the first
  Cost (*of)(Cost first, Cost a, Cost b){};  ///< the second one, of the first and of those
  std::string_view third = {};               ///< the last of those that it reads, if keys have a third one
};

/// Where the log holds the cost of a plan that stands: this value of that node, or that scalar itself, where the field is
/// EventKind::scalar.
struct CostPlace {
  EventKind field{};
  Scalar node{};
};

/// A number of a search that it works out for each plan, in the log and for users: 2^-30, as costs are.
struct PlanNumber {
  Scalar which{};
  std::string_view key;    ///< in JSON: "weight"
  std::string_view label;  ///< in the window and on the command line
  std::string_view help;   ///< a sentence that teaches
};

struct SearchValues {
  /// Those that it writes for each node; what is its own has the ids own_field(0), own_field(1) and so on.
  std::vector<Field> fields;
  /// Those that it writes for each vertex of a tree, or for the paths of a population, with such ids too.
  std::vector<Field> vertex_fields = {};
  std::vector<PlanNumber> numbers = {};
  ListOrder order;
  CostPlace cost;
  std::string_view laws;    ///< those that its values keep, by their name in core/debug/laws.def
  bool least_cost = false;  ///< its cost is that of a cheapest lattice path whatever its paths look like
  bool waves = false;       ///< its costs rise and fall in waves, of RAISE and LOWER states: fields::kLowest
  bool interpolated = false;  ///< its rhs may lead across squares, too: core/lattice/interpolation.hpp

  [[nodiscard]] const Field* find(EventKind kind) const {
    const auto found =
        std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.kind == kind; });
    return found == fields.end() ? nullptr : &*found;
  }
  /// By its name, be it for nodes or for vertices.
  [[nodiscard]] const Field* find(std::string_view name) const {
    for (const auto* all : {&fields, &vertex_fields})
      for (const Field& field : *all)
        if (field.name == name) return &field;
    return nullptr;
  }
  [[nodiscard]] bool declares(EventKind kind) const { return find(kind) != nullptr; }
  /// Whether a node has a cost and a lookahead of it, which make it consistent or not.
  [[nodiscard]] bool lookahead() const { return declares(EventKind::rhs); }
  /// Whether cells wait in an open list.
  [[nodiscard]] bool lists() const { return declares(EventKind::queue); }
  /// Whether its values keep laws that can be checked.
  [[nodiscard]] bool lawful() const { return laws != "none"; }
  /// Whether it grows a tree of vertices: core/plan/tree_values.hpp.
  [[nodiscard]] bool grows() const {
    return std::any_of(vertex_fields.begin(), vertex_fields.end(),
                       [](const Field& field) { return field.kind == fields::kVertexParent.kind; });
  }
  /// Whether it keeps a population of paths: core/plan/population_values.hpp.
  [[nodiscard]] bool breeds() const {
    return std::any_of(vertex_fields.begin(), vertex_fields.end(),
                       [](const Field& field) { return field.table == FieldTable::paths; });
  }
  /// All that it writes, be it for nodes or for vertices.
  [[nodiscard]] std::vector<Field> all_fields() const {
    std::vector<Field> all = fields;
    all.insert(all.end(), vertex_fields.begin(), vertex_fields.end());
    return all;
  }
  /// What is known of any value: as declared, or as all runs have it (the two maps).
  [[nodiscard]] const Field& field(EventKind kind) const {
    if (const Field* own = find(kind)) return *own;
    for (const Field& own : vertex_fields)
      if (own.kind == kind) return own;
    return kind == EventKind::truth ? fields::kTruth : fields::kKnown;
  }
};

/// What the plan costs that stands in a state.
inline Cost claimed_cost(const SearchValues& values, const SearchState& state) {
  const CostPlace& at = values.cost;
  const bool held = at.field == EventKind::scalar;
  return {
      static_cast<std::int64_t>(held ? state.scalar(at.node) : state.value(at.field, state.node(at.node)))};
}

/// g from the start, and a list by f = g + h, then the larger g: A* and its like.
inline SearchValues best_first_values() {
  return {
      .fields = {fields::kG, fields::kF, fields::kParent, fields::kVisit},
      .order = {"h", {EventKind::g, EventKind::g}, [](Cost f, Cost g, Cost) { return Cost{f.raw - g.raw}; }},
      .cost = {EventKind::g, Scalar::goal},
      .laws = "best-first"};
}

/// g and rhs from the root of the search, and a list by [min(g, rhs) + h + km; min(g, rhs)]: D* Lite and its like.
inline SearchValues lookahead_values() {
  return {.fields = {fields::kG, fields::kRhs, fields::kQueue, fields::kLp, fields::kVisit},
          .order = {"k2",
                    {EventKind::g, EventKind::rhs},
                    [](Cost, Cost g, Cost rhs) { return std::min(g, rhs); }},
          .cost = {EventKind::rhs, Scalar::start},
          .laws = "lookahead",
          .least_cost = true};
}

}  // namespace replan
