#include "core/base/real_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include <locale.h>  // of POSIX: <clocale> need not have newlocale()

namespace replan {
namespace {

/// Reads a text that C takes for a number, whatever the system's language has for a decimal point.
double plain_number(const std::string& text) {
  static const locale_t kPlain = ::newlocale(LC_ALL_MASK, "C", nullptr);
  return ::strtod_l(text.c_str(), nullptr, kPlain);
}

/// d.ddd times ten to an exponent.
struct Digits {
  std::string digits;
  int exponent = 0;
};

/// As many digits as asked for, of a finite number that is not negative.
Digits digits_of(double number, int count) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*e", count - 1, number);
  Digits found;
  const char* at = text.data();
  for (; *at != 'e'; ++at)
    if (*at >= '0' && *at <= '9') found.digits += *at;  // whatever stands for the point is left out
  found.exponent = std::atoi(at + 1);
  return found;
}

std::string scientific(const Digits& of) {
  std::string text = of.digits.substr(0, 1);
  if (of.digits.size() > 1) text += "." + of.digits.substr(1);
  const int size = std::abs(of.exponent);
  return text + (of.exponent < 0 ? "e-" : "e+") + (size < 10 ? "0" : "") + std::to_string(size);
}

/// Without an exponent. All digits of a whole number are written, not noughts in place of the last ones.
std::string written_out(const Digits& of, double number) {
  const int count = static_cast<int>(of.digits.size());
  if (of.exponent < 0) return "0." + std::string(static_cast<std::size_t>(-of.exponent - 1), '0') + of.digits;
  if (of.exponent + 1 < count) {
    const auto point = static_cast<std::size_t>(of.exponent + 1);
    return of.digits.substr(0, point) + "." + of.digits.substr(point);
  }
  std::array<char, 320> text{};
  std::snprintf(text.data(), text.size(), "%.0f", number);
  return text.data();
}

/// One more in the last place.
Digits next_above(Digits of) {
  std::size_t at = of.digits.size();
  while (at > 0 && of.digits[at - 1] == '9') of.digits[--at] = '0';
  if (at > 0) {
    ++of.digits[at - 1];
    return of;
  }
  of.digits.front() = '1';
  ++of.exponent;
  return of;
}

/// The fewest digits that read back to the same number, and of these the nearest. The nearest of all with so many need not
/// read back: below a power of two doubles lie twice as close as above it.
Digits shortest_digits(double number) {
  constexpr int kEnough = 17;
  for (int count = 1; count < kEnough; ++count) {
    Digits found = digits_of(number, count);
    if (plain_number(scientific(found)) == number) return found;
    found = next_above(std::move(found));
    if (plain_number(scientific(found)) == number) return found;
  }
  return digits_of(number, kEnough);
}

bool is_figure(char c) {
  return c >= '0' && c <= '9';
}

/// How long the number in figures is that a text begins with; 0 if there is none. `nought`: it is one.
std::size_t figures_length(std::string_view text, bool& nought) {
  std::size_t at = text.starts_with('-') ? 1 : 0, figures = 0;
  nought = true;
  const auto pass_figures = [&] {
    for (; at < text.size() && is_figure(text[at]); ++at, ++figures) nought = nought && text[at] == '0';
  };
  pass_figures();
  if (at < text.size() && text[at] == '.') {
    ++at;
    pass_figures();
  }
  if (figures == 0) return 0;
  std::size_t exponent = at;
  if (exponent < text.size() && (text[exponent] == 'e' || text[exponent] == 'E')) {
    ++exponent;
    if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
    while (exponent < text.size() && is_figure(text[exponent])) at = ++exponent;
  }
  return at;
}

/// How long the word is that a text begins with, in capital or small letters; 0 if it is another.
std::size_t word_length(std::string_view text, std::string_view word) {
  if (text.size() < word.size()) return 0;
  for (std::size_t i = 0; i < word.size(); ++i)
    if ((text[i] | 0x20) != word[i]) return 0;
  return word.size();
}

/// How long the word is that spells a number which is none of figures, with its sign.
std::size_t number_word_length(std::string_view text) {
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  for (const std::string_view word : {"infinity", "inf", "nan"})
    if (const std::size_t length = word_length(text.substr(sign), word)) return sign + length;
  return 0;
}

}  // namespace

namespace plain {

std::string real_text(double number) {
  const std::string sign = std::signbit(number) ? "-" : "";
  if (std::isnan(number)) return sign + "nan";
  const double size = std::abs(number);
  if (std::isinf(size)) return sign + "inf";
  if (size == 0) return sign + "0";
  const Digits digits = shortest_digits(size);
  std::string with_exponent = scientific(digits);
  const int places = std::abs(digits.exponent);
  if (places > 40) return sign + with_exponent;  // far longer without
  std::string without = written_out(digits, size);
  return sign + (without.size() <= with_exponent.size() ? without : with_exponent);
}

std::optional<double> take_real(std::string_view& text) {
  bool nought = false;
  std::size_t length = figures_length(text, nought);
  const bool word = length == 0;
  if (word) length = number_word_length(text);
  if (length == 0) return std::nullopt;
  const double number = plain_number(std::string(text.substr(0, length)));
  if (!word && (std::isinf(number) || (number == 0 && !nought))) return std::nullopt;
  text.remove_prefix(length);
  return number;
}

}  // namespace plain

#if defined(__cpp_lib_to_chars)

std::string real_text(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

std::optional<double> take_real(std::string_view& text) {
  double number = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failed != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

#else

std::string real_text(double number) {
  return plain::real_text(number);
}

std::optional<double> take_real(std::string_view& text) {
  return plain::take_real(text);
}

#endif

std::optional<double> real_from(std::string_view text) {
  const auto number = take_real(text);
  return text.empty() ? number : std::nullopt;
}

}  // namespace replan
