// The Open list tab: what the planner will take next, in its order, and what the last replan touched.
#pragma once

#include "core/debug/open_order.hpp"
#include "ui/shell/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

class OpenListTab final : public SideTab {
 public:
  void draw(Frame& frame) override;
  void show_first() override { repair_ = false; }

  /// Shows what the last replan touched instead.
  void show_repair() { repair_ = true; }
  [[nodiscard]] const OpenOrder& order() const { return order_; }

 private:
  void follow(const Frame& frame);
  void draw_open_list(Frame& frame);
  void draw_touched(Frame& frame);

  OpenOrder order_;
  double order_seconds_ = 0;  // what sorting it anew took the last time
  double order_due_ = 0;      // not before this time (ImGui's) again while it plays
  bool repair_ = false;
  RowScroll order_rows_, touched_rows_;
};

/// Shows the tab with what the last replan touched.
void show_touched(ViewState& view, PanelState& panels);

}  // namespace replan::ui
