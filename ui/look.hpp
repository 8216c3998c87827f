// What every panel and widget needs to draw itself: colours, distances, fonts, and who has the keyboard. Passed by const reference.
#pragma once

#include "ui/focus.hpp"
#include "ui/fonts.hpp"
#include "ui/theme.hpp"

namespace replan::ui {

/// How long the mouse rests on a thing before its tooltip shows: a sweep over the tools shall not flicker.
inline constexpr float kHintSeconds = 0.35f;

struct Look {
  Theme theme = dark();
  Metrics px;
  Fonts fonts;
  KeyboardFocus* focus = nullptr;  ///< whoever draws a control tells it; nullptr: none has the keyboard
};

}  // namespace replan::ui
