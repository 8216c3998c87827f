// What a film of the window or its canvas shows: what the user chooses, and what comes of it for the run as it is.
#pragma once

#include <cstdint>
#include <string>

#include "core/session/film_plan.hpp"

namespace replan::ui {

/// How much of the run a film shows.
enum class FilmPart : std::uint8_t {
  live,    ///< what the user does from now on, until it is stopped
  replan,  ///< the search that the playhead is in or behind
  whole,   ///< from the start to where the robot ends
};

struct FilmChoice {
  FilmPart part = FilmPart::live;
  int width = 0;  ///< pixels; 0: as what is filmed. A live film has always its size
  int height = 0;
  int fps = 30;
  FilmSpeed speed = {};  ///< of all but a live film

  friend bool operator==(const FilmChoice&, const FilmChoice&) = default;
};

/// What the film is of: "Replan 2", "The first plan", "The whole run".
std::string part_words(FilmPart part, const Run& run);
/// The moments that the film goes through. An Error: the run has not come that far yet.
Result<std::vector<FilmFrame>> film_frames(const FilmChoice& choice, const Run& run);
/// Whether all of that part is in the log.
bool is_complete(FilmPart part, const Run& run);

}  // namespace replan::ui
