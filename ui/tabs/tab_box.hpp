// The tabs of a window, with what each remembers.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "ui/parts.hpp"
#include "ui/tabs/tab.hpp"

namespace replan::ui {

struct PanelState;
struct ViewState;

class TabBox {
 public:
  TabBox();

  /// By its number in tab_kinds().
  [[nodiscard]] SideTab& operator[](std::size_t number) const { return *tabs_[number]; }
  template <class T>
  [[nodiscard]] T& get() const {
    return part_of<T>(tabs_);
  }

 private:
  std::vector<std::unique_ptr<SideTab>> tabs_;
};

/// Shows the tab, as its action does.
void show_tab(ViewState& view, PanelState& panels, std::string_view id);

}  // namespace replan::ui
