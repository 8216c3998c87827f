// Pictures of a scenario without a display: a still, a vector drawing, or a folder of frames of the whole
// run.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "core/scene/view.hpp"
#include "core/session/session.hpp"
#include "core/world/scenario.hpp"
#include "ui/canvas.hpp"

namespace replan::app {

/// The moment of a still.
enum class Moment : std::uint8_t {
  plan,  ///< the first plan stands
  end,   ///< the mission is over
};

struct RenderRequest {
  Scenario scenario;
  std::string output;  ///< `.png`, `.svg`, or a folder for frames (it ends in '/', or is one already)
  int width = 1440;    ///< pixels of the picture
  int height = 900;
  double scale = 1;                                     ///< device pixels per design pixel
  std::optional<std::string> theme;                     ///< "light" or "dark"; else the scenario's, else dark
  std::optional<OverlaySet> overlays;                   ///< else the scenario's, else the window's
  std::variant<Moment, std::size_t> at = Moment::plan;  ///< or the position in the event log; for stills
  std::optional<Cell> pinned;
  bool legend = true;
  bool window = false;  ///< the whole window rather than the canvas alone; not for `.svg`
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< called after each frame of a folder
};

/// Frames per second that a folder of frames is made for.
inline constexpr int kFramesPerSecond = 30;

/// Draws what is asked for. The same request gives the same pixels each time.
Result<void> render(const RenderRequest& request);

/// The view that a request asks for: overlays, camera and theme of request, scenario or window, in that
/// order.
Result<ui::ViewState> requested_view(const RenderRequest& request);

/// The positions in the log that a film of the run shows: each move of the robot, each repair by a few
/// frames, and of the first plan about two seconds.
std::vector<std::size_t> film_positions(const Run& run);

}  // namespace replan::app
