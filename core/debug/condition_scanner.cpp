#include "core/debug/condition_scanner.hpp"

#include <charconv>

#include "core/base/real_text.hpp"

namespace replan {
namespace {

/// Whether a byte of UTF-8 goes on with the character before it.
bool goes_on(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u;
}

}  // namespace

bool ConditionScanner::at_letter() const {
  const char c = here();
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool ConditionScanner::at_digit() const {
  return here() >= '0' && here() <= '9';
}

std::size_t ConditionScanner::skip_blanks() {
  while (here() == ' ' || here() == '\t') ++at_;
  return at_;
}

bool ConditionScanner::next_is(char c) {
  skip_blanks();
  return !at_end() && here() == c;
}

bool ConditionScanner::take(char c) {
  if (!next_is(c)) return false;
  ++at_;
  return true;
}

std::string_view ConditionScanner::take_name() {
  const std::size_t begin = skip_blanks();
  while (at_letter() || (at_ > begin && at_digit())) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::optional<std::int64_t> ConditionScanner::take_whole() {
  skip_blanks();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
  if (error != std::errc{}) return std::nullopt;
  at_ = static_cast<std::size_t>(end - text_.data());
  return value;
}

std::optional<double> ConditionScanner::take_number() {
  std::string_view rest = text_.substr(at_);
  const auto number = take_real(rest);
  at_ = text_.size() - rest.size();
  return number;
}

void ConditionScanner::fail(std::size_t at, const std::string& what) {
  if (!error_.empty()) return;
  std::size_t column = 1;  // in characters, not in the bytes of UTF-8
  for (std::size_t i = 0; i < at; ++i) column += goes_on(text_[i]) ? 0 : 1;
  error_ = "character " + std::to_string(column) + ": " + what;
}

void ConditionScanner::fail_unexpected() {
  const std::size_t at = at_;
  if (here() == '=') return fail(at, "write '==' to compare");
  if (here() == '&') return fail(at, "write '&&' for 'and'");
  if (here() == '|') return fail(at, "write '||' for 'or'");
  if (here() == ')') return fail(at, "this ')' closes nothing");
  const std::string what = shown();
  const std::string_view name = take_name();
  if (name == "and") return fail(at, "write '&&' for 'and'");
  if (name == "or") return fail(at, "write '||' for 'or'");
  fail(at, what + " is not expected here: an operator such as && or > is missing, or the end");
}

std::string ConditionScanner::shown() const {
  const auto c = static_cast<unsigned char>(here());
  if (c < ' ' || c == 0x7F) return "a control character";
  std::size_t length = 1;
  while (at_ + length < text_.size() && goes_on(text_[at_ + length])) ++length;
  return "'" + std::string(text_.substr(at_, length)) + "'";
}

}  // namespace replan
