// What the terms of an expression are where its probe stands.
#include <algorithm>
#include <limits>

#include "core/debug/condition_reads.hpp"
#include "core/debug/event_words.hpp"
#include "core/debug/probe.hpp"

namespace replan {

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
      return !values_->lookahead() || raw(EventKind::g, node_of(term)) == raw(EventKind::rhs, node_of(term));
    case Op::on_line:
      return line() == term.number;
    case Op::taken:
    case Op::taken_any:
    case Op::rewired:
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

/// A value of the planner's own, or what stands for one that it has not.
std::uint64_t Probe::own(const Term& term, std::uint64_t otherwise) {
  const Field* field = values_->find(term.field);
  return field == nullptr ? otherwise : raw(field->kind, node_of(term));
}

/// A count of a vertex of a tree; of one that it hangs on its number, infinite where there is none.
Probe::Number Probe::tree_count(const Term& term) {
  const Field* field = values_->find(term.field);
  const std::uint64_t held = own(term, 0);
  if (field == nullptr || field->type != FieldType::vertex) return {static_cast<double>(held), {}};
  return {held == 0 ? std::numeric_limits<double>::infinity() : static_cast<double>(held - 1), {}};
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
    case Op::own_cost:
    case Op::tree_cost:
      return cost(own(term, fields::kInfinite));
    case Op::own_count:
      return count(own(term, 0));
    case Op::tree_count:
      return tree_count(term);
    case Op::order:
      return count(raw(EventKind::visit, node_of(term)) & 0xFFFFFFFFu);
    case Op::times:
      return count(raw(EventKind::visit, node_of(term)) >> 32);
    case Op::km:
      return cost(raw(EventKind::scalar, static_cast<NodeId>(Scalar::km)));
    case Op::best: {
      const std::uint64_t held = raw(EventKind::scalar, static_cast<NodeId>(Scalar::best));
      return cost(held == 0 ? fields::kInfinite : held);
    }
    case Op::moves:
    case Op::replans:
    case Op::vertices:
    case Op::generation:
      return count(raw(EventKind::scalar, static_cast<NodeId>(*scalar_of(term.op))));
    case Op::admissible: {
      const std::uint64_t held = raw(EventKind::scalar, static_cast<NodeId>(Scalar::admissible));
      return held == 0 ? Number{std::numeric_limits<double>::infinity(), {}} : count(held - 1);
    }
    case Op::score:
      return {score_of(raw(EventKind::scalar, static_cast<NodeId>(Scalar::score))), {}};
    case Op::queue_size:
      return {static_cast<double>(state_.queue_size()), {}};
    case Op::expansions:
      return {static_cast<double>(expansions_), {}};
    case Op::samples:
      return {values_->grows() ? static_cast<double>(expansions_) : 0, {}};
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
  if (term.op == Op::own_cell) return static_cast<NodeId>(own(term, 0)) - 1u;
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
    case Op::rewired:
      return event.kind == EventKind::rewired && event.node == node_of(term);
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
      return values_->lookahead() && state_.g(event.node) < state_.rhs(event.node);
    case Happening::sight_failed:
      return event.delta >> 32 == 0;
    case Happening::first_path: {  // from none, which is 0
      const auto best = static_cast<NodeId>(Scalar::best);
      return event.node == best && event.delta == raw(EventKind::scalar, best);
    }
    case Happening::no_path:
      return !has_path(static_cast<PlanStatus>(event.delta));
    case Happening::blocked: {  // on the goal it waits for the goal to move on
      const std::uint64_t wanted = raw(EventKind::scalar, static_cast<NodeId>(Scalar::wanted));
      const std::uint64_t goal = raw(EventKind::scalar, static_cast<NodeId>(Scalar::goal));
      return event.kind != EventKind::waiting ||
             (wanted != 0 ? wanted : goal) != std::uint64_t{event.node} + 1;
    }
    default:
      return true;
  }
}

/// Whether the latest event made a value another one.
bool Probe::changes(const Term& term) {
  const Event event = log_->event(position_ - 1);
  const auto scalar = scalar_of(term.op);
  const KindSet kinds = kinds_of(term, *values_);
  const bool about_node = is_of_vertex(term.op) || is_of_tree(term.op);
  const bool touched = scalar ? event.kind == EventKind::scalar && event.node == static_cast<NodeId>(*scalar)
                              : (kinds.has(event.kind) && (!about_node || event.node == node_of(term))) ||
                                    (event.kind == EventKind::epoch && kinds.meets(forgotten()));
  if (!touched) return false;
  const TermValue after = value(term);
  retreat();
  const TermValue before = value(term);
  advance();
  return after != before;
}

std::string value_text(const Box& lattice, const Term& term, const TermValue& value) {
  if (value.type == ValueType::cell) return node_text(lattice, value.node);
  if (value.type == ValueType::truth) return value.truth ? "true" : "false";
  const bool counts = (is_value(term.op) && !is_cost(term.op) && term.op != Op::score) || term.op == Op::line;
  return decimal_text(value.number, counts ? 0 : 3);
}

std::string values_text(Probe& probe, const Box& lattice) {
  std::string text;
  for (const Term& term : values_read(probe.condition()))
    text += (text.empty() ? "" : ", ") + term_text(probe.condition(), term) + " is " +
            value_text(lattice, term, probe.value(term));
  return text;
}

}  // namespace replan
