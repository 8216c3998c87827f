// What the program is, and what it is made of.
#include <algorithm>

#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

DialogDecision Dialogs::about_dialog(const Look& look) {
  heading(look, "About Replan");
  paragraph(look.fonts.ui, look.theme.text, "A desktop laboratory for robot path planning and replanning.");
  paragraph(look.fonts.ui, look.theme.dim,
            "Free software under the MIT licence, without any warranty. It is made of these:");
  ImGui::Dummy({0, look.px.xs});
  float names = 0;
  for (const AboutLine& line : about_) names = std::max(names, text_width(look.fonts.ui, line.name));
  for (const AboutLine& line : about_) {
    text(look.fonts.ui, look.theme.dim, line.name);
    ImGui::SameLine(look.px(24) + names + look.px.l);
    text(look.fonts.mono, look.theme.text, line.version);
  }
  ImGui::Dummy({0, look.px.xs});
  align_right(button_width(look, "Close"));
  const bool closed = button(look, "Close", ButtonKind::plain) || escape_pressed() || enter_pressed();
  return closed ? DialogDecision{.kind = DialogDecision::Kind::cancel} : DialogDecision{};
}

}  // namespace replan::ui
