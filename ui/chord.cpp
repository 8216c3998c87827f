#include "ui/chord.hpp"

namespace replan::ui {
namespace {

std::string key_name(int key) {
  switch (key) {
    case key::kSpace:
      return "Space";
    case key::kEscape:
      return "Esc";
    case key::kEnter:
      return "Enter";
    case key::kTab:
      return "Tab";
    case key::kRight:
      return "→";
    case key::kLeft:
      return "←";
    case key::kUp:
      return "↑";
    case key::kDown:
      return "↓";
    case key::kPageUp:
      return "PgUp";
    case key::kPageDown:
      return "PgDn";
    case key::kHome:
      return "Home";
    case key::kEnd:
      return "End";
    case key::kDelete:
      return "Del";
    case key::kMenu:
      return "Menu";
    case '=':  // with Shift or without
    case key::kKeypadAdd:
      return "+";
    case key::kKeypadSubtract:
      return "-";
    default:
      break;
  }
  if (key >= key::kF1 && key < key::kF1 + 12) return "F" + std::to_string(key - key::kF1 + 1);
  return std::string(1, static_cast<char>(key));
}

}  // namespace

Chord chord_in_page(Chord chord) {
  const bool kept = chord.ctrl && (chord.key == 'T' || chord.key == 'N' || chord.key == 'W');
  if (!kept) return chord;
  chord.ctrl = false;
  chord.alt = true;
  return chord;
}

std::string words_in_page(std::string words) {
  for (const char* kept : {"Ctrl+T", "Ctrl+N", "Ctrl+W"})
    for (std::size_t at = 0; (at = words.find(kept, at)) != std::string::npos;) words.replace(at, 4, "Alt");
  return words;
}

std::string chord_text(const Chord& chord) {
  if (chord.key == 0) return "";
  return std::string(chord.ctrl ? "Ctrl+" : "") + (chord.shift ? "Shift+" : "") + (chord.alt ? "Alt+" : "") +
         key_name(chord.key);
}

}  // namespace replan::ui
