// Reads expressions by descending through the operators' levels. One pass: each part is checked for its type
// as soon as it is read, so that an error points at the first thing that is wrong.
#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "core/base/words.hpp"
#include "core/debug/condition.hpp"
#include "core/debug/condition_operators.hpp"
#include "core/debug/condition_scanner.hpp"
#include "core/lattice/box_words.hpp"
#include "core/plan/parameters.hpp"

namespace replan {
namespace {

constexpr const char* kTypeWords[] = {"a number", "a truth", "a cell"};

const char* words(ValueType type) {
  return kTypeWords[static_cast<std::size_t>(type)];
}

class ConditionParser {
 public:
  ConditionParser(std::string_view text, const Box& world, std::span<const Field> own)
      : in_(text), world_(world), own_(own) {
    condition_.solid = world.solid();
  }

  Result<Condition> read(std::optional<ValueType> wanted) {
    if (in_.rest().size() > kLongestExpression)
      return Error{"the expression is too long: at most " + std::to_string(kLongestExpression) +
                   " characters"};
    in_.skip_blanks();
    if (in_.at_end()) return Error{"character 1: an expression is missing: for example km > 5"};
    const auto root = level(1);
    in_.skip_blanks();
    if (root && !in_.at_end()) in_.fail_unexpected();
    if (root && wanted && type(*root) != *wanted)
      in_.fail(0, *wanted == ValueType::truth
                      ? "a breakpoint needs a truth, this is " + std::string(words(type(*root))) +
                            ": compare it, as in km > 5"
                      : "a watch needs a number, this is " + std::string(words(type(*root))) +
                            ": name a value, as in km or size(U)");
    if (!in_.error().empty()) return Error{in_.error()};
    return std::move(condition_);
  }

 private:
  using Index = std::optional<std::uint16_t>;  // nothing after an error

  Index failed(std::size_t at, const std::string& what) {
    in_.fail(at, what);
    return std::nullopt;
  }

  [[nodiscard]] ValueType type(std::uint16_t index) const { return condition_.terms[index].type; }
  Index add(std::size_t at, Term term) {
    if (condition_.terms.size() >= kMostTerms)
      return failed(at, "the expression is too long: at most " + std::to_string(kMostTerms) + " terms");
    condition_.terms.push_back(term);
    return static_cast<std::uint16_t>(condition_.terms.size() - 1);
  }

  const ConditionOperator* operator_at(int level) {
    in_.skip_blanks();
    for (const ConditionOperator& each : kConditionOperators)
      if (in_.rest().starts_with(each.symbol)) return each.level == level ? &each : nullptr;
    return nullptr;
  }

  /// Operands of one level, joined from the left.
  Index level(int number) {
    if (number == kUnaryLevel) return unary();
    const std::size_t begin = in_.skip_blanks();
    Index left = level(number + 1);
    while (left) {
      const ConditionOperator* found = operator_at(number);
      if (found == nullptr) break;
      const std::size_t sign = in_.at();
      in_.advance(found->symbol.size());
      const std::size_t right_begin = in_.skip_blanks();
      const Index right = level(number + 1);
      if (!right) return std::nullopt;
      left = join(*found, sign, *left, begin, *right, right_begin);
    }
    return left;
  }

  Index join(const ConditionOperator& each, std::size_t sign, std::uint16_t left, std::size_t left_begin,
             std::uint16_t right, std::size_t right_begin) {
    const std::string name = "'" + std::string(each.symbol) + "'";
    if (each.level == kEqualityLevel) {
      if (type(left) != type(right))
        return failed(sign, name + " compares two of a kind: left of it is " + words(type(left)) +
                                ", right of it " + words(type(right)));
    } else {
      if (type(left) != each.operand) return wrong_operand(name, each, left_begin, type(left), "left");
      if (type(right) != each.operand) return wrong_operand(name, each, right_begin, type(right), "right");
    }
    return add(sign, {.op = each.op, .type = each.result, .left = left, .right = right});
  }
  Index wrong_operand(const std::string& name, const ConditionOperator& each, std::size_t at, ValueType is,
                      const char* side) {
    const bool comparable = each.operand == ValueType::truth && is == ValueType::number;
    return failed(at, name + " needs " + words(each.operand) + " on its " + side + ", this is " + words(is) +
                          (comparable ? ": compare it, as in km > 5" : ""));
  }

