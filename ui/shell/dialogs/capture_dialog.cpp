// What to call a film or a picture of the window.
#include <imgui.h>
#include <imgui_stdlib.h>

#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

DialogDecision Dialogs::capture_dialog(const Look& look, bool film) {
  heading(look, film ? "Record a film" : "Save a picture");
  paragraph(look.fonts.ui, look.theme.dim,
            film ? "The ending of the name decides the format: .gif, .webp or .mp4 (all made by FFmpeg), or "
                   "a folder/ for "
                   "numbered pictures. While it records, time goes by frame by frame: none is dropped."
                 : "The ending of the name decides the format: .png as it is on the screen, or .svg as a "
                   "drawing of the "
                   "canvas.");
  if (fresh_) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##path", film ? "folder/name.gif" : "folder/name.png", &capture_path_,
                           ImGuiInputTextFlags_AutoSelectAll);
  hint(look, {"File", "", "A file of that name is replaced once the new one is complete."});
  if (film)
    slider(look,
           {.label = "Frames per second", .min = 10, .max = 50, .initial = 30, .unit = "", .decimals = 0},
           fps_, {"Frames per second", "", "More are smoother and make a larger file."});
  const Answer answer = confirm(look, film ? "Record" : "Save");
  if (answer == Answer::none) return {};
  DialogDecision decision;
  decision.kind = answer == Answer::yes ? DialogDecision::Kind::capture : DialogDecision::Kind::cancel;
  decision.path = capture_path_;
  decision.fps = static_cast<int>(fps_);
  return decision;
}

}  // namespace replan::ui
