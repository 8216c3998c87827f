// Lines, words and letters of the text formats that maps come in, and how an error shows them.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/base/real_text.hpp"

namespace replan {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

inline std::string_view without_trailing_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The text without the byte order mark that some editors put before UTF-8.
inline std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

/// Takes a text apart line by line; both LF and CR LF end a line. A byte order mark is passed over.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(without_byte_order_mark(text)) {}

  /// The next line without its end and trailing blanks, or nothing at the end of the text.
  std::optional<std::string_view> next() {
    if (rest_.empty()) return std::nullopt;
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    return without_trailing_blanks(line);
  }
  /// The number of the line last returned, from 1.
  [[nodiscard]] int number() const { return number_; }
  /// How many bytes of the text are left.
  [[nodiscard]] std::size_t left() const { return rest_.size(); }

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// Takes the first word off `line`; empty if there is none.
inline std::string_view take_word(std::string_view& line) {
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  std::size_t length = 0;
  while (length < line.size() && !is_blank(line[length])) ++length;
  const std::string_view word = line.substr(0, length);
  line.remove_prefix(length);
  return word;
}

/// The number that a whole word spells, or nothing (also if it does not fit).
template <class Number>
std::optional<Number> number_from(std::string_view word) {
  if constexpr (std::is_same_v<Number, double>) {
    return real_from(word);
  } else {
    Number value{};
    const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || failed != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
  }
}

/// A text of somebody else's as part of an error: on one line, without control characters.
inline std::string one_line(std::string text) {
  for (char& c : text)
    if ((c >= 0 && c < ' ') || c == '\x7F') c = '?';
  return text;
}

/// How many bytes the first character of a text has: 1 also for a byte that is no UTF-8.
std::size_t first_character(std::string_view text);
/// The first character of a text as an error names it: 'x', or its code where nobody could see it, such as
/// 0x20 for a blank, 0x09 for a tab, U+00A0 for a blank that is none, 0xFF for a byte that is no UTF-8.
std::string shown_letter(std::string_view text);
/// A piece of a file as shown in an error: in quotes, not too long, with codes as above.
std::string shown(std::string_view piece);

}  // namespace replan
