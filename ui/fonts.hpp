// The faces of the window: Inter for words, JetBrains Mono for numbers and code, Font Awesome for icons. They
// are taken from the system's packages and never copied; what is missing is replaced and reported.
#pragma once

#include <string>
#include <vector>

#include <imgui.h>

namespace replan::ui {

/// Each role once, baked at its size times the display's scale. All are valid after build_fonts.
struct Fonts {
  ImFont* ui = nullptr;          ///< words, 13
  ImFont* title = nullptr;       ///< semibold, 13: the title of a thing
  ImFont* section = nullptr;     ///< semibold, 12: the head of a panel's section
  ImFont* small = nullptr;       ///< 11: captions inside chips, key chips
  ImFont* heading = nullptr;     ///< semibold, 18: empty states, dialogs, lessons
  ImFont* mono = nullptr;        ///< numbers, cells and code, 12
  ImFont* mono_bold = nullptr;   ///< semibold, 12: the number that matters
  ImFont* mono_small = nullptr;  ///< 10: numbers inside cells
  ImFont* icons = nullptr;       ///< icons alone, 16: tool buttons
};

struct FontOptions {
  float scale = 1.0f;
  /// Every character of this UTF-8 text is baked too, from a CJK face where the others lack it: hand over
  /// all strings of the current language.
  std::string also;
  /// The 2,500 commonest simplified Chinese characters, for what users type or name; costs atlas space.
  bool chinese = false;
};

struct FontReport {
  Fonts fonts;
  std::vector<std::string> notices;  ///< sentences for the Log: which face is missing and its package
};

/// Clears `atlas` and bakes all roles into it. The texture must be uploaded again afterwards.
FontReport build_fonts(ImFontAtlas& atlas, const FontOptions& options);

}  // namespace replan::ui
