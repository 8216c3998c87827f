// What shall become of unsaved edits.
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/widgets.hpp"

namespace replan::ui {

Decision Dialogs::unsaved_dialog(const Look& look) {
  heading(look, "Save the changes?");
  paragraph(look.fonts.ui, look.theme.dim,
            text_ + " has edits that are not in a file yet. Without saving they are lost.");
  ImGui::Dummy({0, look.px.xs});
  if (button(look, "Discard", ButtonKind::danger)) return {Decision::Kind::discard, {}, 0, 0};
  ImGui::SameLine(0, look.px.s);
  align_right(button_width(look, "Cancel") + look.px.s + button_width(look, "Save"));
  if (button(look, "Cancel", ButtonKind::quiet) || escape_pressed())
    return {Decision::Kind::cancel, {}, 0, 0};
  ImGui::SameLine(0, look.px.s);
  if (button(look, "Save", ButtonKind::primary) || enter_pressed())
    return {Decision::Kind::save_first, {}, 0, 0};
  return {};
}

}  // namespace replan::ui
