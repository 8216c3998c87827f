// What a window does on every platform: a frame.
#include "app/platform/window.hpp"

#include <algorithm>
#include <utility>

#include "ui/gl/read_picture.hpp"

namespace replan::app {

void Window::draw_frame(const std::function<bool()>& frame, int width, int height, double now) {
  // A long sleep is no motion: animations go on from where they were.
  const double elapsed = pace_ > 0 ? pace_ : std::min(now - last_time_, 0.1);
  last_time_ = now;
  if (width <= 0 || height <= 0) return;
  // ImGui needs a few frames to come to rest.
  settle_frames_ = stage_->wants_frame() ? 3 : std::max(settle_frames_ - 1, 0);
  bool moving = false;
  stage_->frame(width, height, static_cast<float>(elapsed), [&] {
    moving = frame();
    update_cursor();
  });
  stage_->render();
  if (moving) settle_frames_ = std::max(settle_frames_, 1);
  if (taker_) std::exchange(taker_, nullptr)(ui::read_picture(gl_, width, height));
}

}  // namespace replan::app
