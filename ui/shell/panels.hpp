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
/// As a menu of its own.
void draw_recent_files(Frame& frame);
/// A red dot and the length of the film while one is recorded; a click stops it.
void draw_recording(Frame& frame);
void draw_tool_strip(Frame& frame);
/// In a low window it has two columns, so that all of the tools are there.
float tool_strip_width(const Look& look, float height);
/// Whether the tool, or what is selected, has something to choose.
bool has_tool_options(const Frame& frame);
void draw_tool_options(Frame& frame);
/// Of what is selected, in the tool's choices.
void draw_remove_button(Frame& frame);
/// In one row, or one column: as many of the tools as there is room for, and the rest behind dots.
void draw_tool_row(Frame& frame);
/// Over its whole height, in a tall, narrow window.
float stacked_transport_height(const Look& look);
void draw_transport(Frame& frame);
void draw_timeline(Frame& frame, ImVec2 min, ImVec2 max);
void draw_status_bar(Frame& frame);
void draw_side(Frame& frame);
/// The menu of the cell that ViewState::menu asks for, as a popup.
void draw_cell_menu(Frame& frame);
// Entries of menus: for the cell, and for one value of it, called `name`.
void cell_menu_items(Frame& frame, Cell cell);
void value_menu_items(Frame& frame, const char* name, EventKind kind, Cell cell);
/// Where an event of the leading run came from: "line 21 of UpdateVertex, in replan 3".
std::string origin_text(Frame& frame, std::size_t event);
/// Over the canvas, its lower right corner at `corner`: why the playhead stopped, or what it looks for.
void draw_stop(Frame& frame, ImVec2 corner);

/// Beside the pinned cell on its pane at `min`..`max`: "Why?", and what explains the cell's value once that was clicked.
void draw_why_chip(Frame& frame, const Scene& scene, ImVec2 min, ImVec2 max);

/// All overlays with their switches, keys and explanations; for popups and menus.
/// In as many columns as there is room for.
void draw_overlay_switches(Frame& frame, float room);
/// How wide they are then.
float overlay_switches_width(const Look& look, float room);
/// The pseudo-code block with the current line lit; `around` > 0: only so many lines about it. `scrolled` is the line
/// that the window was scrolled to last, and follows the current one; nullptr: the window stays as it is.
void draw_pseudo_code(Frame& frame, const PseudoBlock& block, int around, int* scrolled = nullptr);

}  // namespace replan::ui
