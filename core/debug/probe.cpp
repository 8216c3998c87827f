#include "core/debug/probe.hpp"

#include <algorithm>

#include "core/debug/event_words.hpp"

namespace replan {
namespace {

/// The kinds of events that write what a value of a vertex is made of.
KindSet kinds_of(Op op) {
  switch (op) {
    case Op::g:
      return {EventKind::g};
    case Op::rhs:
      return {EventKind::rhs};
    case Op::dist:
      return {EventKind::dist};
    case Op::k1:
    case Op::queued:
      return {EventKind::queue};
    case Op::k2:
      return {EventKind::queue, EventKind::g, EventKind::rhs};
    case Op::order:
    case Op::times:
      return {EventKind::visit};
    case Op::lp:
      return {EventKind::lp};
    case Op::rp:
      return {EventKind::rp};
    case Op::known:
      return {EventKind::known};
    case Op::wall:
      return {EventKind::truth};
    case Op::consistent:
      return {EventKind::g, EventKind::rhs};
    case Op::queue_size:
      return {EventKind::queue};
    case Op::expansions:
      return {EventKind::visit};
    default:
      return {};
  }
}

/// The value of the run that a term names.
std::optional<Scalar> scalar_of(Op op) {
  switch (op) {
    case Op::km:
      return Scalar::km;
    case Op::moves:
      return Scalar::moves;
    case Op::replans:
      return Scalar::replans;
    case Op::robot:
      return Scalar::robot;
    case Op::start:
      return Scalar::start;
    case Op::goal:
      return Scalar::goal;
    case Op::last:
      return Scalar::last;
    default:
      return std::nullopt;
  }
}

/// The kinds of events that event(NAME) is about.
KindSet kinds_of(Happening happening) {
  switch (happening) {
    case Happening::plan:
    case Happening::replan:
      return {EventKind::plan_begin};
    case Happening::underconsistent:
      return {EventKind::pop};
    case Happening::sight_failed:
      return {EventKind::sight};
    case Happening::no_path:
      return {EventKind::plan_end};
    case Happening::blocked:
      return {EventKind::waiting, EventKind::collision, EventKind::gave_up};
    case Happening::surprise:
      return {EventKind::surprise};
    case Happening::move:
      return {EventKind::move};
    case Happening::arrival:
      return {EventKind::arrival};
    default:
      return {};
  }
}

constexpr std::uint64_t node_bit(NodeId node) {
  return std::uint64_t{1} << (node & 63u);
}

/// Calls `each` for the kinds in a set.
template <class Each>
void for_kinds(KindSet kinds, Each each) {
  for (int kind = 0; kind <= static_cast<int>(EventKind::forgotten); ++kind)
    if (kinds.has(static_cast<EventKind>(kind))) each(static_cast<EventKind>(kind));
}

/// The first of ascending positions that is greater.
std::size_t first_after(std::span<const std::size_t> positions, std::size_t position) {
  const auto found = std::upper_bound(positions.begin(), positions.end(), position);
  return found == positions.end() ? SIZE_MAX : *found;
}
/// The last of ascending positions that is not greater; 0 if there is none.
std::size_t last_until(std::span<const std::size_t> positions, std::size_t position) {
  const auto found = std::upper_bound(positions.begin(), positions.end(), position);
  return found == positions.begin() ? 0 : *std::prev(found);
}

}  // namespace

Probe::Probe(const LogView& view, Condition condition, std::size_t position, Verdicts verdicts,
             std::optional<std::int64_t> expansions_before)
    : log_(&view.log),
      lattice_(&view.lattice),
      values_(view.info.values),
      condition_(std::move(condition)),
      verdicts_(verdicts),
      position_(position) {
  for (const Term& term : condition_.terms) collect(term);
  load(expansions_before);
}

/// Notes what a term reads.
void Probe::collect(const Term& term) {
  const bool asks =
      term.op == Op::event || term.op == Op::changed || term.op == Op::taken || term.op == Op::taken_any;
  pulses_ |= asks;
  reads_line_ |= term.op == Op::line || term.op == Op::on_line;
  if (is_of_vertex(term.op))
    for_kinds(kinds_of(term.op), [&](EventKind kind) { collect_slot(kind, node_of(term)); });
  if (const auto scalar = scalar_of(term.op)) collect_slot(EventKind::scalar, static_cast<NodeId>(*scalar));
  if (term.op == Op::queue_size) walked_.add(EventKind::queue);
  if (term.op == Op::expansions) noted_.add(EventKind::visit);
  if (term.op == Op::taken || term.op == Op::taken_any) noted_.add(EventKind::pop);
  if (term.op != Op::event) return;
  for_kinds(kinds_of(term.happening), [&](EventKind kind) { noted_.add(kind); });
  reads_breaches_ |= term.happening == Happening::invariant;
  reads_disagreements_ |= term.happening == Happening::oracle;
  if (term.happening == Happening::blocked)
    collect_slot(EventKind::scalar, static_cast<NodeId>(Scalar::goal));
  if (term.happening == Happening::underconsistent) {
    walked_.add(EventKind::g);
    walked_.add(EventKind::rhs);
  }
}

void Probe::collect_slot(EventKind kind, NodeId node) {
  const Slot slot{node, kind, 0};
  const auto place = std::lower_bound(slots_.begin(), slots_.end(), slot);
  if (place != slots_.end() && *place == slot) return;
  slots_.insert(place, slot);
  slot_nodes_ |= node_bit(node);
  slot_kinds_.add(kind);
}

/// Reads the values at the position out of the log.
void Probe::load(std::optional<std::int64_t> expansions_before) {
  if (condition_.uses(Op::expansions))
    expansions_ = expansions_before ? *expansions_before : ExpansionCount().before(*log_, position_);
  if (slots_.empty() && walked_.empty()) return;
  if (walked_.empty() && position_ == log_->cursor()) {
    for (Slot& slot : slots_) slot.raw = log_->state().value(slot.kind, slot.node);
    return;
  }
  SearchState state = log_->state_at(position_);
  for (Slot& slot : slots_) slot.raw = state.value(slot.kind, slot.node);
  if (!walked_.empty()) state_ = std::move(state);
}

NodeId Probe::node_of(const Term& term) const {
  return lattice_->node(term.cell);
}

Probe::Slot* Probe::find_slot(EventKind kind, NodeId node) {
  const auto found = std::lower_bound(
      slots_.begin(), slots_.end(), Slot{node, kind, 0},
      [](const Slot& a, const Slot& b) { return a.node != b.node ? a.node < b.node : a.kind < b.kind; });
  return found != slots_.end() && found->node == node && found->kind == kind ? &*found : nullptr;
}

// Walking.

/// Whether anything that the expression reads may change with the event.
bool Probe::is_interesting(std::size_t index) const {
  const Event event = log_->event(index);
  if (walked_.has(event.kind) || noted_.has(event.kind)) return true;
  if (slot_kinds_.has(event.kind) && (slot_nodes_ & node_bit(event.node)) != 0) return true;
  return reads_line_ && event.line != line_before(index);
}

std::size_t Probe::next_interesting(std::size_t from, std::size_t limit) const {
  std::size_t end = limit;
  if (reads_breaches_) end = std::min(end, first_after(verdicts_.breaches, from) - 1);
  if (reads_disagreements_) end = std::min(end, first_after(verdicts_.disagreements, from) - 1);
  std::size_t i = from;
  while (i < end && !is_interesting(i)) ++i;
  return i;
}

/// The end of the stretch of uninteresting events before `end`, seen from there: the index behind the last
/// interesting event, or `limit`.
std::size_t Probe::interesting_before(std::size_t end, std::size_t limit) const {
  std::size_t begin = limit;
  if (reads_breaches_) begin = std::max(begin, last_until(verdicts_.breaches, end));
  if (reads_disagreements_) begin = std::max(begin, last_until(verdicts_.disagreements, end));
  std::size_t i = end;
  while (i > begin && !is_interesting(i - 1)) --i;
  return i;
}

/// Takes the values over the event, either way. True if one that the expression reads by itself is another
/// now.
bool Probe::cross(const Event& event) {
  bool read = noted_.has(event.kind);
  if (slot_kinds_.has(event.kind) && (slot_nodes_ & node_bit(event.node)) != 0)
    if (Slot* slot = find_slot(event.kind, event.node)) {
      slot->raw ^= event.delta;
      read = true;
    }
  if (!walked_.has(event.kind)) return read;
  const std::size_t queued = state_.queue_size();
  state_.apply(event);
  return read || queued != state_.queue_size();
}

/// One event on. False if nothing happened that the expression could see.
bool Probe::advance() {
  const std::size_t index = position_++;
  bool seen = cross(log_->event(index));
  if (noted_.has(EventKind::visit) && teller_(*log_, index)) ++expansions_;
  if (reads_line_) seen |= log_->event(index).line != (index == 0 ? 0 : log_->event(index - 1).line);
  return seen || reads_breaches_ || reads_disagreements_;
}

void Probe::retreat() {
  const std::size_t index = --position_;
  cross(log_->event(index));
  if (noted_.has(EventKind::visit) && teller_(*log_, index)) --expansions_;
}

std::optional<std::size_t> Probe::forwards(std::size_t limit) {
  bool before = holds(true);
  bool lasting = !pulses_;  // `before` does not rest on the latest event
  while (position_ < limit) {
    const std::size_t next = next_interesting(position_, limit);
    if (next > position_) {  // an event of no interest: what was true by grace of the one before no longer is
      const bool now = lasting ? before : holds(false);
      if (now && !before) return ++position_;
      before = now;
      lasting = true;
      position_ = next;
      if (position_ == limit) break;
    }
    if (!advance()) {
      const bool now = lasting ? before : holds(false);
      if (now && !before) return position_;
      before = now;
      lasting = true;
      continue;
    }
    const bool now = holds(true);
    if (is_stop(now, before)) return position_;
    before = now;
    lasting = !pulses_;
  }
  return std::nullopt;
}

/// Whether the position is a stop.
bool Probe::stops_here() {
  if (position_ == 0 || !holds(true)) return false;
  if (pulses_ && !holds(false)) return true;
  retreat();
  const bool before = holds(true);
  advance();
  return !before;
}

std::optional<std::size_t> Probe::backwards(std::size_t limit) {
  if (position_ <= limit) return std::nullopt;
  retreat();
  bool now = holds(true);
  while (position_ > limit) {
    const std::size_t quiet = interesting_before(position_, limit);
    if (quiet < position_) {  // nothing changes between here and there but for what `quiet` itself is told of
      position_ = quiet;
      const bool before = holds(true);
      if (now && !before) return ++position_;
      now = before;
      continue;
    }
    retreat();
    const bool before = holds(true);
    if (now && !before) {
      advance();
      return position_;
    }
    if (now && pulses_) {
      advance();
      if (!holds(false)) return position_;
      retreat();
    }
    now = before;
  }
  return stops_here() ? std::optional(position_) : std::nullopt;
}

bool Probe::next_change(std::size_t limit) {
  while (position_ < limit) {
    position_ = next_interesting(position_, limit);
    if (position_ < limit && advance()) return true;
  }
  return false;
}

// What the terms are at the position.

TermValue Probe::value(const Term& term) {
  TermValue result{.type = term.type};
  if (term.type == ValueType::number) result.number = number(term).value;
  if (term.type == ValueType::truth) result.truth = truth(term);
  if (term.type == ValueType::cell) result.node = cell(term);
  return result;
}

bool Probe::truth(const Term& term) {
  switch (term.op) {
    case Op::truth_literal:
      return term.truth;
    case Op::either:
      return truth(part(term.left)) || truth(part(term.right));
    case Op::both:
      return truth(part(term.left)) && truth(part(term.right));
    case Op::negated:
      return !truth(part(term.left));
    case Op::queued:
      return raw(EventKind::queue, node_of(term)) != 0;
    case Op::known:
      return raw(EventKind::known, node_of(term)) != 0;
    case Op::wall:
      return (raw(EventKind::truth, node_of(term)) & 1) != 0;
    case Op::consistent:
      return values_ == SearchValues::best_first ||
             raw(EventKind::g, node_of(term)) == raw(EventKind::rhs, node_of(term));
    case Op::on_line:
      return line() == term.number;
    case Op::taken:
    case Op::taken_any:
    case Op::changed:
    case Op::event:
      return with_event_ && position_ > 0 && happens(term);
    default:
      return compare(term);
  }
}

bool Probe::compare(const Term& term) {
  if (part(term.left).type != ValueType::number) return same(term) == (term.op == Op::equal);
  const Number left = number(part(term.left)), right = number(part(term.right));
  const auto by = [&](auto a, auto b) {
    switch (term.op) {
      case Op::equal:
        return a == b;
      case Op::unequal:
        return a != b;
      case Op::less:
        return a < b;
      case Op::at_most:
        return a <= b;
      case Op::more:
        return a > b;
      default:
        return a >= b;
    }
  };
  return left.raw && right.raw ? by(*left.raw, *right.raw) : by(left.value, right.value);
}

bool Probe::same(const Term& term) {
  const Term &left = part(term.left), &right = part(term.right);
  return left.type == ValueType::cell ? cell(left) == cell(right) : truth(left) == truth(right);
}

Probe::Number Probe::cost(std::uint64_t raw) const {
  const Cost cost{std::min(static_cast<std::int64_t>(raw), Cost::kInfinityRaw)};
  return {cost.to_double(), cost.raw};
}

Probe::Number Probe::number(const Term& term) {
  const auto key = [&](auto&& cost_in_queue) {
    const std::uint64_t held = raw(EventKind::queue, node_of(term));
    return cost(held == 0 ? static_cast<std::uint64_t>(Cost::kInfinityRaw) : cost_in_queue(held));
  };
  const auto count = [](std::uint64_t number) { return Number{static_cast<double>(number), {}}; };
  switch (term.op) {
    case Op::number_literal:
      return {term.number, {}};
    case Op::g:
      return cost(raw(EventKind::g, node_of(term)));
    case Op::rhs:
      return cost(raw(EventKind::rhs, node_of(term)));
    case Op::dist:
      return cost(raw(EventKind::dist, node_of(term)));
    case Op::k1:
      return key([](std::uint64_t held) { return held - 1; });
    case Op::k2:
      return key([&](std::uint64_t) {
        return std::min(raw(EventKind::g, node_of(term)), raw(EventKind::rhs, node_of(term)));
      });
    case Op::order:
      return count(raw(EventKind::visit, node_of(term)) & 0xFFFFFFFFu);
    case Op::times:
      return count(raw(EventKind::visit, node_of(term)) >> 32);
    case Op::km:
      return cost(raw(EventKind::scalar, static_cast<NodeId>(Scalar::km)));
    case Op::moves:
    case Op::replans:
      return count(raw(EventKind::scalar, static_cast<NodeId>(*scalar_of(term.op))));
    case Op::queue_size:
      return {static_cast<double>(state_.queue_size()), {}};
    case Op::expansions:
      return {static_cast<double>(expansions_), {}};
    case Op::line:
      return count(line());
    case Op::opposite:
      return {-number(part(term.left)).value, {}};
    default:
      break;
  }
  const double left = number(part(term.left)).value, right = number(part(term.right)).value;
  if (term.op == Op::plus) return {left + right, {}};
  if (term.op == Op::minus) return {left - right, {}};
  return {term.op == Op::product ? left * right : left / right, {}};
}

NodeId Probe::cell(const Term& term) {
  if (term.op == Op::cell_literal) return term.cell == kNowhere ? kNoNode : node_of(term);
  const auto scalar = scalar_of(term.op);
  const std::uint64_t held = scalar ? raw(EventKind::scalar, static_cast<NodeId>(*scalar))
                                    : raw(term.op == Op::lp ? EventKind::lp : EventKind::rp, node_of(term));
  return static_cast<NodeId>(held) - 1u;
}

bool Probe::happens(const Term& term) {
  const Event event = log_->event(position_ - 1);
  switch (term.op) {
    case Op::taken:
      return event.kind == EventKind::pop && event.node == node_of(term);
    case Op::taken_any:
      return event.kind == EventKind::pop;
    case Op::changed:
      return changes(part(term.left));
    default:
      return event_is(term.happening);
  }
}

/// Whether the latest event is the one that is asked for.
bool Probe::event_is(Happening happening) {
  const Event event = log_->event(position_ - 1);
  if (happening == Happening::invariant) return last_until(verdicts_.breaches, position_) == position_;
  if (happening == Happening::oracle) return last_until(verdicts_.disagreements, position_) == position_;
  if (!kinds_of(happening).has(event.kind)) return false;
  switch (happening) {
    case Happening::plan:
      return event.delta == 0;
    case Happening::replan:
      return event.delta != 0;
    case Happening::underconsistent:
      return values_ == SearchValues::lookahead && state_.g(event.node) < state_.rhs(event.node);
    case Happening::sight_failed:
      return event.delta >> 32 == 0;
    case Happening::no_path:
      return static_cast<PlanStatus>(event.delta) != PlanStatus::found;
    case Happening::blocked:  // on the goal it waits for the goal to move on
      return event.kind != EventKind::waiting ||
             raw(EventKind::scalar, static_cast<NodeId>(Scalar::goal)) != std::uint64_t{event.node} + 1;
    default:
      return true;
  }
}

/// Whether the latest event made a value another one.
bool Probe::changes(const Term& term) {
  const Event event = log_->event(position_ - 1);
  const auto scalar = scalar_of(term.op);
  const bool touched =
      scalar ? event.kind == EventKind::scalar && event.node == static_cast<NodeId>(*scalar)
             : kinds_of(term.op).has(event.kind) && (!is_of_vertex(term.op) || event.node == node_of(term));
  if (!touched) return false;
  const TermValue after = value(term);
  retreat();
  const TermValue before = value(term);
  advance();
  return after != before;
}

std::string value_text(const Grid2& lattice, const Term& term, const TermValue& value) {
  if (value.type == ValueType::cell) return node_text(lattice, value.node);
  if (value.type == ValueType::truth) return value.truth ? "true" : "false";
  const bool counts = (is_value(term.op) && !is_cost(term.op)) || term.op == Op::line;
  return decimal_text(value.number, counts ? 0 : 3);
}

std::string values_text(Probe& probe, const Grid2& lattice) {
  std::string text;
  for (const Term& term : values_read(probe.condition()))
    text += (text.empty() ? "" : ", ") + term_text(probe.condition(), term) + " is " +
            value_text(lattice, term, probe.value(term));
  return text;
}

}  // namespace replan
