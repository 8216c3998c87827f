// A film of a part of the run, drawn anew at any size: a frame at a time between the frames of the window, which
// goes on showing the moment that its user looks at.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/recording.hpp"
#include "app/studio.hpp"
#include "core/session/session.hpp"

namespace replan::app {

/// What of a window's view shows in a film of it: not what the hand is at.
ui::ViewState filmed_view(const ui::ViewState& view);

/// What the window looks like from which the film is asked for.
struct FilmSet {
  ui::ViewState view;     ///< as filmed_view() makes it
  std::size_t panes = 0;  ///< as PanelState::panes
  ui::PixelArea area;     ///< of the window, or of its canvas
  double scale = 1;       ///< device pixels per design pixel
};

class FilmMaker {
 public:
  /// The frames go into `recording`, which completes the film or leaves none.
  explicit FilmMaker(Recording& recording) : recording_(recording) {}

  /// Sends the run on to its end where the film needs more than there is of it.
  Result<void> begin(const ui::CaptureRequest& request, FilmSet set, Session& session);
  /// One frame more. An Error: no film is left.
  Result<void> go_on(Session& session);
  /// Gives the film up: none is left.
  void cancel();

  [[nodiscard]] bool on() const { return at_work_; }
  /// How much of it is made, 0 to 1.
  [[nodiscard]] double share() const;

 private:
  Result<void> open(Session& session);
  Result<void> shoot(Session& session);
  void leave();

  Recording& recording_;
  ui::CaptureRequest request_;
  FilmSet set_;
  std::vector<FilmFrame> frames_;
  std::size_t next_ = 0;
  std::unique_ptr<Studio> studio_;
  std::size_t lead_ = 0, cursor_ = 0;  // of the session when the film was asked for: who leads in it
  std::uint64_t log_ = 0;              // Run::log_id()
  bool at_work_ = false;
};

}  // namespace replan::app
