// How fast the robots drive, over the world's own time, as a small chart.
#pragma once

#include "ui/shell/frame.hpp"

namespace replan::ui {

/// Whether there is anything to show: a pane whose robot drives and has set out.
bool has_speeds(const Session& session);
/// Draws every pane's speeds, the leading one's strong, over the width that is left. A click goes to the moment.
void speed_chart(Frame& frame, float height);

}  // namespace replan::ui
