// A film of the window or its canvas, recorded while the user works.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/film/film.hpp"
#include "core/base/background.hpp"
#include "core/base/result.hpp"
#include "ui/image.hpp"
#include "ui/shell/recording.hpp"

namespace replan::app {

/// The part of a picture that lies in the area, `width` x `height` pixels from the area's upper left; black
/// where the picture does not reach.
ui::Image cut_out(const ui::Image& picture, const ui::PixelArea& area, int width, int height);

/// What became of a film: a sentence for the user.
struct FilmOutcome {
  std::string sentence;
  bool bad = false;
};

class Recording {
 public:
  /// `place`: where films are completed; its wake() is called when one is.
  explicit Recording(WorkPlace place) : finisher_(std::move(place)) {}
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  ~Recording() = default;

  /// Begins a film of that area's size, which it keeps: if the area shrinks the rest is black, if it grows
  /// the rest is not in the film.
  Result<void> start(const ui::CaptureRequest& request, const ui::PixelArea& area);
  /// Whether a film that is made for itself may take its next frame now (Film::ready()).
  [[nodiscard]] bool ready() const { return film_ != nullptr && film_->ready(); }
  /// The next frame, out of the window's pixels. Waits if the writing is behind; no frame is dropped.
  void take(const ui::Image& picture, const ui::PixelArea& area);
  /// Takes no more frames and leaves no film; a folder keeps the pictures that it has.
  void give_up() { film_.reset(); }
  /// Takes no more frames and completes the file in the background.
  void stop();
  /// The outcome, once, when there is one.
  std::optional<FilmOutcome> outcome();
  /// Completes the film here and now, if there is one: for the end of the program.
  std::optional<FilmOutcome> end();

  [[nodiscard]] bool on() const { return film_ != nullptr; }
  [[nodiscard]] bool of_window() const { return request_.window; }
  /// Seconds that go by from frame to frame.
  [[nodiscard]] double step() const { return 1.0 / request_.film.fps; }
  [[nodiscard]] ui::RecordingState state() const;

 private:
  [[nodiscard]] FilmOutcome completed(Film& film) const;

  ui::CaptureRequest request_;
  int width_ = 0, height_ = 0;
  std::size_t frames_ = 0;
  std::unique_ptr<Film> film_;
  std::optional<FilmOutcome> broken_;  // of a film that ended before its time
  Background<FilmOutcome> finisher_;   // last: it ends before what it uses
};

}  // namespace replan::app
