// Fingers on a screen, as what a mouse would have done: a tap is a click, a drag holds the left button, a long press is the
// right one, two fingers pan and zoom. It reads no clock and draws nothing: times come with the events.
#pragma once

#include <optional>
#include <vector>

#include "ui/input.hpp"

namespace replan::ui {

/// What lies under the finger that came first.
enum class TouchGround {
  world,    ///< the canvas
  control,  ///< something that can be pressed or dragged
  row,      ///< the same in a panel that scrolls: a drag up or down scrolls it
  panel     ///< between controls: there a drag scrolls
};

/// Distances in pixels of the display.
struct TouchMeasures {
  float slack = 6;          ///< a finger that rests does not rest quite still
  float wheel_notch = 70;   ///< how far a panel scrolls by one notch of a wheel
  double patience = 0.06;   ///< seconds that a second finger has to make it a gesture of two
  double long_press = 0.5;  ///< seconds
};

class Touches {
 public:
  explicit Touches(InputQueue& queue) : queue_(queue) {}

  void set_measures(const TouchMeasures& measures) { measures_ = measures; }

  void begin(long id, float x, float y, double time);
  void move(long id, float x, float y, double time);
  void end(long id, float x, float y, double time);
  /// The system has taken the fingers for something of its own.
  void cancel();
  /// Before each frame: `under` is what the last one had under the pointer.
  void update(double now, TouchGround under);

  /// Whether the pointer was a finger last; a mouse says so by put_aside().
  [[nodiscard]] bool used() const { return used_; }
  /// There is a screen to be touched, and nothing says that there is a mouse.
  void expect() { used_ = true; }
  void put_aside() { used_ = false; }

  /// While a finger is down, frames are wanted: time alone makes a long press.
  [[nodiscard]] bool active() const { return !fingers_.empty(); }

 private:
  enum class Mode {
    none,
    waits,    ///< one finger, of which it is not known yet what it does
    drags,    ///< the left button is down
    scrolls,  ///< the panel, by one finger
    two,      ///< pan and zoom, or scroll
    spent     ///< until all fingers are lifted
  };
  struct Finger {
    long id;
    float x, y;
  };
  /// Of two fingers, in one frame.
  struct Pair {
    float x = 0, y = 0;  ///< the middle
    float apart = 0;
  };

  [[nodiscard]] Finger* find(long id);
  [[nodiscard]] Pair pair() const;
  [[nodiscard]] bool strayed(float x, float y) const;
  /// Whether a finger that has come there scrolls what it lies on.
  [[nodiscard]] bool scrolls(float x, float y) const;
  void begin_two();
  void decide(double now);
  void press_long();
  void click();
  void drag_from_start();
  void scroll_to(float x, float y);
  void follow_two();
  /// The last finger is gone, and so is the pointer: there is no hovering.
  void leave();

  InputQueue& queue_;
  TouchMeasures measures_;
  std::vector<Finger> fingers_;  // in the order in which they came
  Mode mode_ = Mode::none;
  std::optional<TouchGround> ground_;  // once a frame has had the pointer there
  float start_x_ = 0, start_y_ = 0;    // of the first finger
  double start_time_ = 0;
  bool strayed_ = false;           // it has left its place since
  float seen_x_ = 0, seen_y_ = 0;  // up to where it has scrolled
  bool used_ = false;              // not before the finger is lifted: nothing moves under it
  Pair before_;                    // up to where two fingers have been followed
};

}  // namespace replan::ui
