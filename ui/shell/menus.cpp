#include "ui/shell/menus.hpp"

#include <algorithm>
#include <array>

#include "ui/icons.hpp"

namespace replan::ui {
namespace {

constexpr MenuKind in_bar(Menu menu, const char* name) {
  return {menu, menu, name, ""};
}

constexpr std::array kMenus = {in_bar(Menu::file, "File"),
                               in_bar(Menu::edit, "Edit"),
                               in_bar(Menu::world, "World"),
                               in_bar(Menu::planner, "Planner"),
                               in_bar(Menu::run, "Run"),
                               MenuKind{Menu::debug, Menu::run, "Debug", icon::bug},
                               in_bar(Menu::view, "View"),
                               MenuKind{Menu::overlays, Menu::view, "Overlays", icon::eye},
                               MenuKind{Menu::tabs, Menu::view, "Tabs", icon::list},
                               MenuKind{Menu::panes, Menu::view, "Panes", icon::columns},
                               MenuKind{Menu::slice, Menu::view, "Layers", icon::cubes},
                               MenuKind{Menu::move, Menu::view, "Move the view", icon::hand},
                               MenuKind{Menu::pin, Menu::view, "Pinned cell", icon::pin},
                               MenuKind{Menu::colours, Menu::view, "Colours of fields", icon::adjust},
                               MenuKind{Menu::size, Menu::view, "Size of everything", icon::expand},
                               in_bar(Menu::record, "Record"),
                               in_bar(Menu::help, "Help")};

}  // namespace

std::span<const MenuKind> menu_kinds() {
  return kMenus;
}

const MenuKind& menu_kind(Menu menu) {
  return *std::find_if(kMenus.begin(), kMenus.end(),
                       [menu](const MenuKind& kind) { return kind.menu == menu; });
}

}  // namespace replan::ui
