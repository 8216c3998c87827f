// Input events in the order they came. ImGui 1.86 reads input as a state once per frame, so a key that is
// pressed and released between two frames would be lost; here it is spread over two frames instead.
#pragma once

#include <deque>
#include <optional>
#include <utility>

#include <imgui.h>

namespace replan::ui {

/// Two fingers on the canvas: what lay under their middle goes with it, and grows by the factor.
struct Pinch {
  float from_x = 0, from_y = 0;
  float to_x = 0, to_y = 0;
  float factor = 1;
};

class InputQueue {
 public:
  void mouse_move(float x, float y);
  void mouse_leave();
  void mouse_button(int button, bool down);
  void wheel(float x, float y);
  void pinch(const Pinch& pinch);
  void key(int key, bool down);
  void character(unsigned code_point);
  /// The window lost the focus: no key or button may stay down.
  void release_all();

  /// Applies events until one would hide another from ImGui; the rest wait for the next frame.
  void feed(ImGuiIO& io);
  /// What the last feed() had of it, once.
  std::optional<Pinch> take_pinch() { return std::exchange(pinch_, std::nullopt); }
  [[nodiscard]] bool empty() const { return events_.empty(); }

 private:
  enum class Kind { move, button, wheel, pinch, key, character, release };
  struct Event {
    Kind kind;
    int code = 0;  // button, key or code point
    bool down = false;
    float x = 0;
    float y = 0;
    Pinch pinch = {};
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
  void take(const Event& event, Taken& taken, ImGuiIO& io);

  std::deque<Event> events_;
  std::optional<Pinch> pinch_;
};

}  // namespace replan::ui
