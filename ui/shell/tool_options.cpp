// Under the side panel: what can be chosen for what is selected, else for the tool.
#include "core/scene/script.hpp"
#include "ui/icons.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tools/mover.hpp"
#include "ui/tools/surprise.hpp"

namespace replan::ui {
namespace {

bool mover_is_selected(const Frame& frame) {
  const std::optional<std::size_t>& mover = frame.view.editing.mover;
  return mover && *mover < frame.session.scenario().movers.size();
}

bool surprise_is_selected(const Frame& frame) {
  const std::optional<std::size_t>& surprise = frame.view.editing.surprise;
  return surprise && *surprise < frame.session.scenario().surprises.size();
}

/// Undo, or time, may have taken away what was selected. What is about to be added is not there yet.
void forget_what_is_gone(Frame& frame) {
  Editing& editing = frame.view.editing;
  const Scenario& scenario = frame.session.scenario();
  if (!frame.commands.empty()) return;
  if (editing.mover && *editing.mover >= scenario.movers.size()) editing.mover.reset();
  const bool is_gone = editing.surprise && (*editing.surprise >= scenario.surprises.size() ||
                                            !is_to_come(frame.session.run(), *editing.surprise));
  if (is_gone) editing.surprise.reset();
}

}  // namespace

void draw_remove_button(Frame& frame) {
  const bool pressed = button(frame.look, "Remove", ButtonKind::danger, icon::trash);
  hint(frame.look, action(ActionId::delete_selected).hint());
  if (pressed) perform(frame, ActionId::delete_selected);
}

bool has_tool_options(const Frame& frame) {
  return mover_is_selected(frame) || surprise_is_selected(frame) ||
         frame.view.tools.chosen().has_options(frame.view);
}

void draw_tool_options(Frame& frame) {
  forget_what_is_gone(frame);
  if (!has_tool_options(frame)) return;
  edge(frame.look, Edge::left);
  edge(frame.look, Edge::top);
  if (mover_is_selected(frame))
    draw_selected_mover(frame);
  else if (surprise_is_selected(frame))
    draw_selected_surprise(frame);
  else
    frame.view.tools.chosen().draw_options(frame);
  const float height = ImGui::GetCursorPosY() + frame.look.px.xs;
  if (height != frame.panels.tool_height)
    frame.panels.animated = true;  // it takes its place in the next frame
  frame.panels.tool_height = height;
}

}  // namespace replan::ui
