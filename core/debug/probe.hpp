// Looks a log through for the positions at which a condition stops, in either direction.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/debug/condition.hpp"
#include "core/debug/log_view.hpp"
#include "core/trace/expansions.hpp"

namespace replan {

/// Positions at which checkers of the log found something wrong, ascending, as far as they have come.
struct Verdicts {
  std::span<const std::size_t> breaches;       ///< of event(invariant)
  std::span<const std::size_t> disagreements;  ///< of event(oracle)
};

/// A value as a term has it at some position.
struct TermValue {
  ValueType type = ValueType::number;
  double number = 0;  ///< infinite costs are the double's infinity
  bool truth = false;
  NodeId node = kNoNode;  ///< of a cell; kNoNode is none
  friend bool operator==(const TermValue&, const TermValue&) = default;
};

/// Stands at a position of a log, knows what an expression says there, and walks to where it stops.
///
/// A stop is a position p at which the condition holds and either did not hold at p - 1, or holds only by
/// grace of the event before p (taken, changed, event): such a stop is one however often it comes in a row.
///
/// Walking goes over the events and looks at those alone that the expression reads. Cost of a new probe: a
/// state_at(), and a count of the expansions before the position if they are read and not given.
class Probe {
 public:
  /// The log of `view` may grow while the probe lives; it must not be cut before the probe's position. Log
  /// and lattice outlive it. The expression must have been read for the lattice's size.
  Probe(const LogView& view, Condition condition, std::size_t position, Verdicts verdicts = {},
        std::optional<std::int64_t> expansions_before = {});

  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] const Condition& condition() const { return condition_; }
  /// Checkers have come farther.
  void set_verdicts(Verdicts verdicts) { verdicts_ = verdicts; }

  /// What the expression (or one of its terms) is here.
  [[nodiscard]] TermValue value() { return value(condition_.root()); }
  [[nodiscard]] TermValue value(const Term& term);

  /// Goes to the first stop after the position, or to `limit` (at most the log's size) if there is none until
  /// then. Long ways can be gone piecewise.
  std::optional<std::size_t> forwards(std::size_t limit);
  /// Goes to the last stop before the position that is not before `limit`, or to `limit` if there is none.
  std::optional<std::size_t> backwards(std::size_t limit);
  /// Goes on to the next position, at most `limit`, where something was written that the expression reads:
  /// before it the value is the same. True if that was so, false at `limit`.
  bool next_change(std::size_t limit);

 private:
  struct Slot {
    NodeId node;
    EventKind kind;
    std::uint64_t raw;
    friend auto operator<=>(const Slot&, const Slot&) = default;
  };
  struct Number {
    double value = 0;
    std::optional<std::int64_t> raw;  // of a cost
  };

  /// What an epoch makes initial again.
  [[nodiscard]] KindSet forgotten() const { return log_->head().forgotten(); }
  void collect(const Term& term);
  void collect_slot(EventKind kind, NodeId node);
  void load(std::optional<std::int64_t> expansions_before);
  [[nodiscard]] NodeId node_of(const Term& term) const;
  [[nodiscard]] Slot* find_slot(EventKind kind, NodeId node);
  [[nodiscard]] std::uint64_t raw(EventKind kind, NodeId node) { return find_slot(kind, node)->raw; }

  [[nodiscard]] bool is_interesting(std::size_t index) const;
  [[nodiscard]] std::size_t next_interesting(std::size_t from, std::size_t limit) const;
  [[nodiscard]] std::size_t interesting_before(std::size_t end, std::size_t limit) const;
  bool cross(const Event& event);
  bool cross_epoch(const Event& epoch);
  void read_values();
  bool advance();
  void retreat();
  [[nodiscard]] bool stops_here();

  [[nodiscard]] bool holds(bool with_event) {
    with_event_ = with_event;
    const bool result = truth(condition_.root());
    with_event_ = true;
    return result;
  }
  [[nodiscard]] bool truth(const Term& term);
  [[nodiscard]] bool compare(const Term& term);
  [[nodiscard]] bool same(const Term& term);
  [[nodiscard]] Number number(const Term& term);
  [[nodiscard]] Number cost(std::uint64_t raw) const;
  [[nodiscard]] NodeId cell(const Term& term);
  [[nodiscard]] std::uint64_t own(const Term& term, std::uint64_t otherwise);
  [[nodiscard]] Number tree_count(const Term& term);
  [[nodiscard]] bool happens(const Term& term);
  [[nodiscard]] bool event_is(Happening happening);
  [[nodiscard]] bool changes(const Term& value);
  [[nodiscard]] bool is_stop(bool now, bool before) { return now && (!before || (pulses_ && !holds(false))); }
  /// The line of the event before an index; 0 at the beginning.
  [[nodiscard]] std::uint8_t line_before(std::size_t index) const {
    return index == 0 ? std::uint8_t{0} : log_->event(index - 1).line;
  }
  [[nodiscard]] std::uint8_t line() const { return line_before(position_); }
  [[nodiscard]] const Term& part(std::uint16_t index) const { return condition_.terms[index]; }

  const Timeline* log_;
  const Box* lattice_;
  const SearchValues* values_;
  Condition condition_;
  Verdicts verdicts_;
  std::size_t position_ = 0;

  // What is read, and thereby which events matter.
  std::vector<Slot> slots_;       // values of vertices and of the run, in order
  std::uint64_t slot_nodes_ = 0;  // the low six bits of the nodes in them
  KindSet slot_kinds_;            // kinds in them
  KindSet walked_;                // kinds whose values of all vertices are needed
  KindSet noted_;                 // kinds of events that are asked about themselves
  bool reads_line_ = false;
  bool pulses_ = false;  // something is true only at its event
  bool reads_breaches_ = false, reads_disagreements_ = false;

  // What is known at the position.
  SearchState state_;  // only the walked kinds are kept up
  std::int64_t expansions_ = 0;
  bool with_event_ = true;  // whether what is about the latest event counts
};

/// A value in words: "31.400", "∞", "(3, 4)", "none", "true".
std::string value_text(const Box& lattice, const Term& term, const TermValue& value);
/// What the expression reads at the probe's position, each once: "g(12, 40) is 31.400, km is 0.000". Empty if
/// it reads no values.
std::string values_text(Probe& probe, const Box& lattice);

}  // namespace replan
