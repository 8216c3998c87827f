// The parts of the window. Each draws itself from a Frame and queues what it wants changed.
#pragma once

#include "ui/shell/actions.hpp"
#include "ui/shell/frame.hpp"

namespace replan::ui {

/// An ActionContext over a frame.
ActionContext context_of(Frame& frame);
/// Does what the action does, if it is available.
void perform(Frame& frame, ActionId id);

// Each in the current ImGui window or child.
void draw_menu_bar(Frame& frame);
/// A red dot and the length of the film while one is recorded; a click stops it.
void draw_recording(Frame& frame);
void draw_tool_strip(Frame& frame);
/// Whether the tool, or what is selected, has something to choose.
bool has_tool_options(const Frame& frame);
void draw_tool_options(Frame& frame);
/// Of what is selected, in the tool's choices.
void draw_remove_button(Frame& frame);
void draw_transport(Frame& frame);
void draw_timeline(Frame& frame, ImVec2 min, ImVec2 max);
void draw_status_bar(Frame& frame);
void draw_side(Frame& frame);
void draw_planner_panel(Frame& frame);
void draw_cell_panel(Frame& frame);
void draw_open_list_panel(Frame& frame);
void draw_code_panel(Frame& frame);
void draw_figures_panel(Frame& frame);
/// How all panes stand at their cursors.
std::vector<RunReport> figures_now(PanelState& panels, const Session& session);
void draw_debug_panel(Frame& frame);
// Its sections about the planners.
void draw_checks(Frame& frame);
void draw_difference(Frame& frame);
void draw_log_panel(Frame& frame);
/// What the Cell tab says of the cell's past.
void draw_history(Frame& frame, Cell cell);
/// The menu of the cell that ViewState::menu asks for, as a popup.
void draw_cell_menu(Frame& frame);
// Entries of menus: for the cell, and for one value of it, called `name`.
void cell_menu_items(Frame& frame, Cell cell);
void value_menu_items(Frame& frame, const char* name, EventKind kind, Cell cell);
/// Where an event of the leading run came from: "line 21 of UpdateVertex, in replan 3".
std::string origin_text(Frame& frame, std::size_t event);
/// Over the canvas, its lower right corner at `corner`: why the playhead stopped, or what it looks for.
void draw_stop(Frame& frame, ImVec2 corner);

/// All overlays with their switches, keys and explanations; for popups and menus.
void draw_overlay_switches(Frame& frame);
/// The pseudo-code block with the current line lit; `around` > 0: only so many lines about it.
void draw_pseudo_code(Frame& frame, const PseudoBlock& block, int around);

}  // namespace replan::ui
