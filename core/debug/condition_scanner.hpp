// The characters of an expression, from left to right: blanks, names, numbers, signs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace replan {

/// Stands at a character of the text. It keeps the first error.
class ConditionScanner {
 public:
  explicit ConditionScanner(std::string_view text) : text_(text) {}

  /// Where it stands, in bytes.
  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] bool at_end() const { return at_ == text_.size(); }
  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }
  /// The character here; none at the end is 0.
  [[nodiscard]] char here() const { return at_end() ? '\0' : text_[at_]; }
  [[nodiscard]] bool at_letter() const;
  [[nodiscard]] bool at_digit() const;

  void advance(std::size_t characters) { at_ += characters; }
  /// Goes past blanks, to where it returns.
  std::size_t skip_blanks();
  /// Past blanks, whether the character is next; take() goes on behind it if it is.
  [[nodiscard]] bool next_is(char c);
  bool take(char c);
  /// Past blanks, letters and then digits too; empty if there are none.
  std::string_view take_name();
  std::optional<std::int64_t> take_whole();
  /// From here on, without blanks before it.
  std::optional<double> take_number();

  /// Notes what is wrong at a place of the text, unless something was before.
  void fail(std::size_t at, const std::string& what);
  /// What is here belongs nowhere: an operator or the end would.
  void fail_unexpected();
  /// "character 3: ..."; empty if all is well.
  [[nodiscard]] const std::string& error() const { return error_; }
  /// The character here as errors show it.
  [[nodiscard]] std::string shown() const;

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::string error_;
};

}  // namespace replan
