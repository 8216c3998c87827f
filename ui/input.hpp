// Input events in the order they came. ImGui 1.86 reads input as a state once per frame, so a key that is
// pressed and released between two frames would be lost; here it is spread over two frames instead.
#pragma once

#include <deque>

#include <imgui.h>

namespace replan::ui {

class InputQueue {
 public:
  void mouse_move(float x, float y);
  void mouse_leave();
  void mouse_button(int button, bool down);
  void wheel(float x, float y);
  void key(int key, bool down);
  void character(unsigned code_point);
  /// The window lost the focus: no key or button may stay down.
  void release_all();

  /// Applies events until one would hide another from ImGui; the rest wait for the next frame.
  void feed(ImGuiIO& io);
  [[nodiscard]] bool empty() const { return events_.empty(); }

 private:
  enum class Kind { move, button, wheel, key, character, release };
  struct Event {
    Kind kind;
    int code = 0;  // button, key or code point
    bool down = false;
    float x = 0;
    float y = 0;
  };
  /// What this frame has taken so far.
  struct Taken {
    bool moved = false;
    bool wheeled = false;
    bool keyed = false;
    bool typed = false;
    unsigned buttons = 0;  // a bit for each button that changed
  };

  [[nodiscard]] static bool must_wait(const Event& event, const Taken& taken);
  static void take(const Event& event, Taken& taken, ImGuiIO& io);

  std::deque<Event> events_;
};

}  // namespace replan::ui
