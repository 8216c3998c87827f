// The Debug tab: where the playhead stops by itself, what is followed over the run, and what the planners are held to.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "ui/shell/frame.hpp"

namespace replan::ui {

/// Which panes are compared, and in what.
struct Comparison {
  std::array<int, 2> panes{0, 1};
  int what = 1;  ///< a Compare
};

class DebugTab final : public SideTab {
 public:
  void draw(Frame& frame) override;
  /// What compares the panes that are chosen, or the first two.
  [[nodiscard]] FindDifference find_difference(const Session& session) const;

  // Being typed.
  std::string breakpoint, watch;

 private:
  Comparison comparison_;
};

/// Below the breakpoints where there are several panes: whose stops are counted.
std::string whose_stops(std::string_view planner);

// Its sections about the planners.
void draw_checks(Frame& frame);
void draw_difference(Frame& frame, Comparison& comparison);

}  // namespace replan::ui
