#include "core/debug/condition.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/words.hpp"

namespace replan {
namespace {

using enum ValueType;

constexpr ConditionName kNames[] = {
    {Op::g, number, "g", "g(x, y)", "The vertex's cost to the goal (A*: from the start), as settled last."},
    {Op::rhs, number, "rhs", "rhs(x, y)", "The vertex's one-step lookahead of g. A* has none: inf."},
    {Op::dist, number, "dist", "dist(x, y)", "The vertex's clearance penalty."},
    {Op::k1, number, "k1", "k1(x, y)", "First part of the vertex's key in the open list U; inf outside it."},
    {Op::k2, number, "k2", "k2(x, y)", "Second part of the key, min(g, rhs); inf outside U."},
    {Op::order, number, "order", "order(x, y)",
     "Number of the vertex's latest expansion since its search began; 0 if never expanded."},
    {Op::times, number, "times", "times(x, y)", "How often the vertex was expanded."},
    {Op::lp, cell, "lp", "lp(x, y)", "The vertex's local parent, a cell or none."},
    {Op::rp, cell, "rp", "rp(x, y)", "The vertex's remote parent, a cell or none."},
    {Op::queued, truth, "queued", "queued(x, y)", "The vertex is in the open list U."},
    {Op::known, truth, "known", "known(x, y)", "The cell is an obstacle on the robot's map."},
    {Op::wall, truth, "wall", "wall(x, y)", "A wall stands there in the world, known or not."},
    {Op::consistent, truth, "consistent", "consistent(x, y)", "The vertex has g = rhs. With A* all have."},
    {Op::km, number, "km", "km", "What moves of the robot have added to new keys."},
    {Op::queue_size, number, "size", "size(U)", "How many vertices the open list U holds."},
    {Op::moves, number, "moves", "moves", "The robot's clock: its moves and waits so far."},
    {Op::replans, number, "replans", "replans", "How often it has replanned."},
    {Op::expansions, number, "expansions", "expansions", "Expansions so far, all plans together."},
    {Op::robot, cell, "robot", "robot", "Where the robot stands."},
    {Op::start, cell, "start", "start", "Where the present search plans from, s_start."},
    {Op::goal, cell, "goal", "goal", "Where it plans to, s_goal."},
    {Op::last, cell, "last", "last", "Where the robot was when km was raised last, s_last."},
    {Op::line, number, "line", "line",
     "The pseudo-code line that the run stands on; lines of Algorithm 1 have 100 added."},
    {Op::on_line, truth, "line", "line(n)", "The run stands on that pseudo-code line."},
    {Op::taken, truth, "taken", "taken(x, y)", "The vertex is taken from the open list U, now."},
    {Op::taken_any, truth, "taken", "taken", "Some vertex is taken from the open list U, now."},
    {Op::changed, truth, "changed", "changed(value)",
     "The value is written and becomes another, now: changed(g(3, 4)), changed(km)."},
    {Op::event, truth, "event", "event(name)", "Something happens, now; the names are below."},
};

constexpr HappeningName kHappenings[] = {
    {Happening::plan, "plan", "A first plan begins."},
    {Happening::replan, "replan", "A replan begins."},
    {Happening::underconsistent, "underconsistent", "A vertex with g < rhs is taken from U."},
    {Happening::sight_failed, "sight_failed", "A line of sight turns out to be blocked."},
    {Happening::no_path, "no_path", "A plan ends without a path."},
    {Happening::blocked, "blocked",
     "The robot cannot go on: it waits without a path, would run into an obstacle, or gives up."},
    {Happening::surprise, "surprise", "The world changes, by script or by hand."},
    {Happening::move, "move", "The robot enters a cell."},
    {Happening::arrival, "arrival", "The robot arrives at the goal."},
    {Happening::invariant, "invariant", "A law that the planner must keep is broken, if laws are checked."},
    {Happening::oracle, "oracle", "The oracle disagrees with a plan's cost, if it is asked."},
};

/// How tightly operators bind; a term that is none binds tightest.
int binding(Op op) {
  switch (op) {
    case Op::either:
      return 1;
    case Op::both:
      return 2;
    case Op::equal:
    case Op::unequal:
      return 3;
    case Op::less:
    case Op::at_most:
    case Op::more:
    case Op::at_least:
      return 4;
    case Op::plus:
    case Op::minus:
      return 5;
    case Op::product:
    case Op::quotient:
      return 6;
    case Op::negated:
    case Op::opposite:
      return 7;
    default:
      return 8;
  }
}

const char* symbol(Op op) {
  static constexpr const char* kSymbols[] = {"||", "&&", "==", "!=", "<", "<=", ">",
                                             ">=", "+",  "-",  "*",  "/", "!",  "-"};
  return kSymbols[static_cast<std::size_t>(op) - static_cast<std::size_t>(Op::either)];
}

/// The shortest digits that read back to the same number.
std::string literal_text(double value) {
  if (std::isinf(value)) return "inf";
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string leaf_text(const Condition& condition, const Term& term) {
  const auto name = std::find_if(std::begin(kNames), std::end(kNames),
                                 [&](const ConditionName& each) { return each.op == term.op; });
  switch (term.op) {
    case Op::number_literal:
      return literal_text(term.number);
    case Op::truth_literal:
      return term.truth ? "true" : "false";
    case Op::cell_literal:
      return term.cell == kNowhere ? "none" : cell_text(term.cell);
    case Op::on_line:
      return "line(" + literal_text(term.number) + ")";
    case Op::changed:
      return "changed(" + term_text(condition, condition.terms[term.left]) + ")";
    case Op::event:
      return "event(" + std::string(kHappenings[static_cast<std::size_t>(term.happening)].name) + ")";
    default:
      return is_of_vertex(term.op) || term.op == Op::taken ? std::string(name->name) + cell_text(term.cell)
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
  if (bound == 8) return leaf_text(condition, term);
  // Chains read from the left: what stands to the right of its equal needs parentheses.
  const auto part = [&](std::uint16_t index, int least) {
    const Term& inner = condition.terms[index];
    const std::string text = term_text(condition, inner);
    return binding(inner.op) < least ? "(" + text + ")" : text;
  };
  if (bound == 7) return symbol(term.op) + part(term.left, bound);
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

std::span<const ConditionName> condition_names() {
  return kNames;
}

std::span<const HappeningName> happening_names() {
  return kHappenings;
}

bool is_value(Op op) {
  return op >= Op::g && op <= Op::last;
}

bool is_of_vertex(Op op) {
  return op >= Op::g && op <= Op::consistent;
}

bool is_cost(Op op) {
  return op == Op::g || op == Op::rhs || op == Op::dist || op == Op::k1 || op == Op::k2 || op == Op::km;
}

}  // namespace replan
