// The course of a watched quantity over the log, as a small chart.
#pragma once

#include "ui/shell/frame.hpp"

namespace replan::ui {

/// Draws the watch of every pane, the leading one strong, over the width that is left. A click goes to the
/// moment.
void watch_chart(Frame& frame, std::size_t watch, float height);
/// "41.213", "148", "—" for none.
std::string quantity_text(double value);

}  // namespace replan::ui
