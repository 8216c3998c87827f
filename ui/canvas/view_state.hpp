// What the window remembers of itself.
#pragma once

#include <optional>
#include <string>

#include "core/scene/view.hpp"
#include "ui/canvas/editing.hpp"
#include "ui/tools/tool_box.hpp"

namespace replan::ui {

/// No part of the document.
struct ViewState {
  View view;
  ToolBox tools;
  int brush = 1;  ///< side of the brush in cells, 1 to 64
  Editing editing;
  bool dark = true;
  bool panels = true;  ///< side panel and tool strip shown
  std::string tab;     ///< the id of the chosen side tab; empty: the one that shows at first
  bool legend = true;
  std::optional<Cell> menu;  ///< the cell whose menu is asked for
  bool live = true;  ///< a window; else a picture, which shows no wall times and waits for what is worked out
};

}  // namespace replan::ui
