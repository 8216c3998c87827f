// The overlays: one field at most, any number of marks.
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

void overlay_switch(Frame& frame, const OverlayInfo& info, float width) {
  const Look& look = frame.look;
  const Action& each = action(overlay_action(info.overlay));
  bool on = frame.view.view.overlays.has(info.overlay);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImGui::BeginGroup();
  const bool clicked =
      info.is_field() ? choice(look, each.label.c_str(), on) : toggle(look, each.label.c_str(), on);
  if (clicked) frame.view.view.overlays.set(info.overlay, on);
  if (!each.keys.empty()) {
    ImGui::SetCursorScreenPos(
        {origin.x + width - text_width(look.fonts.small, each.keys) - look.px(10), origin.y + look.px(3)});
    key_chip(look, each.keys.c_str());
  }
  ImGui::SetCursorScreenPos(origin);
  ImGui::Dummy({width, look.px(20)});
  ImGui::EndGroup();
  hint(look, each.hint());
}

/// Over what the colours reach, below the fields.
void range_switch(Frame& frame) {
  const Action& each = action(ActionId::range_so_far);
  FieldSpan& range = frame.view.view.range;
  bool on = range == FieldSpan::so_far;
  ImGui::Dummy({0, frame.look.px.xs});
  if (toggle(frame.look, each.label.c_str(), on)) range = on ? FieldSpan::so_far : FieldSpan::whole_run;
  hint(frame.look, each.hint());
}

/// By what fields are coloured.
void colour_choices(Frame& frame) {
  for (const ActionId id : {ActionId::colours_viridis, ActionId::colours_cividis, ActionId::colours_grey}) {
    const Action& each = action(id);
    bool on = each.rules.checked(context_of(frame));
    if (choice(frame.look, each.label.c_str(), on)) perform(frame, id);
    hint(frame.look, each.hint());
  }
}

}  // namespace

void draw_overlay_switches(Frame& frame) {
  const Look& look = frame.look;
  const float width = look.px(190);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px.l, look.px(6)));
  ImGui::BeginGroup();
  section_title(look, "One colour map at a time");
  for (const OverlayInfo& info : overlays())
    if (info.is_field()) overlay_switch(frame, info, width);
  range_switch(frame);
  ImGui::Dummy({0, look.px.xs});
  colour_choices(frame);
  ImGui::EndGroup();
  ImGui::SameLine(0, look.px(28));
  ImGui::BeginGroup();
  section_title(look, "Marks");
  for (const OverlayInfo& info : overlays())
    if (!info.is_field()) overlay_switch(frame, info, width);
  ImGui::EndGroup();
  ImGui::PopStyleVar();
}

}  // namespace replan::ui
