// The path of a file to open or to save.
#include <imgui_stdlib.h>

#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/widgets.hpp"

namespace replan::ui {

Decision Dialogs::path_dialog(const Look& look, bool saving) {
  heading(look, saving ? "Save as" : "Open");
  paragraph(look.fonts.ui, look.theme.dim,
            saving ? "A scenario (.json) holds the world, the planners, the robot and the surprises; a map "
                     "(.map) the cells alone."
                   : "A scenario (.json), a MovingAI map (.map) or a picture (.png), dark pixels being "
                     "obstacles. You can also drop a file onto the window.");
  if (fresh_) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##path", saving ? "folder/name.json" : "path of a file", &text_))
    error_.clear();
  if (!error_.empty()) paragraph(look.fonts.ui, look.theme.bad, error_);
  const Answer answer = confirm(look, saving ? "Save" : "Open");
  if (answer == Answer::none) return {};
  if (answer == Answer::no) return {Decision::Kind::cancel, {}, 0, 0};
  return {saving ? Decision::Kind::save : Decision::Kind::open, text_, 0, 0};
}

}  // namespace replan::ui
