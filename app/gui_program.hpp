// The program behind a window: a session, the shell that shows it, what is remembered, and what is recorded.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/capture.hpp"
#include "app/first_document.hpp"
#include "app/gui_settings.hpp"
#include "app/platform/window.hpp"
#include "core/link/link.hpp"
#include "core/session/session.hpp"
#include "ui/shell/shell.hpp"

namespace replan::app {

/// Everything of one window.
class GuiProgram {
 public:
  GuiProgram(FirstDocument document, Remembered remembered, WorkPlace work);

  Result<void> open();
  /// As Window::run().
  void run();
  /// The end: what is remembered is written.
  Result<void> close();
  /// Writes what the next start is to know of this window.
  void remember();
  /// Takes files as if they were dropped onto the window.
  void drop(const std::vector<std::string>& paths) { shell_->documents().drop(session_, paths); }
  /// Opens the world of a link at its moment; asks first if there are unsaved edits.
  void open_link(const std::string& link) { shell_->open_link(session_, link); }
  /// The link to this moment.
  [[nodiscard]] Result<std::string> link() const { return shell_->link(session_); }
  /// What links begin with that are copied here.
  void set_link_address(const std::string& address) { shell_->panels().link_address = address; }
  /// A sentence over the canvas.
  void tell(const std::string& sentence, bool bad) { shell_->tell(sentence, bad); }
  /// Facts of the session, for tests: JSON.
  [[nodiscard]] std::string facts() const;

 private:
  void begin_with_link();
  bool frame();
  void follow();
  void report_first_frame();
  void report_slow_frame(double update_ms, double draw_ms);

  using Clock = std::chrono::steady_clock;

  Clock::time_point begun_ = Clock::now();
  Remembered remembered_;
  std::string batch_;               // what the window begins with, if that is no world
  bool asked_for_;                  // FirstDocument::asked_for
  const std::optional<Link> link_;  // that the program was begun with
  Session session_;                 // plans while the window is being opened
  std::unique_ptr<Window> window_;
  std::unique_ptr<ui::Shell> shell_;  // goes before the window: it holds textures
  std::optional<Capture> capture_;    // from open() on
  Clock::time_point last_ = Clock::now();
  double draw_ms_ = 0;     // of a frame
  double drawing_ms_ = 0;  // of that, without the session's update
  std::string title_;
  bool dark_ = true;
  std::string words_;  // that the fonts were baked for, beside the usual characters
  bool timed_ = false;
  const bool timing_;  // slow frames are reported
};

}  // namespace replan::app
