// The Code tab's page of the planner.
#pragma once

namespace replan::ui {

struct PanelState;
struct ViewState;

/// Opens the leading pane's planner's page at its beginning: its idea.
void show_page(ViewState& view, PanelState& panels);

}  // namespace replan::ui
