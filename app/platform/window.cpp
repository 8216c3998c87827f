// What a window does on every platform: a frame, and its picture.
#include "app/platform/window.hpp"

#include <algorithm>
#include <utility>

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
  if (moving) settle_frames_ = std::max(settle_frames_, 1);
  if (taker_) std::exchange(taker_, nullptr)(picture(width, height));
}

ui::Image Window::picture(int width, int height) const {
  ui::Image image{width, height, {}};
  const auto row = static_cast<std::size_t>(image.width) * 4;
  image.rgba.resize(row * static_cast<std::size_t>(image.height));
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  // OpenGL's first row is the lowest.
  for (std::size_t top = 0, bottom = static_cast<std::size_t>(image.height); top + 1 < bottom; ++top) {
    --bottom;
    std::swap_ranges(image.rgba.begin() + static_cast<std::ptrdiff_t>(top * row),
                     image.rgba.begin() + static_cast<std::ptrdiff_t>((top + 1) * row),
                     image.rgba.begin() + static_cast<std::ptrdiff_t>(bottom * row));
  }
  return image;
}

}  // namespace replan::app
