// Which moments of a run a film of it shows: a pure function of the run and what is asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/session/run.hpp"

namespace replan {

/// One picture of a film.
struct FilmFrame {
  std::size_t position = 0;  ///< in the event log
  double travel = 1;         ///< how far the robot is on its way into the cell where it stands then, 0 to 1

  friend bool operator==(const FilmFrame&, const FilmFrame&) = default;
};

/// How much of the run goes by from frame to frame.
struct FilmSpeed {
  enum class Kind : std::uint8_t {
    automatic,  ///< a search in about two seconds, then one robot move per frame, or a smooth robot's at its
                ///< speed
    events,     ///< so many events per frame
    expansion,  ///< one expansion per frame
    move,       ///< one robot move per frame; searches are passed over
    moves_per_second,  ///< so many robot moves per second; a search in about two seconds
  } kind = Kind::automatic;
  double number = 0;  ///< for events and moves_per_second

  friend bool operator==(const FilmSpeed&, const FilmSpeed&) = default;
};

struct FilmOptions {
  int fps = 30;  ///< frames per second, 1 to kFastestFilm
  FilmSpeed speed = {};
  double hold = 1.0 / 3;       ///< seconds that a plan, a surprise or the end of the search stands still
  std::string from = "start";  ///< a moment; see moment_position()
  std::string to = "end";
};

inline constexpr int kFastestFilm = 60;
inline constexpr double kLongestHold = 60;           ///< seconds
inline constexpr std::size_t kMostFrames = 100'000;  ///< of one film

/// Reads "auto", "expansion", "move", a number of events per frame ("50"), or robot moves per second ("4/s").
Result<FilmSpeed> parse_film_speed(std::string_view text);

/// The position of a moment of a finished run: a number of events, "start", "plan" (the first plan stands),
/// "replan:N" (the N-th replan stands), "move:N" (the robot has made its N-th move) or "end". An Error names
/// what there is.
Result<std::size_t> moment_position(const Run& run, std::string_view moment);

/// The frames of a film of the finished run, in order. It ends with a second on its last moment.
Result<std::vector<FilmFrame>> plan_film(const Run& run, const FilmOptions& options);

}  // namespace replan
