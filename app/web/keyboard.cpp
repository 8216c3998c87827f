#include "app/web/keyboard.hpp"

#include <array>
#include <charconv>
#include <utility>

#include "ui/keys.hpp"

namespace replan::app {
namespace {

namespace key = ui::key;

/// Names of keys that type nothing.
constexpr std::array kNamed = {
    std::pair{std::string_view("Escape"), key::kEscape},
    std::pair{std::string_view("Enter"), key::kEnter},
    std::pair{std::string_view("Tab"), key::kTab},
    std::pair{std::string_view("Backspace"), key::kBackspace},
    std::pair{std::string_view("Insert"), key::kInsert},
    std::pair{std::string_view("Delete"), key::kDelete},
    std::pair{std::string_view("ArrowRight"), key::kRight},
    std::pair{std::string_view("ArrowLeft"), key::kLeft},
    std::pair{std::string_view("ArrowDown"), key::kDown},
    std::pair{std::string_view("ArrowUp"), key::kUp},
    std::pair{std::string_view("PageUp"), key::kPageUp},
    std::pair{std::string_view("PageDown"), key::kPageDown},
    std::pair{std::string_view("Home"), key::kHome},
    std::pair{std::string_view("End"), key::kEnd},
    std::pair{std::string_view("ContextMenu"), key::kMenu},
};

/// Keys that stand twice on a keyboard, or on its pad: by their place.
constexpr std::array kPlaced = {
    std::pair{std::string_view("NumpadSubtract"), key::kKeypadSubtract},
    std::pair{std::string_view("NumpadAdd"), key::kKeypadAdd},
    std::pair{std::string_view("NumpadEnter"), key::kKeypadEnter},
    std::pair{std::string_view("ShiftLeft"), key::kLeftShift},
    std::pair{std::string_view("ShiftRight"), key::kRightShift},
    std::pair{std::string_view("ControlLeft"), key::kLeftControl},
    std::pair{std::string_view("ControlRight"), key::kRightControl},
    std::pair{std::string_view("AltLeft"), key::kLeftAlt},
    std::pair{std::string_view("AltRight"), key::kRightAlt},
    std::pair{std::string_view("MetaLeft"), key::kLeftSuper},
    std::pair{std::string_view("MetaRight"), key::kRightSuper},
};

template <class Table>
int find_in(const Table& table, std::string_view name) {
  for (const auto& [known, number] : table)
    if (known == name) return number;
  return 0;
}

/// "F1" to "F12".
int function_key(std::string_view name) {
  int n = 0;
  if (name.size() < 2 || name.front() != 'F') return 0;
  const auto [end, failed] = std::from_chars(name.data() + 1, name.data() + name.size(), n);
  return failed == std::errc() && end == name.data() + name.size() && n >= 1 && n <= 12 ? key::kF1 + n - 1
                                                                                        : 0;
}

}  // namespace

int key_number(std::string_view name, std::string_view code) {
  if (const int placed = find_in(kPlaced, code); placed != 0) return placed;
  if (const int named = find_in(kNamed, name); named != 0) return named;
  if (const int function = function_key(name); function != 0) return function;
  if (name.size() != 1) return 0;
  const char letter = name.front();
  if (letter >= 'a' && letter <= 'z') return letter - 'a' + 'A';
  return letter >= ' ' && letter < 127 ? letter : 0;
}

std::optional<unsigned> typed_character(std::string_view key) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(key[i])); };
  if (key.empty()) return std::nullopt;
  // One character of UTF-8, and no more: names of keys are longer.
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (key.size() != length) return std::nullopt;
  if (length == 1) return first >= ' ' && first != 127 ? std::optional(first) : std::nullopt;
  unsigned point = first & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) point = point << 6 | (byte(i) & 0x3Fu);
  return point;
}

}  // namespace replan::app
