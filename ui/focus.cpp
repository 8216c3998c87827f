#include "ui/focus.hpp"

#include <algorithm>
#include <utility>

#include <imgui_internal.h>

#include "ui/keys.hpp"

namespace replan::ui {

void KeyboardFocus::begin_frame() {
  before_ = std::exchange(order_, {});
  arrived_ = false;
  const bool gone = std::find(before_.begin(), before_.end(), at_) == before_.end();
  const bool clicked = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2);
  if (gone || clicked) shown_ = false;
  if (gone) at_ = 0;
  // Who clicks into a field goes on from there.
  const ImGuiID active = ImGui::GetActiveID();
  if (std::find(before_.begin(), before_.end(), active) != before_.end()) at_ = active;
  take_keys();
}

void KeyboardFocus::take_keys() {
  ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl || io.KeyAlt || io.KeySuper) return;
  const bool has_tab = tab_owner_ != 0 && ImGui::GetActiveID() == tab_owner_;
  if (ImGui::IsKeyPressed(key::kTab) && !has_tab) move(io.KeyShift ? -1 : 1);
  if (in_menu() && !io.WantTextInput) {
    if (ImGui::IsKeyPressed(key::kDown)) move(1);
    if (ImGui::IsKeyPressed(key::kUp)) move(-1);
  }
  if (!shown_ || io.WantTextInput) return;
  if (ImGui::IsKeyPressed(key::kSpace, false)) ImGui::ActivateItem(at_);
  // A dialog's own Enter must not answer otherwise than the button that the ring is around.
  for (const int enter : {key::kEnter, key::kKeypadEnter}) {
    if (field_ || !ImGui::IsKeyPressed(enter, false)) continue;
    ImGui::ActivateItem(at_);
    key::take(io, enter);
  }
  const bool covered = ImGui::GetCurrentContext()->OpenPopupStack.Size > 0;
  if (covered || !ImGui::IsKeyPressed(key::kEscape, false)) return;
  shown_ = false;
  key::take(io, key::kEscape);
}

void KeyboardFocus::move(int by) {
  if (before_.empty()) return;
  const auto found = std::find(before_.begin(), before_.end(), at_);
  const auto count = static_cast<std::ptrdiff_t>(before_.size());
  const std::ptrdiff_t from = found == before_.end() ? (by > 0 ? -1 : count) : found - before_.begin();
  at_ = before_[static_cast<std::size_t>((from + by + count) % count)];
  shown_ = arrived_ = true;
  if (ImGui::GetActiveID() != 0) ImGui::ClearActiveID();  // a field that is left keeps what was typed
}

/// Nothing lies over the current window that keeps hands off it.
bool KeyboardFocus::in_reach() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.OpenPopupStack.Size == 0) return true;
  const ImGuiWindow* top = context.OpenPopupStack.back().Window;
  const ImGuiWindow* window = ImGui::GetCurrentWindow();
  return top != nullptr && window->RootWindow == top->RootWindow;
}

/// What lies over the window is a menu or a list of choices; a dialog's arrows are its own.
bool KeyboardFocus::in_menu() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.OpenPopupStack.Size == 0) return false;
  const ImGuiWindow* top = context.OpenPopupStack.back().Window;
  return top != nullptr && (top->Flags & ImGuiWindowFlags_Modal) == 0;
}

void KeyboardFocus::note(ImGuiID id) {
  if (in_reach()) order_.push_back(id);
}

bool KeyboardFocus::here() const {
  return shown_ && at_ == ImGui::GetItemID();
}

void KeyboardFocus::offer(ImU32 ring, float rounding, float width) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if ((context.LastItemData.InFlags & ImGuiItemFlags_Disabled) != 0) return;
  note(ImGui::GetItemID());
  if (!here()) return;
  field_ = false;
  if (arrived_ && !ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.5f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  list.PushClipRectFullScreen();
  list.AddRect({min.x - width, min.y - width}, {max.x + width, max.y + width}, ring, rounding, 0, width);
  list.PopClipRect();
}

bool KeyboardFocus::takes_arrows() {
  if (here()) arrows_of_ = at_;
  return here();
}

void KeyboardFocus::begin_at_item() {
  at_ = ImGui::GetItemID();
  shown_ = false;
}

void KeyboardFocus::come_back_to_item() {
  at_ = ImGui::GetItemID();
  shown_ = !ImGui::IsMouseReleased(0) && !ImGui::IsMouseClicked(0);
}

void KeyboardFocus::leave_tab_to_it() {
  tab_owner_ = ImGui::GetItemID();
}

void KeyboardFocus::offer_field(const char* id) {
  const ImGuiID own = ImGui::GetID(id);
  note(own);
  if (at_ == own) field_ = true;
  if (arrived_ && at_ == own) ImGui::SetKeyboardFocusHere();
}

}  // namespace replan::ui
