#include "core/debug/event_words.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/bit_cast.hpp"
#include "core/base/words.hpp"

namespace replan {
namespace {

constexpr const char* kInfinity = "∞";

/// Which value of what.
std::string subject_text(const Box& lattice, const Field& field, NodeId of) {
  const std::string label(field.label), number = std::to_string(of);
  switch (field.table) {
    case FieldTable::vertices:
      return label + " of vertex " + number;
    case FieldTable::paths:
      return label + " of path " + number;
    case FieldTable::places:
      return label + " " + std::to_string(of % kPlacesOfPath) + " of path " +
             std::to_string(of / kPlacesOfPath);
    case FieldTable::nodes:
      break;
  }
  return value_name(field) + node_text(lattice, of);
}

std::string change_text(const Box& lattice, const SearchValues& values, const Event& event,
                        std::uint64_t after) {
  if (event.kind == EventKind::scalar) {
    const auto which = static_cast<Scalar>(event.node);
    return std::string(value_name(which)) + " = " + scalar_text(lattice, which, after);
  }
  const Field& field = values.field(event.kind);
  return subject_text(lattice, field, event.node) + ": " + value_text(lattice, field, after ^ event.delta) +
         " → " + value_text(lattice, field, after);
}

std::string candidate_text(const SearchValues& values, const Event& event) {
  const Cost sum{static_cast<std::int64_t>(event.delta)};
  const std::string vertex = std::to_string(event.node);
  if (values.breeds()) return "path " + vertex + " could be a parent: it costs " + cost_text(sum);
  if (sum.is_infinite()) return "vertex " + vertex + " does not see the new place";
  return "over vertex " + vertex + " the new place costs " + cost_text(sum);
}

std::string tried_text(const std::string& at, std::uint64_t bits) {
  const std::string cost = cost_text({static_cast<std::int64_t>(bits >> 1)});
  return (bits & 1) != 0 ? "over " + at + " the child would cost " + cost + ", and hit something"
                         : "over " + at + " the child would cost " + cost;
}

std::string fault_text(SampleFault why, const std::string& at) {
  switch (why) {
    case SampleFault::blocked:
      return "the sample is given up: " + at + " is in the way";
    case SampleFault::taken:
      return "the sample is given up: there is a vertex already";
    case SampleFault::longer:
      return "the sample is given up: the path would be no shorter over it";
    case SampleFault::twin:
      return "the child is given up: the population has that path already";
    case SampleFault::unfit:
      return "the child is given up: no path of the population is less fit";
    case SampleFault::path_end:
      break;
  }
  return "the sample is given up: it is nearest to an end of the path, which stays where it is";
}

std::string happening_text(const Box& lattice, const SearchValues& values, const Event& event) {
  const std::string at = node_text(lattice, event.node);
  const std::string target = node_text(lattice, static_cast<NodeId>(event.delta & 0xFFFFFFFFu));
  switch (event.kind) {
    case EventKind::pop:
      if (values.breeds()) return "another child is bred";
      return values.grows() ? "a sample is drawn in " + at : "took " + at + " from the open list";
    case EventKind::sight:
      return (event.delta >> 32 != 0 ? at + " sees " : at + " does not see ") + target;
    case EventKind::plan_begin:
      return event.delta == 0 ? "the first plan begins" : "replan " + std::to_string(event.delta) + " begins";
    case EventKind::plan_end:
      return status_sentence(static_cast<PlanStatus>(event.delta));
    case EventKind::move:
      return "the robot enters " + at;
    case EventKind::sensed:
      return "the robot sees " + at + (event.delta != 0 ? " blocked" : " free");
    case EventKind::surprise:
      return "a surprise: the world changes";
    case EventKind::unchecked:
      return at + " trusts its remote parent " + target;
    case EventKind::collision:
      return "the plan leads into an obstacle at " + at;
    case EventKind::turn:
      return "the robot turns by " + std::to_string(event.delta) + "° on the spot at " + at;
    case EventKind::waiting:
      return "no path: the robot waits at " + at;
    case EventKind::arrival:
      return "the robot arrives at " + at;
    case EventKind::gave_up:
      return "the mission ends at " + at;
    case EventKind::new_goal:
      return "the goal is " + at + " now: a plan from scratch";
    case EventKind::put_down:
      return "the robot is put down at " + at;
    case EventKind::forgotten:
      return "the robot forgets what it saw moving at " + at;
    case EventKind::aim:
      return event.delta != 0 ? "the goal " + at + " can be reached: the robot makes for it again"
                              : "the goal cannot be reached: the robot makes for " + at;
    case EventKind::epoch:
      return "the planner forgets its search and begins another one";
    case EventKind::candidate:
      return candidate_text(values, event);
    case EventKind::rewired:
      return "vertex " + std::to_string(event.node) + " hangs on the new vertex now, which saves " +
             cost_text({static_cast<std::int64_t>(event.delta)});
    case EventKind::rejected:
      return fault_text(static_cast<SampleFault>(event.delta), at);
    case EventKind::tried:
      return tried_text(at, event.delta);
    default:
      return "";
  }
}

}  // namespace

std::string value_name(const Field& field) {
  if (field.kind == EventKind::known) return "the robot's map";
  if (field.kind == EventKind::truth) return "the world";
  if (field.type == FieldType::queue) return "k1";
  if (field.type == FieldType::visits) return "expansion";
  return std::string(field.name);
}

const char* value_name(Scalar scalar) {
  static constexpr std::array<const char*, static_cast<std::size_t>(Scalar::count)> kNames = {
      "km",
      "s_start",
      "s_last",
      "s_goal",
      "the robot",
      "moves",
      "replans",
      "the goal",
      "the weight",
      "K",
      "x",
      "y",
      "the heading",
      "the speed",
      "the turn rate",
      "the sub-goal",
      "admissible arcs",
      "the score of the chosen arc",
      "vertices",
      "the root",
      "the goal's vertex",
      "x of the sample",
      "y of the sample",
      "z of the sample",
      "x of the new place",
      "y of the new place",
      "z of the new place",
      "the nearest vertex",
      "the best path",
      "samples before the plan",
      "the last sample that made the path shorter",
      "the ball",
      "paths of the population and the child",
      "the child",
      "the fittest path",
      "the cost of the fittest path",
      "the mean cost of the population",
      "generations",
      "the mother",
      "the father",
      "cells of the mother in the child",
      "the father's place from which on the child has his cells",
      "the cell at which the parents are crossed",
      "the cell that is replaced",
      "the cell that replaces it"};
  return scalar < Scalar::count ? kNames[static_cast<std::size_t>(scalar)] : "";
}

std::string decimal_text(double number, int decimals) {
  if (std::isinf(number)) return number > 0 ? kInfinity : std::string("-") + kInfinity;
  std::array<char, 400> text{};  // the largest double has 309 digits
  std::snprintf(text.data(), text.size(), "%.*f", decimals, number);
  return text.data();
}

std::string cost_text(Cost cost, int decimals) {
  return cost.is_infinite() ? kInfinity : decimal_text(cost.to_double(), decimals);
}

std::string node_text(const Box& lattice, NodeId node) {
  return node >= lattice.node_count() ? "none" : cell_text(lattice.position(node), lattice.solid());
}

std::string value_text(const Box& lattice, const Field& field, std::uint64_t raw) {
  switch (field.type) {
    case FieldType::cost:
      return cost_text(Cost{static_cast<std::int64_t>(raw)});
    case FieldType::queue:
      return raw == 0 ? "not in U" : cost_text(Cost{static_cast<std::int64_t>(raw) - 1});
    case FieldType::node:
      return node_text(lattice, static_cast<NodeId>(raw) - 1u);
    case FieldType::visits:
      return std::to_string(raw & 0xFFFFFFFFu);
    case FieldType::obstacle:
      return raw != 0 ? "obstacle" : "free";
    case FieldType::name:
      return raw < field.names.size() ? std::string(field.names[static_cast<std::size_t>(raw)])
                                      : std::to_string(raw);
    case FieldType::vertex:
      return raw == 0 ? "none" : std::to_string(raw - 1);
    case FieldType::count:
      break;
  }
  return std::to_string(raw);
}

std::string scalar_text(const Box& lattice, Scalar scalar, std::uint64_t raw) {
  const Cost cost{static_cast<std::int64_t>(raw)};
  switch (scalar_type(scalar)) {
    case ScalarType::cost:
      return cost_text(cost);
    case ScalarType::found_cost:
      return raw == 0 ? "none" : cost_text(cost);
    case ScalarType::count:
      return std::to_string(raw);
    case ScalarType::some_count:
    case ScalarType::vertex:
    case ScalarType::path:
      return raw == 0 ? "none" : std::to_string(raw - 1);
    case ScalarType::real:
      return decimal_text(bit_cast<double>(raw), 3);
    case ScalarType::score:
      return raw == 0 ? "none" : decimal_text(score_of(raw), 3);
    case ScalarType::node:
      break;
  }
  return node_text(lattice, static_cast<NodeId>(raw) - 1u);
}

std::string event_text(const Box& lattice, const SearchValues& values, const Event& event,
                       std::uint64_t after) {
  return event.changes_value() ? change_text(lattice, values, event, after)
                               : happening_text(lattice, values, event);
}

std::string event_text(const LogView& view, std::size_t position) {
  if (position == 0) return "";
  const Event event = view.log.event(position - 1);
  if (!event.changes_value()) return event_text(view.lattice, view.info.values, event, 0);
  const bool here = position == view.log.cursor();
  const std::uint64_t after = here ? view.log.state().value(event.kind, event.node)
                                   : view.log.state_at(position).value(event.kind, event.node);
  return event_text(view.lattice, view.info.values, event, after);
}

std::string line_name(const PlannerPage& page, int number) {
  const PseudoLine* line = page.line(number);
  if (line == nullptr) return "line " + std::to_string(number);
  const std::string name = "line " + std::to_string(number);
  return page.code.size() < 2 ? name : name + " of " + page.block_of(number)->title;
}

}  // namespace replan
