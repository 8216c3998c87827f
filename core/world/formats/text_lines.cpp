#include "core/world/formats/text_lines.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <utility>

namespace replan {
namespace {

/// A character of UTF-8; `size` is 0 where the text does not begin with one.
struct Character {
  std::uint32_t code = 0;
  std::size_t size = 0;
};

Character decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return std::uint32_t{static_cast<unsigned char>(text[i])}; };
  if (text.empty()) return {};
  const std::uint32_t first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < size) return {};
  std::uint32_t code = first & (0x7Fu >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0u) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < kLeast[size] || code > 0x10FFFF || surrogate ? Character{} : Character{code, size};
}

/// Whether a character leaves something to be seen: no control, no blank but the plain one, nothing of no
/// width.
bool can_be_seen(std::uint32_t code) {
  constexpr std::pair<std::uint32_t, std::uint32_t> kUnseen[] = {
      {0, 0x1F},        {0x7F, 0xA0},     {0xAD, 0xAD},     {0x1680, 0x1680}, {0x180E, 0x180E},
      {0x2000, 0x200F}, {0x2028, 0x202F}, {0x205F, 0x206F}, {0x3000, 0x3000}, {0xE000, 0xF8FF},
      {0xFE00, 0xFE0F}, {0xFEFF, 0xFEFF}, {0xFFF0, 0xFFFB}, {0xFFFE, 0xFFFF}, {0xE0000, 0x10FFFF}};
  return std::none_of(std::begin(kUnseen), std::end(kUnseen),
                      [&](const auto& range) { return code >= range.first && code <= range.second; });
}

std::string code_text(std::string_view text, Character character) {
  char code[16];
  if (character.size > 1)
    std::snprintf(code, sizeof code, "U+%04X", static_cast<unsigned>(character.code));
  else
    std::snprintf(code, sizeof code, "0x%02X",
                  static_cast<unsigned>(static_cast<unsigned char>(text.front())));
  return code;
}

}  // namespace

std::size_t first_character(std::string_view text) {
  return std::max<std::size_t>(1, decode(text).size);
}

std::string shown_letter(std::string_view text) {
  if (text.empty()) return "''";
  const Character character = decode(text);
  if (text.front() == ' ' || character.size == 0 || !can_be_seen(character.code))
    return code_text(text, character);
  return "'" + std::string(text.substr(0, character.size)) + "'";
}

std::string shown(std::string_view piece) {
  constexpr std::size_t kLongest = 40;
  std::string text = "'";
  while (!piece.empty() && text.size() <= kLongest) {
    const Character character = decode(piece);
    const std::size_t size = std::max<std::size_t>(1, character.size);
    if (character.size > 0 && can_be_seen(character.code))
      text += piece.substr(0, size);
    else
      text += "<" + code_text(piece, character) + ">";
    piece.remove_prefix(size);
  }
  return text + (piece.empty() ? "'" : "...'");
}

}  // namespace replan
