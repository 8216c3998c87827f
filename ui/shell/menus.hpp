// The menus of the bar and those beside them: their names, and where they stand.
#pragma once

#include <span>

#include "ui/shell/frame.hpp"

namespace replan::ui {

struct MenuKind {
  Menu menu;
  Menu of;  ///< the menu that it stands in; itself for one of the bar
  const char *name, *icon;
  [[nodiscard]] bool in_bar() const { return menu == of; }
};

/// All of them, in the order in which they stand.
std::span<const MenuKind> menu_kinds();
const MenuKind& menu_kind(Menu menu);

}  // namespace replan::ui
