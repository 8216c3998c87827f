// Films and pictures of the window: what the user asks for, and how it stands. Whoever owns the pixels
// carries it out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <imgui.h>

#include "ui/shell/film_choice.hpp"

namespace replan::ui {

/// What shall be taken, and into which file.
struct CaptureRequest {
  enum class Kind : std::uint8_t { film, stop, give_up, picture } kind = Kind::film;
  bool window = false;  ///< the whole window rather than the canvas
  std::string path;     ///< as a user's path is: absolute, or from the folder where the program was started
  FilmChoice film = {};
};

/// How a film that is being recorded stands; kept by the owner of the pixels for the panels to show.
struct RecordingState {
  bool on = false;         ///< frames are being taken
  bool finishing = false;  ///< all are taken, and the file is being completed
  bool window = false;
  double seconds = 0;  ///< length of the film so far
  double made =
      -1;  ///< of a film of a part of the run: how much of it is made, 0 to 1; below 0: none is being made

  [[nodiscard]] bool busy() const { return on || finishing || made >= 0; }
};

/// The area of the canvas in the last frame, in pixels from the upper left.
struct PixelArea {
  ImVec2 min, max;
};

/// A name by the clock, so that no older file is in its way: "replan-20260131-235959.gif".
std::string capture_name(const char* extension);
/// "0:07", "12:34".
std::string film_time(double seconds);

}  // namespace replan::ui
