// Reads expressions by descending through the operators' levels. One pass: each part is checked for its type
// as soon as it is read, so that an error points at the first thing that is wrong.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/words.hpp"
#include "core/debug/condition.hpp"
#include "core/plan/parameters.hpp"

namespace replan {
namespace {

using enum ValueType;

constexpr const char* kTypeWords[] = {"a number", "a truth", "a cell"};

const char* words(ValueType type) {
  return kTypeWords[static_cast<std::size_t>(type)];
}

struct Operator {
  std::string_view symbol;
  Op op;
  int level;
  ValueType operand, result;  // of == and != any operand
};

// Longer symbols first: '<=' begins like '<'.
constexpr Operator kOperators[] = {
    {"||", Op::either, 1, truth, truth},   {"&&", Op::both, 2, truth, truth},
    {"==", Op::equal, 3, number, truth},   {"!=", Op::unequal, 3, number, truth},
    {"<=", Op::at_most, 4, number, truth}, {">=", Op::at_least, 4, number, truth},
    {"<", Op::less, 4, number, truth},     {">", Op::more, 4, number, truth},
    {"+", Op::plus, 5, number, number},    {"-", Op::minus, 5, number, number},
    {"*", Op::product, 6, number, number}, {"/", Op::quotient, 6, number, number},
};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// A character of the text as errors show it.
std::string shown(std::string_view rest) {
  const auto c = static_cast<unsigned char>(rest.front());
  if (c < ' ' || c == 0x7F) return "a control character";
  std::size_t length = 1;
  while (length < rest.size() && (static_cast<unsigned char>(rest[length]) & 0xC0u) == 0x80u) ++length;
  return "'" + std::string(rest.substr(0, length)) + "'";
}

class Parser {
 public:
  Parser(std::string_view text, WorldSize world) : text_(text), world_(world) {}

  Result<Condition> read(std::optional<ValueType> wanted) {
    if (text_.size() > kLongestExpression)
      return Error{"the expression is too long: at most " + std::to_string(kLongestExpression) +
                   " characters"};
    skip_blanks();
    if (at_ == text_.size()) return Error{"character 1: an expression is missing: for example km > 5"};
    const auto root = level(1);
    skip_blanks();
    if (root && at_ < text_.size()) unexpected();
    if (root && wanted && type(*root) != *wanted)
      fail(0, *wanted == truth ? "a breakpoint needs a truth, this is " + std::string(words(type(*root))) +
                                     ": compare it, as in km > 5"
                               : "a watch needs a number, this is " + std::string(words(type(*root))) +
                                     ": name a value, as in km or size(U)");
    if (!error_.empty()) return Error{error_};
    return std::move(condition_);
  }

 private:
  using Index = std::optional<std::uint16_t>;  // nothing after an error

  // Errors. The first one is kept.
  void fail(std::size_t at, const std::string& what) {
    if (!error_.empty()) return;
    std::size_t column = 1;  // in characters, not in the bytes of UTF-8
    for (std::size_t i = 0; i < at; ++i) column += (static_cast<unsigned char>(text_[i]) & 0xC0u) != 0x80u;
    error_ = "character " + std::to_string(column) + ": " + what;
  }
  Index failed(std::size_t at, const std::string& what) {
    fail(at, what);
    return std::nullopt;
  }
  void unexpected() {
    const std::string_view rest = text_.substr(at_);
    if (rest.front() == '=') return fail(at_, "write '==' to compare");
    if (rest.front() == '&') return fail(at_, "write '&&' for 'and'");
    if (rest.front() == '|') return fail(at_, "write '||' for 'or'");
    const std::size_t at = at_;
    const std::string_view name = take_name();
    if (name == "and" || name == "or")
      return fail(at, name == "and" ? "write '&&' for 'and'" : "write '||' for 'or'");
    if (rest.front() == ')') return fail(at, "this ')' closes nothing");
    fail(at, shown(rest) + " is not expected here: an operator such as && or > is missing, or the end");
  }

  // Characters.
  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  [[nodiscard]] bool next_is(char c) {
    skip_blanks();
    return at_ < text_.size() && text_[at_] == c;
  }
  bool take(char c) {
    if (!next_is(c)) return false;
    ++at_;
    return true;
  }
  std::string_view take_name() {
    skip_blanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || (at_ > begin && is_digit(text_[at_])))) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  // Terms.
  [[nodiscard]] ValueType type(std::uint16_t index) const { return condition_.terms[index].type; }
  Index add(std::size_t at, Term term) {
    if (condition_.terms.size() >= kMostTerms)
      return failed(at, "the expression is too long: at most " + std::to_string(kMostTerms) + " terms");
    condition_.terms.push_back(term);
    return static_cast<std::uint16_t>(condition_.terms.size() - 1);
  }

  const Operator* operator_at(int level) {
    skip_blanks();
    for (const Operator& each : kOperators)
      if (text_.substr(at_).starts_with(each.symbol)) return each.level == level ? &each : nullptr;
    return nullptr;
  }

