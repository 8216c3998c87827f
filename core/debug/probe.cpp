#include "core/debug/probe.hpp"

#include <algorithm>

#include "core/debug/condition_reads.hpp"

namespace replan {
namespace {

constexpr std::uint64_t node_bit(NodeId node) {
  return std::uint64_t{1} << (node & 63u);
}

/// Calls `each` for the kinds in a set.
template <class Each>
void for_kinds(KindSet kinds, Each each) {
  for (int kind = 0; kind < kFirstOwnField + kOwnFields; ++kind)
    if (kinds.has(static_cast<EventKind>(kind))) each(static_cast<EventKind>(kind));
}

/// The first of ascending positions that is greater.
std::size_t first_after(std::span<const std::size_t> positions, std::size_t position) {
  const auto found = std::upper_bound(positions.begin(), positions.end(), position);
  return found == positions.end() ? SIZE_MAX : *found;
}
}  // namespace

Probe::Probe(const LogView& view, Condition condition, std::size_t position, Verdicts verdicts,
             std::optional<std::int64_t> expansions_before)
    : log_(&view.log),
      lattice_(&view.lattice),
      values_(&view.info.values),
      condition_(std::move(condition)),
      verdicts_(verdicts),
      position_(position) {
  for (const Term& term : condition_.terms) collect(term);
  load(expansions_before);
}

/// Notes what a term reads.
void Probe::collect(const Term& term) {
  const bool asks = term.op == Op::event || term.op == Op::changed || term.op == Op::taken ||
                    term.op == Op::taken_any || term.op == Op::rewired;
  pulses_ |= asks;
  reads_line_ |= term.op == Op::line || term.op == Op::on_line;
  if (is_of_vertex(term.op) || is_of_tree(term.op))
    for_kinds(kinds_of(term, *values_), [&](EventKind kind) { collect_slot(kind, node_of(term)); });
  if (const auto scalar = scalar_of(term.op)) collect_slot(EventKind::scalar, static_cast<NodeId>(*scalar));
  if (term.op == Op::queue_size) walked_.add(EventKind::queue);
  if (term.op == Op::expansions || term.op == Op::samples) noted_.add(EventKind::visit);
  if (term.op == Op::taken || term.op == Op::taken_any) noted_.add(EventKind::pop);
  if (term.op == Op::rewired) noted_.add(EventKind::rewired);
  if (term.op != Op::event) return;
  for_kinds(kinds_of(term.happening), [&](EventKind kind) { noted_.add(kind); });
  reads_breaches_ |= term.happening == Happening::invariant;
  reads_disagreements_ |= term.happening == Happening::oracle;
  if (term.happening == Happening::blocked)
    for (const Scalar goal : {Scalar::goal, Scalar::wanted})
      collect_slot(EventKind::scalar, static_cast<NodeId>(goal));
  if (term.happening == Happening::first_path)
    collect_slot(EventKind::scalar, static_cast<NodeId>(Scalar::best));
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
  if (expansions_before)
    expansions_ = *expansions_before;
  else if (condition_.counts_expansions())
    for (std::size_t i = 0; i < position_; ++i)
      expansions_ += log_->event(i).kind == EventKind::visit ? 1 : 0;
  read_values();
}

void Probe::read_values() {
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
  return is_of_tree(term.op) ? static_cast<NodeId>(term.number) : lattice_->node(term.cell);
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
  if (event.kind == EventKind::epoch && (slot_kinds_.meets(forgotten()) || walked_.meets(forgotten())))
    return true;
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

/// Takes the values over an epoch, forwards: those that it forgets are what they were at first.
bool Probe::cross_epoch(const Event& epoch) {
  for (Slot& slot : slots_)
    if (forgotten().has(slot.kind)) slot.raw = log_->head().initial_value(slot.kind);
  if (!walked_.empty()) state_.apply(epoch);
  return slot_kinds_.meets(forgotten()) || walked_.meets(forgotten());
}

/// One event on. False if nothing happened that the expression could see.
bool Probe::advance() {
  const std::size_t index = position_++;
  const Event event = log_->event(index);
  bool seen = event.kind == EventKind::epoch ? cross_epoch(event) : cross(event);
  if (event.kind == EventKind::visit) ++expansions_;
  if (reads_line_) seen |= log_->event(index).line != (index == 0 ? 0 : log_->event(index - 1).line);
  return seen || reads_breaches_ || reads_disagreements_;
}

void Probe::retreat() {
  const std::size_t index = --position_;
  const Event event = log_->event(index);
  if (event.kind == EventKind::epoch)
    read_values();  // what was forgotten is not in the log
  else
    cross(event);
  if (event.kind == EventKind::visit) --expansions_;
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

}  // namespace replan
