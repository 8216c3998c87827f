// A key with its modifiers.
#pragma once

#include <string>

#include "ui/keys.hpp"

namespace replan::ui {

/// Key 0: none.
struct Chord {
  int key = 0;
  bool ctrl = false;
  bool shift = false;
  bool alt = false;
  friend bool operator==(const Chord&, const Chord&) = default;
};

constexpr Chord plain(int key) {
  return {key, false, false, false};
}
constexpr Chord shift(int key) {
  return {key, false, true, false};
}
constexpr Chord ctrl(int key) {
  return {key, true, false, false};
}
constexpr Chord ctrl_shift(int key) {
  return {key, true, true, false};
}
constexpr Chord alt(int key) {
  return {key, false, false, true};
}
/// F1 and so on.
constexpr Chord fn(int number) {
  return plain(key::kF1 + number - 1);
}

/// Whether this is the page for browsers.
#ifdef __EMSCRIPTEN__
inline constexpr bool kInPage = true;
#else
inline constexpr bool kInPage = false;
#endif

/// The tabs of browsers keep Ctrl with T, N and W for themselves, with Shift too, and never tell a page: there Alt stands in
/// the place of Ctrl.
Chord chord_in_page(Chord chord);
/// The same in a text for users, such as a lesson's: "Press Ctrl+T" becomes "Press Alt+T".
std::string words_in_page(std::string words);

/// As printed in menus: "Ctrl+Shift+S"; empty for no key.
std::string chord_text(const Chord& chord);

}  // namespace replan::ui
