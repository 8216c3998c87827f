#include "core/export/json_lines.hpp"

#include "core/base/bit_cast.hpp"
#include "core/base/words.hpp"
#include "core/export/trace_text.hpp"
#include "core/plan/planner.hpp"
#include "core/sim/mission.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

Json settings_json(const LogView& view) {
  Json result = Json::object();
  for (const Parameter& parameter : view.info.parameters) {
    const double value = view.settings.get(parameter);
    Json& setting = result[std::string(parameter.key)];
    if (parameter.type == ParameterType::choice)
      setting = format_value(parameter, value);
    else if (parameter.type == ParameterType::toggle)
      setting = value != 0;
    else
      setting = plain_number(value);
  }
  return result;
}

void boolean(std::string& out, bool value) {
  out += value ? "true" : "false";
}

void cost(std::string& out, Cost cost) {
  if (cost.is_infinite())
    out += "\"inf\"";
  else
    append_cost(out, cost);
}

Cost as_cost(std::uint64_t raw) {
  return {static_cast<std::int64_t>(raw)};
}

}  // namespace

JsonLines::JsonLines(const TraceRun& run)
    : run_(run), initial_(run.view.log.state_at(0)), events_(run.view.log.size()) {}

/// Of all layers.
std::size_t JsonLines::rows() const {
  return static_cast<std::size_t>(run_.view.lattice.height()) *
         static_cast<std::size_t>(run_.view.lattice.depth());
}

/// The opening, a row each of the two maps, and the end of the line.
std::size_t JsonLines::head_parts() const {
  return 2 + 2 * rows();
}

void JsonLines::head(std::string& out, std::size_t part) {
  if (part == 0) return opening(out);
  if (part == head_parts() - 1) return moving(out);
  row(out, (part - 1) % rows(), part <= rows());
}

void JsonLines::opening(std::string& out) const {
  const LogView& view = run_.view;
  const bool solid = view.lattice.solid();
  Json head = {{"format", "replan-trace"},        {"version", kTraceVersion},
               {"scenario", run_.scenario},       {"planner", view.info.id},
               {"settings", settings_json(view)}, {"width", view.lattice.width()},
               {"height", view.lattice.height()}};
  if (solid) head["depth"] = view.lattice.depth();
  head["start"] = coordinates_of(run_.start, solid);
  head["goal"] = coordinates_of(run_.goal, solid);
  if (run_.frame) head["metres_per_cell"] = run_.frame->metres_per_cell();
  if (run_.frame) head["origin"] = run_.frame->origin();
  head["events"] = events_;
  out += head.dump(-1, ' ', false, Json::error_handler_t::replace);
  out.back() = ',';  // the maps are still to come
}

void JsonLines::row(std::string& out, std::size_t row, bool known) const {
  if (row == 0) out += known ? "\"known\":[" : "\"walls\":[";
  out += '"';
  const auto width = static_cast<NodeId>(run_.view.lattice.width());
  const NodeId first = static_cast<NodeId>(row) * width;
  for (NodeId node = first; node < first + width; ++node)
    out += (known ? initial_.known_blocked(node) : initial_.wall(node)) ? '@' : '.';
  out += row + 1 == rows() ? "\"]," : "\",";
}

/// What moves: [x, y, how many of them] for each cell, [x, y, z, how many of them] in space.
void JsonLines::moving(std::string& out) const {
  out += "\"moving\":[";
  const std::size_t begin = out.size();
  for (NodeId node = 0; node < initial_.node_count(); ++node) {
    if (!initial_.moving(node)) continue;
    if (out.size() > begin) out += ',';
    cell(out, node);
    out.back() = ',';
    append_whole(out, initial_.value(EventKind::truth, node) >> 1);
    out += ']';
  }
  out += "]}\n";
}

void JsonLines::cell(std::string& out, NodeId node) const {
  if (node >= run_.view.lattice.node_count()) {
    out += "null";
    return;
  }
  const Cell at = run_.view.lattice.position(node);
  out += '[';
  append_whole(out, at.x);
  out += ',';
  append_whole(out, at.y);
  if (run_.view.lattice.solid()) {
    out += ',';
    append_whole(out, at.z);
  }
  out += ']';
}

void JsonLines::event(std::string& out, std::size_t index, const Event& event, const SearchState& state) {
  out += "{\"event\":";
  append_whole(out, index);
  out += ",\"line\":";
  append_whole(out, event.line);
  out += ",\"kind\":\"";
  out += event_name(run_.view.info.values, event.kind);
  if (event.kind == EventKind::scalar) {
    out += "\",\"name\":\"";
    out += scalar_name(static_cast<Scalar>(event.node));
    out += '"';
  } else {
    out += "\",";
    subject(out, event);
  }
  if (event.changes_value()) {
    const std::uint64_t before = state.value(event.kind, event.node);
    out += ",\"before\":";
    value(out, event, before);
    out += ",\"after\":";
    value(out, event, before ^ event.delta);
  } else {
    payload(out, event);
  }
  out += "}\n";
}

