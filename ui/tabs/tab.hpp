// A tab of the side panel. Each has a file in ui/tabs that defines its TabKind, and a line in tabs.def; its action, menu
// entry, key and place in the palette follow.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "ui/chord.hpp"

namespace replan {
class Session;
}

namespace replan::ui {

struct Frame;

/// What it remembers between frames is its own, and no part of the document.
class SideTab {
 public:
  virtual ~SideTab() = default;
  /// In the current ImGui window.
  virtual void draw(Frame& frame) = 0;
  /// The pane that it is about now.
  [[nodiscard]] virtual std::size_t pane(const Frame& frame) const;
  /// Its action was done: what it shows at first is to show now.
  virtual void show_first() {}
};

struct TabKind {
  const char* name;  ///< as on the tab
  // Its action, that shows it.
  const char* label;
  const char* icon;
  Chord chord;
  const char* teach;
  std::unique_ptr<SideTab> (*make)();
  bool per_pane = true;   ///< it is about the leading pane, which can be chosen above it
  bool at_first = false;  ///< it shows when the program begins
  bool (*in_bar)(const Session& session) =
      nullptr;               ///< whether it has a place in the bar of tabs while another one
                             ///< shows; nullptr: always
  std::string_view id = {};  ///< as listed; settings are kept by it
};

/// All tabs in the order of tabs.def.
std::span<const TabKind> tab_kinds();
/// The number of the tab of that name; of the one that shows at first if there is none.
std::size_t tab_number(std::string_view id);

}  // namespace replan::ui
