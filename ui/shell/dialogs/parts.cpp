#include "ui/shell/dialogs/parts.hpp"

#include <algorithm>

#include <imgui_internal.h>

#include "ui/keys.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

int open_lists() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return std::max(context.OpenPopupStack.Size - context.BeginPopupStack.Size, 0);
}

bool escape_pressed() {
  if (!ImGui::IsKeyPressed(key::kEscape, false)) return false;
  if (open_lists() == 0) return true;
  ImGui::ClosePopupToLevel(ImGui::GetCurrentContext()->BeginPopupStack.Size, true);
  ImGui::GetIO().KeysDownDuration[key::kEscape] = ImGui::GetIO().DeltaTime;  // no longer just pressed
  return false;
}

bool enter_pressed() {
  return open_lists() == 0 &&
         (ImGui::IsKeyPressed(key::kEnter, false) || ImGui::IsKeyPressed(key::kKeypadEnter, false));
}

void heading(const Look& look, std::string_view words) {
  text(look.fonts.heading, look.theme.text, words);
  ImGui::Dummy({0, look.px(2)});
}

void align_right(float width) {
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, ImGui::GetContentRegionAvail().x - width));
}

float button_width(const Look& look, const char* label, const char* icon) {
  return text_width(look.fonts.ui, label) + look.px(icon[0] == '\0' ? 24 : 24 + 22);
}

void flow(const Look& look, float width) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (ImGui::GetItemRectMax().x + look.px.s + width <= right) ImGui::SameLine(0, look.px.s);
}

Answer confirm(const Look& look, const char* yes, const char* no) {
  ImGui::Dummy({0, look.px.xs});
  align_right(button_width(look, no) + look.px.s + button_width(look, yes));
  Answer answer = Answer::none;
  if (button(look, no, ButtonKind::quiet) || escape_pressed()) answer = Answer::no;
  ImGui::SameLine(0, look.px.s);
  if (button(look, yes, ButtonKind::primary) || enter_pressed()) answer = Answer::yes;
  return answer;
}

void fact(const Look& look, const char* name, const std::string& value) {
  text(look.fonts.ui, look.theme.dim, name);
  ImGui::SameLine(look.px(84));
  text_line(look, look.fonts.mono, look.theme.text, value, ImGui::GetContentRegionAvail().x);
}

}  // namespace replan::ui
