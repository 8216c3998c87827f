// What every panel and widget needs to draw itself: colours, distances, fonts, and who has the keyboard, and what
// fingers do that no mouse can. Passed by const reference.
#pragma once

#include <optional>

#include "ui/focus.hpp"
#include "ui/fonts.hpp"
#include "ui/input.hpp"
#include "ui/theme.hpp"

namespace replan::ui {

/// How long the mouse rests on a thing before its tooltip shows: a sweep over the tools shall not flicker.
inline constexpr float kHintSeconds = 0.35f;

/// The name of the window that the world is in.
inline constexpr const char* kCanvasArea = "canvas";

struct Look {
  Theme theme = dark();
  Metrics px;
  Fonts fonts;
  KeyboardFocus* focus = nullptr;   ///< whoever draws a control tells it; nullptr: none has the keyboard
  std::optional<Pinch> pinch = {};  ///< of two fingers, in this frame
};

}  // namespace replan::ui
