// Pictures of a scenario without a display: a still, a vector drawing, a film, or a folder of its frames.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/film/film_settings.hpp"
#include "core/link/link.hpp"
#include "core/scene/orbit.hpp"
#include "core/scene/scene.hpp"
#include "core/scene/view.hpp"
#include "core/session/film_plan.hpp"
#include "core/session/session.hpp"
#include "core/world/scenario.hpp"
#include "ui/canvas/canvas.hpp"

namespace replan::app {

/// The moment of a still.
enum class Moment : std::uint8_t {
  plan,  ///< the first plan stands
  end,   ///< the mission is over
};

/// That of the link.
struct LinkMoment {};

struct RenderRequest {
  Scenario scenario;
  /// `.png`, `.svg`, `.gif`, `.webp`, `.mp4`, or a folder for frames (it ends in '/', or is one already)
  std::string output;
  /// What a link says of the moment and the look; what is said below comes before it.
  std::optional<LinkView> link = {};
  int width = 1440;  ///< pixels of the picture
  int height = 900;
  double scale = 1;                    ///< device pixels per design pixel
  std::optional<std::string> theme;    ///< "light" or "dark"; else the scenario's, else dark
  std::optional<OverlaySet> overlays;  ///< else the scenario's, else the window's
  std::variant<Moment, std::size_t, std::string, LinkMoment> at =
      Moment::plan;  ///< or a position in the event log, or as moment_position() reads it; for stills
  FieldSpan range = FieldSpan::whole_run;
  ui::FieldColours colours = ui::FieldColours::viridis;
  std::optional<Cell> pinned;
  std::optional<Twist> motion;              ///< of a driving robot: the one that is looked at
  std::optional<Slice> slice;               ///< the layer that is shown; else that of the start
  std::optional<Orbit> orbit;               ///< the world from outside, from there
  bool cut = false;                         ///< and cut at the slice
  bool glass = false;                       ///< and obstacles like glass
  bool follows_robot = false;               ///< the layer is that of the robot at each moment
  std::optional<ViewSetup::Camera> camera;  ///< else the scenario's, else the whole world
  bool legend = true;
  bool window = false;  ///< the whole window rather than the canvas alone; not for `.svg`
  /// How many planners are shown; nothing: all that there is room for in a window, one on a canvas alone.
  std::optional<std::size_t> panes;
  /// Of the window, done one after the other before a still is drawn: their identifiers in
  /// ui/shell/actions.def, such as "keys" for the page of keys. So pictures of dialogs and tabs are made.
  std::vector<std::string> actions;
  /// Of the window: the dialog or menu of ui/shell/gallery.hpp that is open, with contents that do not depend on the
  /// machine.
  std::string dialog;
  FilmOptions film;
  std::function<void(const std::string& sentence)> note;  ///< called with what there is to say besides
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< called after each frame of a film
};

/// Whether the output is a film or a folder of frames, and not a still.
bool is_film(const std::string& output);

/// Draws what is asked for. The same request gives the same pixels each time.
Result<void> render(const RenderRequest& request);

/// The size of the file that render() writes: that of the request but for an .mp4, whose sides are even.
FrameSize written_size(const RenderRequest& request);

/// Writes what a pane of that size shows of a run as a vector drawing (.svg); of one in 3D the slice.
Result<void> write_drawing(const std::string& path, const Run& run, const ui::ViewState& state,
                           std::size_t pane, Viewport size);
/// What there is to say of such a drawing: a sentence about what the pane shows and the drawing does not, or "".
std::string drawing_note(const Run& run, const ui::ViewState& state, std::size_t pane);

/// The view that a request asks for: overlays, camera and theme of request, scenario or window, in that
/// order.
Result<ui::ViewState> requested_view(const RenderRequest& request);

}  // namespace replan::app
