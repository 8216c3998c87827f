// The Open list tab: what the planner will take next, in its order, what the last replan touched, and what made the robot
// plan again.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/debug/kept.hpp"
#include "core/debug/open_order.hpp"
#include "core/debug/replan_change.hpp"
#include "ui/shell/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

class OpenListTab final : public SideTab {
 public:
  void draw(Frame& frame) override;
  void show_first() override { part_ = Part::open_list; }

  /// Shows what the last replan touched instead.
  void show_repair() { part_ = Part::repair; }
  [[nodiscard]] const OpenOrder& order() const { return order_; }

 private:
  void follow(const Frame& frame);
  void draw_open_list(Frame& frame);
  void draw_touched(Frame& frame);
  void draw_changed(Frame& frame);

  OpenOrder order_;
  double order_seconds_ = 0;  // what sorting it anew took the last time
  double order_due_ = 0;      // not before this time (ImGui's) again while it plays
  enum class Part : int { open_list, repair, change };
  Part part_ = Part::open_list;
  RowScroll order_rows_, touched_rows_, changed_rows_;
  /// What was read out of a log for the plan that begins there.
  std::vector<ChangedCell> changed_;
  std::optional<std::pair<std::uint64_t, std::size_t>> changed_of_;
};

/// Says what a planner goes on with that keeps no open list. False, and nothing is drawn, of one that does.
bool lists_nothing(Frame& frame);
/// What the last replan before the cursor kept of a tree or a population; nullptr before the first one, and of other
/// planners.
KeptInReplan* kept_by_last_replan(Frame& frame);
/// What it kept, as a sentence, and a table of what it lost.
void draw_lost(Frame& frame, const KeptInReplan& kept, RowScroll& scroll);

/// Shows the tab with what the last replan touched.
void show_touched(ViewState& view, PanelState& panels);

}  // namespace replan::ui
