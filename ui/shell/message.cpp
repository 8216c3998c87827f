#include "ui/shell/message.hpp"

#include <algorithm>

#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr auto kMessageTime = std::chrono::seconds(6), kErrorTime = std::chrono::seconds(15);

}  // namespace

void Message::tell(std::string sentence, Tone tone) {
  if (sentence.empty()) return;
  const auto time =
      tone == Tone::bad ? std::chrono::duration_cast<std::chrono::seconds>(kErrorTime) : kMessageTime;
  text_ = as_sentence(std::move(sentence));
  tone_ = tone;
  until_ = std::chrono::steady_clock::now() + time;
}

void Message::draw(const Look& look, ImVec2 min, ImVec2 max) {
  if (text_.empty()) return;
  if (std::chrono::steady_clock::now() > until_) {
    clear();
    return;
  }
  const float width = std::min(look.px(520), max.x - min.x - look.px.l * 2);
  const float words = std::min(text_width(look.fonts.ui, text_) + look.px(2), width - look.px(80));
  ImGui::SetNextWindowPos({(min.x + max.x) * 0.5f, max.y - look.px(56)}, ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowBgAlpha(0.96f);
  ImGui::Begin("message", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  switch (tone_) {
    case Tone::done:
      text(look.fonts.ui, look.theme.good, icon::check);
      break;
    case Tone::hint:
      text(look.fonts.ui, look.theme.accent, icon::info);
      break;
    case Tone::bad:
      text(look.fonts.ui, look.theme.bad, icon::warning);
  }
  ImGui::SameLine(0, look.px(10));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + words);
  text(look.fonts.ui, look.theme.text, text_);
  ImGui::PopTextWrapPos();
  ImGui::SameLine(0, look.px.m);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - look.px(5));
  if (small_button(look, "close", {.icon = icon::times, .hint = {"Close"}})) clear();
  ImGui::End();
}

}  // namespace replan::ui