  /// Operands of one level, joined from the left.
  Index level(int number) {
    if (number > 6) return unary();
    skip_blanks();
    const std::size_t begin = at_;
    Index left = level(number + 1);
    while (left) {
      const Operator* found = operator_at(number);
      if (found == nullptr) break;
      const std::size_t sign = at_;
      at_ += found->symbol.size();
      skip_blanks();
      const std::size_t right_begin = at_;
      const Index right = level(number + 1);
      if (!right) return std::nullopt;
      left = join(*found, sign, *left, begin, *right, right_begin);
    }
    return left;
  }

  Index join(const Operator& each, std::size_t sign, std::uint16_t left, std::size_t left_begin,
             std::uint16_t right, std::size_t right_begin) {
    const std::string name = "'" + std::string(each.symbol) + "'";
    if (each.level == 3) {
      if (type(left) != type(right))
        return failed(sign, name + " compares two of a kind: left of it is " + words(type(left)) +
                                ", right of it " + words(type(right)));
    } else {
      if (type(left) != each.operand) return wrong_operand(name, each, left_begin, type(left), "left");
      if (type(right) != each.operand) return wrong_operand(name, each, right_begin, type(right), "right");
    }
    return add(sign, {.op = each.op, .type = each.result, .left = left, .right = right});
  }
  Index wrong_operand(const std::string& name, const Operator& each, std::size_t at, ValueType is,
                      const char* side) {
    const bool comparable = each.operand == truth && is == number;
    return failed(at, name + " needs " + words(each.operand) + " on its " + side + ", this is " + words(is) +
                          (comparable ? ": compare it, as in km > 5" : ""));
  }

  Index unary() {
    skip_blanks();
    const std::size_t begin = at_;
    if (depth_ >= kDeepestNesting)
      return failed(begin, "nested too deeply: at most " + std::to_string(kDeepestNesting) + " levels");
    ++depth_;
    const Index read = next_is('!') || next_is('-') ? prefixed(begin) : primary();
    --depth_;
    return read;
  }

  Index prefixed(std::size_t begin) {
    const bool denies = text_[at_++] == '!';
    const Index inner = unary();
    if (!inner) return std::nullopt;
    if (type(*inner) != (denies ? truth : number))
      return failed(begin, denies ? std::string("'!' needs a truth, this is ") + words(type(*inner)) +
                                        ": put what is denied in parentheses, as in !(km > 5)"
                                  : std::string("'-' needs a number, this is ") + words(type(*inner)));
    return add(begin, {.op = denies ? Op::negated : Op::opposite, .type = type(*inner), .left = *inner});
  }

  Index primary() {
    if (at_ == text_.size()) return failed(at_, "the expression ends too soon: a value is missing");
    const char c = text_[at_];
    if (c == '(') return parentheses();
    if (is_digit(c) || c == '.') return number_literal();
    if (is_letter(c)) return named();
    if (c == ')') return failed(at_, "a value is missing before this ')'");
    return failed(at_, shown(text_.substr(at_)) + " is not expected here: a value such as km is missing");
  }

  /// A cell, "(12, 40)", or an expression in parentheses.
  Index parentheses() {
    const std::size_t begin = at_;
    if (looks_like_cell()) {
      const auto where = cell("a cell", "(x, y)");
      return where ? add(begin, {.op = Op::cell_literal, .type = ValueType::cell, .cell = *where})
                   : std::nullopt;
    }
    ++at_;
    const Index inner = level(1);
    if (!inner) return std::nullopt;
    if (!take(')')) return failed(begin, "this '(' is not closed: a ')' is missing");
    return inner;
  }
  [[nodiscard]] bool looks_like_cell() const {
    const std::size_t after = text_.find_first_not_of("0123456789- \t", at_ + 1);
    return after != std::string_view::npos && text_[after] == ',';
  }

  Index number_literal() {
    const std::size_t begin = at_;
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc{})
      return failed(begin, "this is no number that can be held: write for example 2.5");
    at_ = static_cast<std::size_t>(end - text_.data());
    if (at_ < text_.size() && (is_letter(text_[at_]) || text_[at_] == '.'))
      return failed(begin, "a number goes on in letters here: write for example 2.5");
    return add(begin, {.op = Op::number_literal, .number = value});
  }

  Index named() {
    const std::size_t begin = at_;
    const std::string_view name = take_name();
    if (name == "inf")
      return add(begin, {.op = Op::number_literal, .number = std::numeric_limits<double>::infinity()});
    if (name == "true" || name == "false")
      return add(begin, {.op = Op::truth_literal, .type = truth, .truth = name == "true"});
    if (name == "none")
      return add(begin, {.op = Op::cell_literal, .type = ValueType::cell, .cell = kNowhere});
    const auto names = condition_names();
    const bool called = next_is('(');
    // 'line' and 'taken' are two names each: with something in parentheses, and without.
    const auto fits = [&](const ConditionName& each) {
      return each.name == name && (each.form.find('(') != std::string_view::npos) == called;
    };
    const auto same = [&](const ConditionName& each) { return each.name == name; };
    auto found = std::find_if(names.begin(), names.end(), fits);
    if (found != names.end()) return known_name(begin, *found);
    found = std::find_if(names.begin(), names.end(), same);
    if (found == names.end()) return unknown_name(begin, name);
    if (called) return failed(at_, "'" + std::string(name) + "' takes nothing in parentheses");
    return failed(begin, "'" + std::string(name) + "' needs " +
                             (is_of_vertex(found->op) ? "a cell: " : "what it is about: ") +
                             std::string(found->form));
  }

