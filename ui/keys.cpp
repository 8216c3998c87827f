#include "ui/keys.hpp"

namespace replan::ui::key {

void install(ImGuiIO& io) {
  static_assert(kCount <= IM_ARRAYSIZE(ImGuiIO::KeysDown));
  constexpr struct {
    ImGuiKey name;
    int key;
  } kMap[] = {
      {ImGuiKey_Tab, kTab},
      {ImGuiKey_LeftArrow, kLeft},
      {ImGuiKey_RightArrow, kRight},
      {ImGuiKey_UpArrow, kUp},
      {ImGuiKey_DownArrow, kDown},
      {ImGuiKey_PageUp, kPageUp},
      {ImGuiKey_PageDown, kPageDown},
      {ImGuiKey_Home, kHome},
      {ImGuiKey_End, kEnd},
      {ImGuiKey_Insert, kInsert},
      {ImGuiKey_Delete, kDelete},
      {ImGuiKey_Backspace, kBackspace},
      {ImGuiKey_Space, kSpace},
      {ImGuiKey_Enter, kEnter},
      {ImGuiKey_KeyPadEnter, kKeypadEnter},
      {ImGuiKey_Escape, kEscape},
      {ImGuiKey_A, 'A'},
      {ImGuiKey_C, 'C'},
      {ImGuiKey_V, 'V'},
      {ImGuiKey_X, 'X'},
      {ImGuiKey_Y, 'Y'},
      {ImGuiKey_Z, 'Z'},
  };
  for (const auto& entry : kMap) io.KeyMap[entry.name] = entry.key;
}

}  // namespace replan::ui::key