  Index unary() {
    const std::size_t begin = in_.skip_blanks();
    if (depth_ >= kDeepestNesting)
      return failed(begin, "nested too deeply: at most " + std::to_string(kDeepestNesting) + " levels");
    ++depth_;
    const Index read = in_.next_is('!') || in_.next_is('-') ? prefixed(begin) : primary();
    --depth_;
    return read;
  }

  Index prefixed(std::size_t begin) {
    const bool denies = in_.here() == '!';
    in_.advance(1);
    const Index inner = unary();
    if (!inner) return std::nullopt;
    if (type(*inner) != (denies ? ValueType::truth : ValueType::number))
      return failed(begin, denies ? std::string("'!' needs a truth, this is ") + words(type(*inner)) +
                                        ": put what is denied in parentheses, as in !(km > 5)"
                                  : std::string("'-' needs a number, this is ") + words(type(*inner)));
    return add(begin, {.op = denies ? Op::negated : Op::opposite, .type = type(*inner), .left = *inner});
  }

  Index primary() {
    if (in_.at_end()) return failed(in_.at(), "the expression ends too soon: a value is missing");
    if (in_.here() == '(') return parentheses();
    if (in_.at_digit() || in_.here() == '.') return number_literal();
    if (in_.at_letter()) return named();
    if (in_.here() == ')') return failed(in_.at(), "a value is missing before this ')'");
    return failed(in_.at(), in_.shown() + " is not expected here: a value such as km is missing");
  }

  /// A cell, "(12, 40)", or an expression in parentheses.
  Index parentheses() {
    const std::size_t begin = in_.at();
    if (looks_like_cell()) {
      const auto where = cell("a cell", form_text("(x, y)", world_.solid()));
      return where ? add(begin, {.op = Op::cell_literal, .type = ValueType::cell, .cell = *where})
                   : std::nullopt;
    }
    in_.advance(1);
    const Index inner = level(1);
    if (!inner) return std::nullopt;
    if (!in_.take(')')) return failed(begin, "this '(' is not closed: a ')' is missing");
    return inner;
  }
  [[nodiscard]] bool looks_like_cell() const {
    const std::size_t after = in_.rest().find_first_not_of("0123456789- \t", 1);
    return after != std::string_view::npos && in_.rest()[after] == ',';
  }

  Index number_literal() {
    const std::size_t begin = in_.at();
    const auto value = in_.take_number();
    if (!value) return failed(begin, "this is no number that can be held: write for example 2.5");
    if (in_.at_letter() || in_.here() == '.')
      return failed(begin, "a number goes on in letters here: write for example 2.5");
    return add(begin, {.op = Op::number_literal, .number = *value});
  }

  Index named() {
    const std::size_t begin = in_.at();
    const std::string_view name = in_.take_name();
    if (name == "inf")
      return add(begin, {.op = Op::number_literal, .number = std::numeric_limits<double>::infinity()});
    if (name == "true" || name == "false")
      return add(begin, {.op = Op::truth_literal, .type = ValueType::truth, .truth = name == "true"});
    if (name == "none")
      return add(begin, {.op = Op::cell_literal, .type = ValueType::cell, .cell = kNowhere});
    const auto names = condition_names();
    const bool called = in_.next_is('(');
    // 'line' and 'taken' are two names each: with something in parentheses, and without.
    const auto fits = [&](const ConditionName& each) {
      return each.name == name && (each.form.find('(') != std::string_view::npos) == called;
    };
    for (const Field& field : own_)
      if (field.name == name) return own_value(begin, field);
    const auto same = [&](const ConditionName& each) { return each.name == name; };
    auto found = std::find_if(names.begin(), names.end(), fits);
    if (found != names.end()) return known_name(begin, *found);
    found = std::find_if(names.begin(), names.end(), same);
    if (found == names.end()) return unknown_name(begin, name);
    if (called) return failed(in_.at(), "'" + std::string(name) + "' takes nothing in parentheses");
    return failed(begin, "'" + std::string(name) + "' needs " +
                             (is_of_vertex(found->op) ? "a cell: " : "what it is about: ") +
                             form_text(found->form, world_.solid()));
  }

