// Films and pictures of one window: what its user asks for is carried out with the window's pixels.
#pragma once

#include <optional>

#include "app/film_maker.hpp"
#include "app/platform/window.hpp"
#include "app/recording.hpp"
#include "core/session/session.hpp"
#include "ui/shell/shell.hpp"

namespace replan::app {

class Capture {
 public:
  /// All three outlive it.
  Capture(Window& window, ui::Shell& shell, Session& session)
      : window_(window), shell_(shell), session_(session) {}

  /// What goes by in the session from one frame to the next, of which the clock says `passed` seconds: the frames of a
  /// film are as far apart as they are shown.
  [[nodiscard]] double seconds(double passed) const {
    return recording_.on() && !maker_.on() ? recording_.step() : passed;
  }
  /// Before a frame: the panels are told how a film stands.
  void report();
  /// After a frame: takes up what was asked for in it, and takes its pixels for a film.
  void follow();
  [[nodiscard]] bool wants_frames() const { return settling_ > 0 || maker_.on(); }
  /// The window's end: completes what is being recorded, out of the user's sight.
  void end();

 private:
  void take_up(const ui::CaptureRequest& request);
  void carry_out(const ui::CaptureRequest& request);
  Result<void> make_film(const ui::CaptureRequest& request);
  void take_picture(const ui::CaptureRequest& request);
  void tell_of_picture(const std::string& path, const Result<void>& written, const std::string& note);
  [[nodiscard]] ui::PixelArea area(bool window) const;

  Window& window_;
  ui::Shell& shell_;
  Session& session_;
  Recording recording_{WorkPlace::beside(Window::wake)};
  FilmMaker maker_{recording_};
  std::optional<ui::CaptureRequest> wanted_;  // by the user, and not begun yet
  int settling_ = 0;                          // frames until the dialog has gone from the pixels
};

}  // namespace replan::app
