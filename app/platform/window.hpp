// The window: it feeds its input to the stage and sleeps while nothing happens. GLFW opens it; in a browser it is the
// page's canvas (app/web/page_window.cpp).
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "ui/gl/stage.hpp"
#include "ui/image.hpp"

namespace replan::app {

struct WindowSettings {
  std::string title = "Replan";
  int width = 1440;  ///< in screen coordinates, before scaling
  int height = 900;
  bool maximized = false;
  float scale = 0;  ///< 0: the environment's REPLAN_SCALE, else the display's own
};

class Window {
 public:
  /// Fails with a sentence that says how to render without a display.
  static Result<std::unique_ptr<Window>> open(const WindowSettings& settings);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  [[nodiscard]] ui::Stage& stage() { return *stage_; }

  /// Calls `frame` inside each ImGui frame until the window closes. It returns whether it wants the next
  /// frame at once (something moves); otherwise the window sleeps until input, wake(), or a moment has
  /// passed. In a page it returns at once, and the browser goes on calling; the window must stay.
  void run(std::function<bool()> frame);
  /// Ends run() after this frame.
  void close();
  /// Asks for a frame; from any thread.
  static void wake();

  /// Files dropped onto the window.
  void on_drop(std::function<void(std::vector<std::filesystem::path>)> handler) {
    drop_ = std::move(handler);
  }
  /// Asked when the user closes the window; returns whether it may close (nothing unsaved).
  void on_close(std::function<bool()> handler) { may_close_ = std::move(handler); }

  /// From now on a frame is drawn every so many seconds and takes exactly so long for what moves, however
  /// long the drawing takes; 0: frames are drawn as they are needed.
  void pace(double seconds) { pace_ = seconds; }
  /// Takes the window off the display; the program goes on.
  void hide();

  void set_title(const std::string& title);
  /// Size and state now, to be remembered for the next start.
  [[nodiscard]] WindowSettings state() const;
  /// Hands the pixels of the next frame over, once, as soon as it is drawn.
  void capture(std::function<void(ui::Image)> taker) { taker_ = std::move(taker); }

  /// What the platform holds, and what it calls.
  struct System;

 private:
  Window();
  Result<void> start(const WindowSettings& settings);
  /// One frame of that many pixels at that time, in seconds; shows nothing yet.
  void draw_frame(const std::function<bool()>& frame, int width, int height, double now);
  /// Whether a frame is due.
  [[nodiscard]] bool busy() const { return settle_frames_ > 0 || stage_->wants_frame() || taker_ != nullptr; }
  /// A few more frames than are asked for: input may open, close or hover something.
  void settle() { settle_frames_ = 3; }
  void update_cursor();

  std::unique_ptr<System> system_;
  ui::Gl gl_;
  std::unique_ptr<ui::Stage> stage_;
  std::function<void(std::vector<std::filesystem::path>)> drop_;
  std::function<bool()> may_close_;
  std::function<void(ui::Image)> taker_;
  WindowSettings settings_;
  double last_time_ = 0;
  double pace_ = 0;
  int settle_frames_ = 3;  // frames still to draw before sleeping
};

}  // namespace replan::app