  /// A value that some planner keeps of its own.
  Index own_value(std::size_t begin, const Field& field) {
    if (field.table == FieldTable::vertices) return tree_value(begin, field);
    const bool cost = field.type == FieldType::cost, leads = field.type == FieldType::node;
    Term term{.op = cost    ? Op::own_cost
                    : leads ? Op::own_cell
                            : Op::own_count,
              .type = leads ? ValueType::cell : ValueType::number};
    const auto where = cell("'" + std::string(field.name) + "'",
                            form_text(std::string(field.name) + "(x, y)", world_.solid()));
    if (!where) return std::nullopt;
    term.cell = *where;
    term.field = field.name;
    return add(begin, term);
  }

  Index tree_value(std::size_t begin, const Field& field) {
    const auto vertex = whole_in_parentheses(kMostVertices - 1);
    if (!vertex) return no_vertex(begin, field.name);
    return add(begin, {.op = field.type == FieldType::cost ? Op::tree_cost : Op::tree_count,
                       .number = *vertex,
                       .field = field.name});
  }
  Index no_vertex(std::size_t begin, std::string_view name) {
    return failed(begin,
                  "'" + std::string(name) + "' needs the number of a vertex: " + std::string(name) + "(17)");
  }

  Index unknown_name(std::size_t begin, std::string_view name) {
    if (name == "and" || name == "or" || name == "not")
      return failed(begin, "a value is missing; '" + std::string(name) + "' is written " +
                               (name == "and"  ? "'&&'"
                                : name == "or" ? "'||'"
                                               : "'!'"));
    std::vector<std::string_view> all = {"inf", "true", "false", "none"};
    for (const ConditionName& each : condition_names()) all.push_back(each.name);
    for (const Field& field : own_) all.push_back(field.name);
    const std::string_view nearest = nearest_name(name, all);
    const std::string_view bare = name.substr(0, 40);
    return failed(begin,
                  "unknown name '" + std::string(bare) + (bare == name ? "'" : "...'") +
                      (nearest.empty() ? "; there are g, rhs, km, size(U), taken, changed, event and others"
                                       : "; did you mean '" + std::string(nearest) + "'?"));
  }

  Index known_name(std::size_t begin, const ConditionName& name) {
    Term term{.op = name.op, .type = name.type};
    if (is_of_vertex(name.op) || name.op == Op::taken) {
      const auto where = cell("'" + std::string(name.name) + "'", form_text(name.form, world_.solid()));
      if (!where) return std::nullopt;
      term.cell = *where;
    } else if (name.op == Op::queue_size) {
      if (!in_.take('(') || in_.take_name() != "U" || !in_.take(')'))
        return failed(begin, "'size' is told of the open list only: size(U)");
    } else if (name.op == Op::score) {
      if (!in_.take('(') || in_.take_name() != "winner" || !in_.take(')'))
        return failed(begin, "'score' is told of the arc that was chosen only: score(winner)");
    } else if (name.op == Op::on_line) {
      const auto number = whole_in_parentheses(std::numeric_limits<std::uint8_t>::max());
      if (!number) return failed(begin, "'line' needs the number of a pseudo-code line: line(48)");
      term.number = *number;
    } else if (name.op == Op::rewired) {
      const auto vertex = whole_in_parentheses(kMostVertices - 1);
      if (!vertex) return no_vertex(begin, name.name);
      term.number = *vertex;
    } else if (name.op == Op::changed) {
      const auto value = value_in_parentheses(begin);
      if (!value) return std::nullopt;
      term.left = *value;
    } else if (name.op == Op::event) {
      const auto happening = event_in_parentheses(begin);
      if (!happening) return std::nullopt;
      term.happening = *happening;
    }
    return add(begin, term);
  }