/// A raw value as its kind means it.
void JsonLines::value(std::string& out, const Event& event, std::uint64_t raw) const {
  if (event.kind == EventKind::scalar) return scalar(out, static_cast<Scalar>(event.node), raw);
  if (event.kind == EventKind::truth) {
    out += "{\"wall\":";
    boolean(out, (raw & 1) != 0);
    out += ",\"moving\":";
    append_whole(out, raw >> 1);
    out += '}';
    return;
  }
  const Field& field = run_.view.info.values.field(event.kind);
  switch (field.type) {
    case FieldType::cost:
      return cost(out, as_cost(raw));
    case FieldType::queue:
      if (raw == 0)
        out += "null";
      else
        cost(out, as_cost(raw - 1));
      return;
    case FieldType::node:
      return cell(out, static_cast<NodeId>(raw) - 1u);
    case FieldType::visits:
      out += "{\"order\":";
      append_whole(out, static_cast<std::uint32_t>(raw));
      out += ",\"times\":";
      append_whole(out, raw >> 32);
      out += '}';
      return;
    case FieldType::obstacle:
      return boolean(out, raw != 0);
    case FieldType::name:
      if (raw < field.names.size()) {
        ((out += '"') += field.names[static_cast<std::size_t>(raw)]) += '"';
        return;
      }
      break;
    case FieldType::vertex:
      return numbered(out, raw);
    case FieldType::count:
      break;
  }
  append_whole(out, raw);
}

FieldTable JsonLines::table_of(EventKind kind) const {
  const SearchValues& values = run_.view.info.values;
  if (kind == EventKind::candidate && values.breeds()) return FieldTable::paths;
  if (is_of_vertex(kind)) return FieldTable::vertices;
  return is_own_field(kind) ? values.field(kind).table : FieldTable::nodes;
}
/// What the event is about.
void JsonLines::subject(std::string& out, const Event& event) const {
  switch (table_of(event.kind)) {
    case FieldTable::vertices:
      out += "\"vertex\":";
      return append_whole(out, event.node);
    case FieldTable::paths:
      out += "\"path\":";
      return append_whole(out, event.node);
    case FieldTable::places:
      out += "\"path\":";
      append_whole(out, event.node / kPlacesOfPath);
      out += ",\"place\":";
      return append_whole(out, event.node % kPlacesOfPath);
    case FieldTable::nodes:
      out += "\"cell\":";
      return cell(out, event.node);
  }
}
/// A number, held + 1; null for 0.
void JsonLines::numbered(std::string& out, std::uint64_t held) {
  if (held == 0)
    out += "null";
  else
    append_whole(out, held - 1);
}

void JsonLines::scalar(std::string& out, Scalar which, std::uint64_t raw) const {
  const ScalarType type = scalar_type(which);
  const bool none = (type == ScalarType::found_cost || type == ScalarType::score) && raw == 0;
  if (none) {
    out += "null";
    return;
  }
  switch (type) {
    case ScalarType::cost:
    case ScalarType::found_cost:
      return cost(out, as_cost(raw));
    case ScalarType::count:
      append_whole(out, raw);
      return;
    case ScalarType::some_count:
    case ScalarType::vertex:
    case ScalarType::path:
      return numbered(out, raw);
    case ScalarType::real:
      return append_real(out, bit_cast<double>(raw));
    case ScalarType::score:
      return append_real(out, score_of(raw));
    case ScalarType::node:
      return cell(out, static_cast<NodeId>(raw) - 1u);
  }
}

/// What an event says that changes no value.
void JsonLines::payload(std::string& out, const Event& event) const {
  const auto with = [&out](const char* key) { ((out += ",\"") += key) += "\":"; };
  switch (event.kind) {
    case EventKind::sight:
      with("target");
      cell(out, static_cast<NodeId>(event.delta & 0xFFFFFFFFu));
      with("clear");
      return boolean(out, event.delta >> 32 != 0);
    case EventKind::unchecked:
      with("target");
      return cell(out, static_cast<NodeId>(event.delta & 0xFFFFFFFFu));
    case EventKind::plan_begin:
      with("replan");
      return append_whole(out, event.delta);
    case EventKind::plan_end:
      with("status");
      ((out += '"') += status_name(static_cast<PlanStatus>(event.delta))) += '"';
      return;
    case EventKind::sensed:
    case EventKind::forgotten:
      with("blocked");
      return boolean(out, event.delta != 0);
    case EventKind::aim:
      with("goal");
      return boolean(out, event.delta != 0);
    case EventKind::surprise:
      with("number");
      return append_whole(out, event.delta);
    case EventKind::turn:
      with("degrees");
      return append_whole(out, event.delta);
    case EventKind::waiting:
      with("steps");
      return append_whole(out, event.delta);
    case EventKind::gave_up:
      with("why");
      ((out += '"') += mission_state_name(static_cast<MissionState>(event.delta))) += '"';
      return;
    case EventKind::candidate:
      with("cost");
      return cost(out, as_cost(event.delta));
    case EventKind::rewired:
      with("saves");
      return cost(out, as_cost(event.delta));
    case EventKind::rejected:
      with("why");
      ((out += '"') += fault_name(static_cast<SampleFault>(event.delta))) += '"';
      return;
    case EventKind::tried:
      with("cost");
      cost(out, as_cost(event.delta >> 1));
      with("hits");
      return boolean(out, (event.delta & 1) != 0);
    default:
      return;
  }
}

void JsonLines::tail(std::string&, const SearchState&) {}

}  // namespace replan
