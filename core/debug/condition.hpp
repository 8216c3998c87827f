// The language of breakpoints and watches: small typed expressions over what a run has recorded.
//
//   g(12, 40) > 30 || km > 5 && size(U) >= 100
//   taken(3, 4) && rp(3, 4) != none
//   changed(rhs(3, 4))          event(replan)          line(48)
//
// In a world of more than one layer cells have three coordinates: g(12, 40, 2).
// Operators bind as in C: || && == != < <= > >= + - * / and unary ! -. What is about an event is true only at
// that event; everything else holds for as long as the values say so.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"
#include "core/lattice/box.hpp"
#include "core/plan/registry.hpp"

namespace replan {

enum class ValueType : std::uint8_t { number, truth, cell };

/// What a term of an expression is.
enum class Op : std::uint8_t {
  // Written out
  number_literal,
  truth_literal,
  cell_literal,  ///< kNowhere for `none`
  // Values of a vertex: costs, counts, parents, truths
  g,
  rhs,
  dist,
  k1,
  k2,
  order,
  times,
  lp,
  rp,
  queued,
  known,
  wall,
  consistent,
  own_cost,  ///< of a planner's own: Term::field says which
  own_count,
  own_cell,
  // Values of a vertex of a tree, by its number: Term::field says which
  tree_cost,
  tree_count,
  // Values of the run
  km,
  queue_size,
  moves,
  replans,
  expansions,
  samples,  ///< the same of a planner that draws samples; 0 of others
  robot,
  start,
  goal,
  last,
  sub_goal,
  admissible,
  score,
  best,
  vertices,
  generation,
  line,
  // About the latest event
  on_line,
  taken,
  taken_any,
  rewired,
  changed,
  event,
  // Made of other terms
  either,
  both,
  equal,
  unequal,
  less,
  at_most,
  more,
  at_least,
  plus,
  minus,
  product,
  quotient,
  negated,
  opposite,
};

/// What event(NAME) asks for.
enum class Happening : std::uint8_t {
  plan,
  replan,
  underconsistent,
  sight_failed,
  first_path,
  rewired,
  no_path,
  blocked,
  surprise,
  move,
  arrival,
  invariant,
  oracle,
};

inline constexpr Cell kNowhere{-1, -1};

/// One term; those that it is made of stand before it.
struct Term {
  Op op = Op::number_literal;
  ValueType type = ValueType::number;
  Happening happening = Happening::plan;  ///< of Op::event
  bool truth = false;                     ///< of Op::truth_literal
  std::uint16_t left = 0, right = 0;      ///< the only one is `left`
  double number = 0;            ///< of Op::number_literal; the line of Op::on_line; the vertex of a tree
  Cell cell = {0, 0};           ///< of Op::cell_literal and of values of a vertex
  std::string_view field = {};  ///< of a planner's own value: its name
  friend bool operator==(const Term&, const Term&) = default;
};

/// An expression that was read: its terms, the last one the whole.
struct Condition {
  std::vector<Term> terms;
  bool solid = false;  ///< its cells have three coordinates

  [[nodiscard]] const Term& root() const { return terms.back(); }
  [[nodiscard]] bool uses(Op op) const;
  [[nodiscard]] bool uses(Happening happening) const;
  /// Whether it asks for expansions, under whatever name.
  [[nodiscard]] bool counts_expansions() const { return uses(Op::expansions) || uses(Op::samples); }
  friend bool operator==(const Condition&, const Condition&) = default;
};

/// The most terms of an expression, how deep they may be nested, and the longest text.
inline constexpr std::size_t kMostTerms = 200;
inline constexpr int kDeepestNesting = 64;
inline constexpr std::size_t kLongestExpression = 16384;

/// Reads an expression of any type about a run in `world`, whose cells it may name. Errors give the character, counted from 1, and the mend:
/// "character 1: 'g' needs a cell: g(x, y)". What planners keep for each vertex of their own may be named too; where
/// a planner has no such value it is 0, infinite or none.
Result<Condition> parse_expression(std::string_view text, const Box& world,
                                   std::span<const Field> own = own_fields());
/// Reads one that is true or false, for a breakpoint.
Result<Condition> parse_condition(std::string_view text, const Box& world,
                                  std::span<const Field> own = own_fields());
/// Reads one that is a number, for a watch.
Result<Condition> parse_quantity(std::string_view text, const Box& world,
                                 std::span<const Field> own = own_fields());

/// The expression in its one spelling, which reads back to an equal one.
std::string expression_text(const Condition& condition);
/// The same of one of its terms.
std::string term_text(const Condition& condition, const Term& term);

/// The values that an expression reads, each once: what is shown beside it.
std::vector<Term> values_read(const Condition& condition);

/// A name of the language, for help and completion.
struct ConditionName {
  Op op;
  ValueType type;
  std::string_view name;  ///< "g"
  std::string_view form;  ///< "g(x, y)"; in space see form_text()
  std::string_view help;  ///< one sentence
};
std::span<const ConditionName> condition_names();
/// How a name is written in a world: "g(x, y, z)" where that has more than one layer.
std::string form_text(std::string_view form, bool solid);

/// A name that event() takes.
struct HappeningName {
  Happening happening;
  std::string_view name;  ///< "sight_failed"
  std::string_view help;  ///< one sentence
};
std::span<const HappeningName> happening_names();

/// Values that an expression reads from the run and that can be shown beside it: the terms that changed() may
/// ask about.
[[nodiscard]] bool is_value(Op op);
/// Values of one vertex.
[[nodiscard]] bool is_of_vertex(Op op);
/// What is about a vertex of a tree.
[[nodiscard]] bool is_of_tree(Op op);
/// Path costs, which are compared exactly with one another.
[[nodiscard]] bool is_cost(Op op);

}  // namespace replan