  /// "(12, 40)" inside the world, in space "(12, 40, 2)". `who` needs it, `form` shows how.
  std::optional<Cell> cell(const std::string& who, const std::string& form) {
    const std::size_t begin = in_.at();
    std::array<std::int64_t, 3> at{};
    const std::size_t axes = world_.solid() ? 3 : 2;
    bool read = true, inside = true;
    std::string written;
    for (std::size_t axis = 0; axis < axes && read; ++axis) {
      const auto number = in_.take(axis == 0 ? '(' : ',') ? in_.take_whole() : std::nullopt;
      read = number.has_value();
      if (!read) break;
      at[axis] = *number;
      inside = inside && *number >= 0 && *number < world_.sides<3>()[axis];
      written += (axis == 0 ? "(" : ", ") + std::to_string(*number);
    }
    if (!read || !in_.take(')')) {
      const std::string numbers = world_.solid() ? "three whole numbers: " : "two whole numbers: ";
      in_.fail(begin, who + " needs " +
                          (who == "a cell" ? numbers : "a cell with whole-number coordinates: ") + form);
      return std::nullopt;
    }
    if (inside) return Cell{static_cast<int>(at[0]), static_cast<int>(at[1]), static_cast<int>(at[2])};
    in_.fail(begin, written + ") is outside the world: " + range_text(world_));
    return std::nullopt;
  }
  std::optional<double> whole_in_parentheses(std::int64_t most) {
    if (!in_.take('(')) return std::nullopt;
    const auto value = in_.take_whole();
    if (!value || *value < 0 || *value > most || !in_.take(')')) return std::nullopt;
    return static_cast<double>(*value);
  }

  Index value_in_parentheses(std::size_t begin) {
    if (!in_.take('(')) return std::nullopt;
    const std::size_t at = in_.skip_blanks();
    const Index value = unary();
    if (!value) return std::nullopt;
    if (!is_value(condition_.terms[*value].op))
      return failed(at, "'changed' needs a value of the search: changed(" +
                            form_text("g(x, y)", world_.solid()) + "), changed(km)");
    if (!in_.take(')')) return failed(begin, "'changed' takes one value: a ')' is missing behind it");
    return value;
  }

  std::optional<Happening> event_in_parentheses(std::size_t begin) {
    in_.take('(');
    const std::size_t at = in_.skip_blanks();
    const std::string_view name = in_.take_name();
    std::vector<std::string_view> all;
    std::string list;
    for (const HappeningName& each : happening_names()) {
      all.push_back(each.name);
      list += (list.empty() ? "" : ", ") + std::string(each.name);
    }
    const auto found = std::find(all.begin(), all.end(), name);
    if (found == all.end()) {
      const std::string_view nearest = nearest_name(name, all);
      in_.fail(at, nearest.empty() || name.empty()
                       ? "'event' needs a name: " + list
                       : "unknown event; did you mean '" + std::string(nearest) + "'?");
      return std::nullopt;
    }
    if (!in_.take(')')) {
      in_.fail(begin, "'event' takes one name: a ')' is missing behind it");
      return std::nullopt;
    }
    return happening_names()[static_cast<std::size_t>(found - all.begin())].happening;
  }

  ConditionScanner in_;
  Box world_;
  std::span<const Field> own_;
  int depth_ = 0;
  Condition condition_;
};

}  // namespace

Result<Condition> parse_expression(std::string_view text, const Box& world, std::span<const Field> own) {
  return ConditionParser(text, world, own).read(std::nullopt);
}

Result<Condition> parse_condition(std::string_view text, const Box& world, std::span<const Field> own) {
  return ConditionParser(text, world, own).read(ValueType::truth);
}

Result<Condition> parse_quantity(std::string_view text, const Box& world, std::span<const Field> own) {
  return ConditionParser(text, world, own).read(ValueType::number);
}

}  // namespace replan
