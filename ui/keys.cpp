#include "ui/keys.hpp"

#include <cfloat>

namespace replan::ui::key {

void take(ImGuiIO& io, int key) {
  // Only a duration of 0 is a press, and only a long one repeats.
  if (io.KeysDown[key]) io.KeysDownDuration[key] = FLT_MIN;
}

void install(ImGuiIO& io) {
  static_assert(kCount <= IM_ARRAYSIZE(ImGuiIO::KeysDown));
  constexpr struct {
    ImGuiKey name;
    int key;
  } kMap[] = {
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
  io.KeyMap[ImGuiKey_Tab] = -1;  // see focus.hpp
  for (const auto& entry : kMap) io.KeyMap[entry.name] = entry.key;
}

}  // namespace replan::ui::key
