// Which control has the keyboard, over all panels and dialogs. ImGui's own navigation would take keys that are ours, and
// its Tab stays in one window and passes over buttons.
#pragma once

#include <vector>

#include <imgui.h>

namespace replan::ui {

/// Tab goes to the next control, Shift+Tab to the one before; Space and Enter press it; Escape or a click gives the
/// keyboard back to the window's own keys. While something lies over the window, Tab goes through that alone, and
/// through a menu or a list of choices so do Down and Up.
class KeyboardFocus {
 public:
  /// At the beginning of ImGui's frame.
  void begin_frame();
  /// The last item is a control: Tab can come to it. Draws the ring around it if it has the keyboard.
  void offer(ImU32 ring, float rounding, float width);
  /// A field for text, about to be drawn under that name: gives it the keyboard when Tab comes to it.
  void offer_field(const char* id);
  /// The last item, in a list that has just opened over the window, is where Up and Down begin.
  void begin_at_item();
  /// The list that the last item had opened has been closed: it has the keyboard again, if it was closed by a key.
  void come_back_to_item();
  /// The last item is a field in which Tab means something else while it has the keyboard.
  void leave_tab_to_it();

  /// A control has the keyboard: plain Space, and Escape, are for it.
  [[nodiscard]] bool shown() const { return shown_; }
  /// The last item is changed by Left and Right; whether it has the keyboard.
  [[nodiscard]] bool takes_arrows();
  /// The control that has the keyboard is such a one.
  [[nodiscard]] bool has_arrows() const { return shown_ && arrows_of_ == at_; }
  /// The last item has the keyboard.
  [[nodiscard]] bool here() const;

 private:
  void take_keys();
  void move(int by);
  [[nodiscard]] static bool in_reach();
  [[nodiscard]] static bool in_menu();
  void note(ImGuiID id);

  std::vector<ImGuiID> order_, before_;             // of this frame and of the last one
  ImGuiID at_ = 0, tab_owner_ = 0, arrows_of_ = 0;  // 0: none
  bool shown_ = false;                              // it was come to by the keyboard
  bool field_ = false;                              // it is a field, in which Enter ends what is typed
  bool arrived_ = false;                            // in this frame
};

}  // namespace replan::ui
