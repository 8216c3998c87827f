#include "core/debug/measures.hpp"

#include "core/debug/open_order.hpp"
#include "core/debug/parents.hpp"

namespace replan {
namespace {

using MeasureSource = Measure::Source;

void add_field_measures(std::vector<Measure>& all, const Field& field) {
  const std::string id(field.name), label(field.label), help(field.help);
  switch (field.type) {
    case FieldType::cost:
    case FieldType::queue:
    case FieldType::count:
      all.push_back({MeasureSource::value, field, id, label, help});
      break;
    case FieldType::visits:
      all.push_back({MeasureSource::value, field, "expansion", "last " + label,
                     "Which turn of the search was its latest, counted from 1."});
      all.push_back({MeasureSource::times, field, "times", "times " + label, "How many turns it has had."});
      break;
    default:
      break;  // no numbers
  }
}

std::optional<double> finite_cost(Cost cost) {
  if (cost.is_infinite()) return std::nullopt;
  return cost.to_double();
}

}  // namespace

bool Measure::whole() const {
  switch (source) {
    case MeasureSource::event:
    case MeasureSource::reached:
    case MeasureSource::times:
    case MeasureSource::number:
      return true;
    case MeasureSource::value:
      return field.type == FieldType::visits || field.type == FieldType::count;
    default:
      return false;
  }
}

std::vector<Measure> measures_of(const PlannerInfo& info) {
  const SearchValues& values = info.values;
  const bool grows = values.grows();
  std::vector<Measure> all = {
      {MeasureSource::event, {}, "event", "event", "The event of the log that wrote a value of it first."}};
  all.push_back({MeasureSource::reached,
                 {},
                 "reached",
                 info.can_miss() ? std::string(info.step.one) : "reached in expansion",
                 "How many turns the search had had when it came to it first."});
  for (const Field& field : grows ? values.vertex_fields : values.fields)
    if (field.shown && field.table == (grows ? FieldTable::vertices : FieldTable::nodes))
      add_field_measures(all, field);
  if (!grows && values.order.of != nullptr && !values.order.second.empty())
    all.push_back({MeasureSource::second,
                   {},
                   "second",
                   std::string(values.order.second),
                   "The second part of its key while it waits in the open list."});
  if (grows)
    all.push_back(
        {MeasureSource::number, {}, "vertex", "vertex", "Its number, in the order in which the tree grew."});
  all.push_back({MeasureSource::to_goal,
                 {},
                 "to_goal",
                 "distance to the goal",
                 "How far it lies from the goal in a straight line, in cells."});
  all.push_back({MeasureSource::to_start,
                 {},
                 "to_start",
                 "distance to the start",
                 "How far it lies from the search's start in a straight line, in cells."});
  return all;
}

MeasureReader::MeasureReader(const LogView& view, const SearchState& state, const Measure& measure)
    : view_(view), state_(state), measure_(measure) {
  if (measure.source != MeasureSource::to_goal && measure.source != MeasureSource::to_start) return;
  const NodeId end =
      measure.source == MeasureSource::to_goal ? state.wanted_goal() : state.node(Scalar::start);
  if (end != kNoNode) end_ = centre_of(view.lattice.position(end));
}

std::optional<double> MeasureReader::read(const FirstTouch& touch) const {
  switch (measure_.source) {
    case MeasureSource::event:
      return static_cast<double>(touch.event + 1);
    case MeasureSource::reached:
      return touch.expanded;
    case MeasureSource::value:
      return value(touch.point);
    case MeasureSource::times:
      return static_cast<double>(state_.value(measure_.field.kind, touch.point) >> 32);
    case MeasureSource::second:
      return second(touch.point);
    case MeasureSource::number:
      return touch.point;
    case MeasureSource::to_start:
    case MeasureSource::to_goal:
      if (!end_) return std::nullopt;
      return distance(place_of_point(view_, state_, touch.point), *end_);
  }
  return std::nullopt;
}

std::optional<double> MeasureReader::value(NodeId point) const {
  const std::uint64_t raw = state_.value(measure_.field.kind, point);
  switch (measure_.field.type) {
    case FieldType::cost:
      return finite_cost({static_cast<std::int64_t>(raw)});
    case FieldType::queue:
      return raw == 0 ? std::nullopt : finite_cost({static_cast<std::int64_t>(raw) - 1});
    case FieldType::visits:
      return (raw & 0xFFFFFFFFu) == 0 ? std::nullopt
                                      : std::optional<double>(static_cast<double>(raw & 0xFFFFFFFFu));
    default:
      return static_cast<double>(raw);
  }
}

std::optional<double> MeasureReader::second(NodeId point) const {
  if (!state_.queued(point)) return std::nullopt;
  return finite_cost(open_entry(state_, view_.info.values.order, point).k2);
}

}  // namespace replan
