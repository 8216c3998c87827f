// The overlays: one field at most, any number of marks.
#include <algorithm>
#include <vector>

#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// Design pixels.
constexpr float kSwitchColumn = 190, kSwitchGap = 28;
/// One of fields, two of marks.
constexpr std::size_t kMostSwitchColumns = 3;

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

/// Those that are fields, and what goes with them.
void draw_fields(Frame& frame, float width) {
  const Look& look = frame.look;
  ImGui::BeginGroup();
  section_title(look, "One colour map at a time");
  for (const OverlayInfo& info : overlays())
    if (info.is_field()) overlay_switch(frame, info, width);
  range_switch(frame);
  ImGui::Dummy({0, look.px.xs});
  colour_choices(frame);
  ImGui::EndGroup();
}

/// The others, in so many columns.
void draw_marks(Frame& frame, float width, std::size_t columns) {
  const Look& look = frame.look;
  std::vector<const OverlayInfo*> marks;
  for (const OverlayInfo& info : overlays())
    if (!info.is_field()) marks.push_back(&info);
  const std::size_t rows = (marks.size() + columns - 1) / columns;
  ImGui::BeginGroup();
  section_title(look, "Marks");
  for (std::size_t first = 0; first < marks.size(); first += rows) {
    if (first > 0) ImGui::SameLine(0, look.px(kSwitchGap));
    ImGui::BeginGroup();
    for (std::size_t i = first; i < std::min(first + rows, marks.size()); ++i)
      overlay_switch(frame, *marks[i], width);
    ImGui::EndGroup();
  }
  ImGui::EndGroup();
}

std::size_t columns_in(const Look& look, float room) {
  return static_cast<std::size_t>(
      std::clamp((room + look.px(kSwitchGap)) / look.px(kSwitchColumn + kSwitchGap), 1.0f,
                 static_cast<float>(kMostSwitchColumns)));
}

}  // namespace

float overlay_switches_width(const Look& look, float room) {
  const auto columns = static_cast<float>(columns_in(look, room));
  return columns * look.px(kSwitchColumn) + (columns - 1) * look.px(kSwitchGap);
}

void draw_overlay_switches(Frame& frame, float room) {
  const Look& look = frame.look;
  const std::size_t columns = columns_in(look, room);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px.l, look.px(6)));
  draw_fields(frame, look.px(kSwitchColumn));
  if (columns > 1) ImGui::SameLine(0, look.px(kSwitchGap));
  draw_marks(frame, look.px(kSwitchColumn), std::max<std::size_t>(columns - 1, 1));
  ImGui::PopStyleVar();
}

}  // namespace replan::ui
