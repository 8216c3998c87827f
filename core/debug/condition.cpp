#include "core/debug/condition.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/real_text.hpp"
#include "core/base/words.hpp"
#include "core/debug/condition_operators.hpp"

namespace replan {
namespace {

/// How tightly a term binds.
int binding(Op op) {
  for (const ConditionOperator& each : kConditionOperators)
    if (each.op == op) return each.level;
  return op == Op::negated || op == Op::opposite ? kUnaryLevel : kLeafLevel;
}

std::string symbol(Op op) {
  for (const ConditionOperator& each : kConditionOperators)
    if (each.op == op) return std::string(each.symbol);
  return op == Op::negated ? "!" : "-";
}

/// The shortest digits that read back to the same number.
std::string literal_text(double value) {
  return std::isinf(value) ? "inf" : real_text(value);
}

std::string vertex_in_parentheses(const Term& term) {
  return "(" + literal_text(term.number) + ")";
}

std::string leaf_text(const Condition& condition, const Term& term) {
  const auto names = condition_names();
  const auto name =
      std::find_if(names.begin(), names.end(), [&](const ConditionName& each) { return each.op == term.op; });
  switch (term.op) {
    case Op::number_literal:
      return literal_text(term.number);
    case Op::truth_literal:
      return term.truth ? "true" : "false";
    case Op::cell_literal:
      return term.cell == kNowhere ? "none" : cell_text(term.cell, condition.solid);
    case Op::on_line:
      return "line(" + literal_text(term.number) + ")";
    case Op::changed:
      return "changed(" + term_text(condition, condition.terms[term.left]) + ")";
    case Op::event:
      return "event(" + std::string(happening_names()[static_cast<std::size_t>(term.happening)].name) + ")";
    case Op::own_cost:
    case Op::own_count:
    case Op::own_cell:
      return std::string(term.field) + cell_text(term.cell, condition.solid);
    case Op::tree_cost:
    case Op::tree_count:
      return std::string(term.field) + vertex_in_parentheses(term);
    case Op::rewired:
      return "rewired" + vertex_in_parentheses(term);
    default:
      return is_of_vertex(term.op) || term.op == Op::taken
                 ? std::string(name->name) + cell_text(term.cell, condition.solid)
                 : std::string(name->form);
  }
}

}  // namespace

bool Condition::uses(Op op) const {
  return std::any_of(terms.begin(), terms.end(), [op](const Term& term) { return term.op == op; });
}

bool Condition::uses(Happening happening) const {
  return std::any_of(terms.begin(), terms.end(), [happening](const Term& term) {
    return term.op == Op::event && term.happening == happening;
  });
}

std::string expression_text(const Condition& condition) {
  return term_text(condition, condition.root());
}

std::string term_text(const Condition& condition, const Term& term) {
  const int bound = binding(term.op);
  if (bound == kLeafLevel) return leaf_text(condition, term);
  // Chains read from the left: what stands to the right of its equal needs parentheses.
  const auto part = [&](std::uint16_t index, int least) {
    const Term& inner = condition.terms[index];
    const std::string text = term_text(condition, inner);
    return binding(inner.op) < least ? "(" + text + ")" : text;
  };
  if (bound == kUnaryLevel) return symbol(term.op) + part(term.left, bound);
  return part(term.left, bound) + " " + symbol(term.op) + " " + part(term.right, bound + 1);
}

std::vector<Term> values_read(const Condition& condition) {
  std::vector<Term> values;
  for (const Term& term : condition.terms)
    if ((is_value(term.op) || term.op == Op::line) &&
        std::find(values.begin(), values.end(), term) == values.end())
      values.push_back(term);
  return values;
}

bool is_value(Op op) {
  return op >= Op::g && op <= Op::generation;
}

bool is_of_vertex(Op op) {
  return op >= Op::g && op <= Op::own_cell;
}

bool is_of_tree(Op op) {
  return op == Op::tree_cost || op == Op::tree_count || op == Op::rewired;
}

bool is_cost(Op op) {
  return op == Op::g || op == Op::rhs || op == Op::dist || op == Op::k1 || op == Op::k2 ||
         op == Op::own_cost || op == Op::tree_cost || op == Op::km || op == Op::best;
}

}  // namespace replan