  Index unknown_name(std::size_t begin, std::string_view name) {
    if (name == "and" || name == "or" || name == "not")
      return failed(begin, "a value is missing; '" + std::string(name) + "' is written " +
                               (name == "and"  ? "'&&'"
                                : name == "or" ? "'||'"
                                               : "'!'"));
    std::vector<std::string_view> all = {"inf", "true", "false", "none"};
    for (const ConditionName& each : condition_names()) all.push_back(each.name);
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
      const auto where = cell("'" + std::string(name.name) + "'", name.form);
      if (!where) return std::nullopt;
      term.cell = *where;
    } else if (name.op == Op::queue_size) {
      if (!take('(') || take_name() != "U" || !take(')'))
        return failed(begin, "'size' is told of the open list only: size(U)");
    } else if (name.op == Op::on_line) {
      const auto number = whole_in_parentheses();
      if (!number) return failed(begin, "'line' needs the number of a pseudo-code line: line(48)");
      term.number = *number;
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

  /// "(12, 40)" inside the world. `who` needs it, `form` shows how.
  std::optional<Cell> cell(const std::string& who, std::string_view form) {
    const std::size_t begin = at_;
    const auto wrong = [&] {
      fail(begin, who + " needs " + (who == "a cell" ? "two whole numbers: " : "a cell in whole numbers: ") +
                      std::string(form));
      return std::nullopt;
    };
    if (!take('(')) return wrong();
    const auto x = coordinate();
    if (!x || !take(',')) return wrong();
    const auto y = coordinate();
    if (!y || !take(')')) return wrong();
    if (*x >= 0 && *y >= 0 && *x < world_.width && *y < world_.height)
      return Cell{static_cast<int>(*x), static_cast<int>(*y)};
    fail(begin, "(" + std::to_string(*x) + ", " + std::to_string(*y) +
                    ") is outside the world: x goes from 0 to " + std::to_string(world_.width - 1) +
                    ", y from 0 to " + std::to_string(world_.height - 1));
    return std::nullopt;
  }
  std::optional<std::int64_t> coordinate() {
    skip_blanks();
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc{}) return std::nullopt;
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  std::optional<double> whole_in_parentheses() {
    if (!take('(')) return std::nullopt;
    const auto value = coordinate();
    if (!value || *value < 0 || *value > std::numeric_limits<std::uint8_t>::max() || !take(')'))
      return std::nullopt;
    return static_cast<double>(*value);
  }

  Index value_in_parentheses(std::size_t begin) {
    if (!take('(')) return std::nullopt;
    skip_blanks();
    const std::size_t at = at_;
    const Index value = unary();
    if (!value) return std::nullopt;
    if (!is_value(condition_.terms[*value].op))
      return failed(at, "'changed' needs a value of the search: changed(g(x, y)), changed(km)");
    if (!take(')')) return failed(begin, "'changed' takes one value: a ')' is missing behind it");
    return value;
  }

  std::optional<Happening> event_in_parentheses(std::size_t begin) {
    take('(');
    skip_blanks();
    const std::size_t at = at_;
    const std::string_view name = take_name();
    std::vector<std::string_view> all;
    std::string list;
    for (const HappeningName& each : happening_names()) {
      all.push_back(each.name);
      list += (list.empty() ? "" : ", ") + std::string(each.name);
    }
    const auto found = std::find(all.begin(), all.end(), name);
    if (found == all.end()) {
      const std::string_view nearest = nearest_name(name, all);
      fail(at, nearest.empty() || name.empty()
                   ? "'event' needs a name: " + list
                   : "unknown event; did you mean '" + std::string(nearest) + "'?");
      return std::nullopt;
    }
    if (!take(')')) {
      fail(begin, "'event' takes one name: a ')' is missing behind it");
      return std::nullopt;
    }
    return happening_names()[static_cast<std::size_t>(found - all.begin())].happening;
  }

  std::string_view text_;
  WorldSize world_;
  std::size_t at_ = 0;
  int depth_ = 0;
  Condition condition_;
  std::string error_;
};

}  // namespace

Result<Condition> parse_expression(std::string_view text, WorldSize world) {
  return Parser(text, world).read(std::nullopt);
}

Result<Condition> parse_condition(std::string_view text, WorldSize world) {
  return Parser(text, world).read(truth);
}

Result<Condition> parse_quantity(std::string_view text, WorldSize world) {
  return Parser(text, world).read(number);
}

}  // namespace replan
