#include "ui/shell/dialogs.hpp"

#include <algorithm>

namespace replan::ui {
namespace {

constexpr const char* kPopup = "dialog";

}  // namespace

void Dialogs::show(DialogKind kind, std::string text) {
  kind_ = kind;
  fresh_ = true;
  text_ = std::move(text);
  error_.clear();
}

Decision Dialogs::draw(const Look& look) {
  if (kind_ == DialogKind::none) return {};
  if (!ImGui::IsPopupOpen(kPopup)) ImGui::OpenPopup(kPopup);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width =
      std::min(kind_ == DialogKind::keys ? look.px(880) : look.px(460), screen.x - look.px(32));
  ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.45f}, ImGuiCond_Always, {0.5f, 0.45f});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y - look.px(32)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(24), look.px(20)));
  const bool shown =
      ImGui::BeginPopupModal(kPopup, nullptr,
                             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PopStyleVar();
  if (!shown) return {};
  Decision decision = content(look);
  fresh_ = false;
  if (decision.kind != Decision::Kind::none && decision.kind != Decision::Kind::open &&
      decision.kind != Decision::Kind::save)
    close();
  if (kind_ == DialogKind::none) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return decision;
}

Decision Dialogs::content(const Look& look) {
  switch (kind_) {
    case DialogKind::open:
      return path_dialog(look, false);
    case DialogKind::save:
      return path_dialog(look, true);
    case DialogKind::new_world:
      return new_world_dialog(look);
    case DialogKind::unsaved:
      return unsaved_dialog(look);
    case DialogKind::keys:
      return keys_dialog(look);
    case DialogKind::none:
      break;
  }
  return {};
}

}  // namespace replan::ui
