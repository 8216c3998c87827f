#include "ui/tabs/tab_box.hpp"

#include <algorithm>

#include "ui/shell/frame.hpp"

namespace replan::ui {

#define REPLAN_TAB(ID) TabKind ID##_tab();
#define REPLAN_ACTION(ID, ...)
#include "ui/tabs/tabs.def"
#undef REPLAN_ACTION
#undef REPLAN_TAB

std::span<const TabKind> tab_kinds() {
  static const std::vector<TabKind> kKinds = {
#define REPLAN_TAB(ID) named(ID##_tab(), #ID),
#define REPLAN_ACTION(ID, ...)
#include "ui/tabs/tabs.def"
#undef REPLAN_ACTION
#undef REPLAN_TAB
  };
  return kKinds;
}

std::size_t tab_number(std::string_view id) {
  const auto kinds = tab_kinds();
  const auto number_of = [&](const auto& condition) {
    return static_cast<std::size_t>(std::find_if(kinds.begin(), kinds.end(), condition) - kinds.begin());
  };
  const std::size_t found = number_of([id](const TabKind& kind) { return kind.id == id; });
  return found < kinds.size() ? found : number_of([](const TabKind& kind) { return kind.at_first; });
}

std::size_t SideTab::pane(const Frame& frame) const {
  return frame.session.lead();
}

TabBox::TabBox() {
  for (const TabKind& kind : tab_kinds()) tabs_.push_back(kind.make());
}

void show_tab(ViewState& view, PanelState& panels, std::string_view id) {
  view.tab = id;
  view.panels = true;
  panels.tabs[tab_number(id)].show_first();
}

}  // namespace replan::ui
