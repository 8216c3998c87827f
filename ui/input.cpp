#include "ui/input.hpp"

#include <algorithm>
#include <cfloat>

#include "ui/keys.hpp"

namespace replan::ui {

void InputQueue::mouse_move(float x, float y) {
  // Only the newest of several moves in a row counts.
  if (!events_.empty() && events_.back().kind == Kind::move) events_.pop_back();
  events_.push_back({.kind = Kind::move, .x = x, .y = y});
}

void InputQueue::mouse_leave() {
  mouse_move(-FLT_MAX, -FLT_MAX);
}

void InputQueue::mouse_button(int button, bool down) {
  if (button < 0 || button >= IM_ARRAYSIZE(ImGuiIO::MouseDown)) return;
  events_.push_back({.kind = Kind::button, .code = button, .down = down});
}

void InputQueue::wheel(float x, float y) {
  events_.push_back({.kind = Kind::wheel, .x = x, .y = y});
}

void InputQueue::pinch(const Pinch& pinch) {
  if (!events_.empty() && events_.back().kind == Kind::pinch) {
    Pinch& last = events_.back().pinch;
    last = {last.from_x, last.from_y, pinch.to_x, pinch.to_y, last.factor * pinch.factor};
    return;
  }
  events_.push_back({.kind = Kind::pinch, .pinch = pinch});
}

void InputQueue::key(int key, bool down) {
  if (key < 0 || key >= key::kCount) return;
  events_.push_back({.kind = Kind::key, .code = key, .down = down});
}

void InputQueue::character(unsigned code_point) {
  events_.push_back({.kind = Kind::character, .code = static_cast<int>(code_point)});
}

void InputQueue::release_all() {
  events_.push_back({.kind = Kind::release});
}

void InputQueue::feed(ImGuiIO& io) {
  Taken taken;
  pinch_.reset();
  while (!events_.empty() && !must_wait(events_.front(), taken)) {
    take(events_.front(), taken, io);
    events_.pop_front();
  }
  io.KeyCtrl = io.KeysDown[key::kLeftControl] || io.KeysDown[key::kRightControl];
  io.KeyShift = io.KeysDown[key::kLeftShift] || io.KeysDown[key::kRightShift];
  io.KeyAlt = io.KeysDown[key::kLeftAlt] || io.KeysDown[key::kRightAlt];
  io.KeySuper = io.KeysDown[key::kLeftSuper] || io.KeysDown[key::kRightSuper];
}

bool InputQueue::must_wait(const Event& event, const Taken& taken) {
  switch (event.kind) {
    case Kind::move:  // a click belongs to the place where it was made
      return taken.buttons != 0 || taken.wheeled || taken.keyed;
    case Kind::button:
      return (taken.buttons >> event.code & 1u) != 0 || taken.wheeled || taken.keyed;
    case Kind::wheel:
      return taken.buttons != 0 || taken.keyed;
    case Kind::pinch:  // the pointer goes with it
      return taken.buttons != 0 || taken.wheeled || taken.keyed;
    case Kind::key:  // shortcuts are told by order: one change of a key per frame
      return taken.keyed || taken.typed || taken.buttons != 0;
    case Kind::character:
      return false;
    case Kind::release:
      return taken.keyed || taken.buttons != 0;
  }
  return false;
}

void InputQueue::take(const Event& event, Taken& taken, ImGuiIO& io) {
  switch (event.kind) {
    case Kind::move:
      io.MousePos = {event.x, event.y};
      taken.moved = true;
      break;
    case Kind::button:
      io.MouseDown[event.code] = event.down;
      taken.buttons |= 1u << event.code;
      break;
    case Kind::wheel:
      io.MouseWheelH += event.x;
      io.MouseWheel += event.y;
      taken.wheeled = true;
      break;
    case Kind::pinch:
      io.MousePos = {event.pinch.to_x, event.pinch.to_y};
      pinch_ = event.pinch;
      taken.wheeled = true;  // one in a frame, and a move after it waits
      break;
    case Kind::key:
      taken.keyed = io.KeysDown[event.code] != event.down;
      io.KeysDown[event.code] = event.down;
      break;
    case Kind::character:
      io.AddInputCharacter(static_cast<unsigned>(event.code));
      taken.typed = true;
      break;
    case Kind::release:
      std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
      std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
      break;
  }
}

}  // namespace replan::ui
