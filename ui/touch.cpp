#include "ui/touch.hpp"

#include <algorithm>
#include <cmath>

#include "ui/keys.hpp"

namespace replan::ui {
namespace {

constexpr int kLeftButton = 0, kRightButton = 1;

}  // namespace

Touches::Finger* Touches::find(long id) {
  const auto found =
      std::find_if(fingers_.begin(), fingers_.end(), [id](const Finger& each) { return each.id == id; });
  return found == fingers_.end() ? nullptr : &*found;
}

Touches::Pair Touches::pair() const {
  const Finger &a = fingers_[0], &b = fingers_[1];
  return {(a.x + b.x) * 0.5f, (a.y + b.y) * 0.5f, std::hypot(a.x - b.x, a.y - b.y)};
}

bool Touches::strayed(float x, float y) const {
  return std::hypot(x - start_x_, y - start_y_) > measures_.slack;
}

bool Touches::scrolls(float x, float y) const {
  return ground_ == TouchGround::panel ||
         (ground_ == TouchGround::row && std::abs(y - start_y_) > std::abs(x - start_x_));
}

void Touches::begin(long id, float x, float y, double time) {
  if (find(id) != nullptr) return;
  fingers_.push_back({id, x, y});
  if (fingers_.size() == 1) {
    mode_ = Mode::waits;
    ground_.reset();
    start_x_ = seen_x_ = x;
    start_y_ = seen_y_ = y;
    start_time_ = time;
    strayed_ = false;
    queue_.mouse_move(x, y);  // so that the next frame tells what lies there
  } else if (fingers_.size() == 2 && mode_ != Mode::spent) {
    begin_two();
  }
}

void Touches::begin_two() {
  if (mode_ == Mode::drags) queue_.mouse_button(kLeftButton, false);
  mode_ = Mode::two;
  before_ = pair();
}

void Touches::move(long id, float x, float y, double time) {
  Finger* finger = find(id);
  if (finger == nullptr) return;
  finger->x = x;
  finger->y = y;
  if (mode_ == Mode::waits) {
    strayed_ = strayed_ || strayed(x, y);
    decide(time);
  } else if (mode_ == Mode::drags) {
    queue_.mouse_move(x, y);
  } else if (mode_ == Mode::scrolls) {
    scroll_to(x, y);
  }
}

void Touches::end(long id, float x, float y, double time) {
  move(id, x, y, time);
  if (find(id) == nullptr) return;
  if (mode_ == Mode::waits) {
    // Between two frames nobody could tell what lay there; what was drawn or dragged shall not be lost.
    if (strayed_ && scrolls(x, y))
      scroll_to(x, y);
    else if (strayed_)
      drag_from_start();
    else
      click();
  } else if (mode_ == Mode::two) {
    follow_two();
  }
  if (mode_ == Mode::drags) queue_.mouse_button(kLeftButton, false);
  std::erase_if(fingers_, [id](const Finger& each) { return each.id == id; });
  mode_ = Mode::spent;
  if (fingers_.empty()) leave();
}

void Touches::cancel() {
  if (mode_ == Mode::drags) queue_.mouse_button(kLeftButton, false);
  if (fingers_.empty()) return;
  fingers_.clear();
  leave();
}

void Touches::leave() {
  mode_ = Mode::none;
  used_ = true;
  queue_.mouse_leave();
}

void Touches::update(double now, TouchGround under) {
  // Once nothing waits any more, the last frame had the pointer under the first finger.
  if (active() && !ground_ && queue_.empty()) ground_ = under;
  if (mode_ == Mode::waits) decide(now);
  if (mode_ == Mode::two) follow_two();
}

void Touches::decide(double now) {
  const double held = now - start_time_;
  if (!strayed_) {
    if (held >= measures_.long_press && ground_) press_long();
    return;
  }
  if (held < measures_.patience || !ground_) return;
  const Finger& finger = fingers_.front();
  if (scrolls(finger.x, finger.y)) {
    mode_ = Mode::scrolls;
    scroll_to(finger.x, finger.y);
  } else {
    drag_from_start();
  }
}

/// The right button; over the world with Shift, as tools have a use of their own for the button alone.
void Touches::press_long() {
  const bool world = ground_ == TouchGround::world;
  if (world) queue_.key(key::kLeftShift, true);
  queue_.mouse_button(kRightButton, true);
  queue_.mouse_button(kRightButton, false);
  if (world) queue_.key(key::kLeftShift, false);
  mode_ = Mode::spent;
}

void Touches::click() {
  queue_.mouse_button(kLeftButton, true);
  queue_.mouse_button(kLeftButton, false);
}

void Touches::drag_from_start() {
  const Finger& finger = fingers_.front();
  queue_.mouse_button(kLeftButton, true);
  queue_.mouse_move(finger.x, finger.y);
  mode_ = Mode::drags;
}

void Touches::scroll_to(float x, float y) {
  const float across = x - seen_x_, down = y - seen_y_;
  seen_x_ = x;
  seen_y_ = y;
  if (across == 0 && down == 0) return;
  // Of both directions the one in which the finger goes: a panel does not slip aside.
  const bool upright = std::abs(y - start_y_) >= std::abs(x - start_x_);
  queue_.wheel(upright ? 0 : across / measures_.wheel_notch, upright ? down / measures_.wheel_notch : 0);
}

void Touches::follow_two() {
  if (!ground_ || fingers_.size() < 2) return;
  const Pair now = pair();
  if (ground_ == TouchGround::world) {
    const bool apart = now.apart > measures_.slack && before_.apart > measures_.slack;
    const float factor = apart ? now.apart / before_.apart : 1.0f;
    if (now.x != before_.x || now.y != before_.y || factor != 1.0f)
      queue_.pinch({before_.x, before_.y, now.x, now.y, factor});
  } else if (now.y != before_.y) {
    queue_.wheel(0, (now.y - before_.y) / measures_.wheel_notch);
  }
  before_ = now;
}

}  // namespace replan::ui
