// Questions: what shall become of unsaved edits, of a file that has changed, of work from before a crash; and
// the wait for a file that is being read.
#include "core/base/file.hpp"
#include "ui/icons.hpp"
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

DialogDecision Dialogs::question_dialog(const Look& look) {
  heading(look, question_.title);
  paragraph(look.fonts.ui, look.theme.dim, question_.words);
  ImGui::Dummy({0, look.px.xs});
  if (question_.danger) {
    if (button(look, question_.danger->label.c_str(), ButtonKind::danger))
      return {.kind = question_.danger->decision};
    ImGui::SameLine(0, look.px.s);
  }
  const char *no = question_.quiet.label.c_str(), *yes = question_.primary.label.c_str();
  const bool two = !question_.quiet.label.empty();
  align_right((two ? button_width(look, no) + look.px.s : 0) + button_width(look, yes));
  if ((two && button(look, no, ButtonKind::quiet)) || escape_pressed())
    return {.kind = question_.quiet.decision};
  if (two) ImGui::SameLine(0, look.px.s);
  if (button(look, yes, ButtonKind::primary) || enter_pressed()) return {.kind = question_.primary.decision};
  return {};
}

DialogDecision Dialogs::recover_dialog(const Look& look) {
  const bool one = notes_.size() == 1;
  heading(look, "Recover unsaved work?");
  paragraph(
      look.fonts.ui, look.theme.dim,
      one ? "The program ended before these edits were saved. They are not lost."
          : "The program ended before these edits were saved. They are not lost; each stays on offer until "
            "it is recovered or discarded.");
  DialogDecision decision;
  for (std::size_t i = 0; i < notes_.size(); ++i) {
    const AutosaveNote& note = notes_[i];
    section_rule(look);
    ImGui::PushID(static_cast<int>(i));
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    const float buttons = button_width(look, "Discard") + look.px.s + button_width(look, "Recover");
    const float y = ImGui::GetCursorPosY(), room = right - buttons - look.px.l - ImGui::GetCursorPosX();
    const std::string name = !note.file.empty()  ? file_name(note.file)
                             : note.name.empty() ? "untitled"
                                                 : note.name;
    ImGui::BeginGroup();
    text_line(look, look.fonts.title, look.theme.text, name, room);
    const std::string edits = count_text(static_cast<std::int64_t>(note.edits), "edit", "edits");
    text_line(look, look.fonts.ui, look.theme.dim,
              "edited " + date_text(note.edited_at) + " · " + edits + " not saved", room);
    ImGui::EndGroup();
    hint(look, {"", "", note.file.empty() ? "It was in no file yet." : note.file.c_str()});
    const float end = ImGui::GetCursorPosY();
    ImGui::SetCursorPos({right - buttons, y + look.px.xs});
    if (button(look, "Discard", ButtonKind::danger))
      decision = {.kind = DialogDecision::Kind::forget, .index = i};
    ImGui::SameLine(0, look.px.s);
    const bool enter = i == 0 && !fresh_ && enter_pressed();
    if (button(look, "Recover", i == 0 ? ButtonKind::primary : ButtonKind::plain) || enter)
      decision = {.kind = DialogDecision::Kind::recover, .index = i};
    ImGui::SetCursorPosY(end);
    ImGui::PopID();
  }
  section_rule(look);
  align_right(button_width(look, "Later"));
  if (button(look, "Later", ButtonKind::quiet) || escape_pressed())
    decision = {.kind = DialogDecision::Kind::cancel};
  return decision;
}

DialogDecision Dialogs::opening_dialog(const Look& look) {
  const int seconds = static_cast<int>(ImGui::GetTime() - since_);
  heading(look, "Opening " + name_);
  progress(look, -1, seconds < 2 ? "Reading…" : "Reading… " + std::to_string(seconds) + " s");
  ImGui::Dummy({0, look.px.xs});
  align_right(button_width(look, "Cancel"));
  if (button(look, "Cancel", ButtonKind::plain) || (!fresh_ && escape_pressed()))
    return {.kind = DialogDecision::Kind::cancel};
  return {};
}

}  // namespace replan::ui
