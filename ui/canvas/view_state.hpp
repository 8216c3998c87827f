// What the window remembers of itself.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "core/scene/orbit.hpp"
#include "core/scene/solid_scene.hpp"
#include "core/scene/view.hpp"
#include "core/world/map_frame.hpp"
#include "ui/canvas/editing.hpp"
#include "ui/canvas/slices.hpp"
#include "ui/colormap.hpp"
#include "ui/tools/tool_box.hpp"

namespace replan::ui {

/// No part of the document.
struct ViewState {
  View view;  ///< what all panes share: not the slice and, but along z, the camera
  Slices slices;
  /// Panes that are seen along the same axis share a camera.
  [[nodiscard]] const Camera& shown_camera(Axis axis) const {
    return axis == Axis::z ? view.camera : upright[axis == Axis::y];
  }
  [[nodiscard]] Camera& camera(Axis axis) { return axis == Axis::z ? view.camera : upright[axis == Axis::y]; }
  void fit_cameras() {
    view.camera = upright[0] = upright[1] = {};
    orbit.distance = 0;
  }
  std::array<Camera, 2> upright;  ///< along x and along y
  Orbit orbit;                    ///< of all panes that show the world from outside
  SolidOptions solid;
  ToolBox tools;
  int brush = 1;   ///< side of the brush in cells, 1 to 64
  int layers = 1;  ///< that tools draw in at once, from the one that shows on, 1 to 64
  Editing editing;
  bool dark = true;
  FieldColours colours = FieldColours::viridis;
  bool panels = true;  ///< side panel and tool strip shown
  std::string tab;     ///< the id of the chosen side tab; empty: the one that shows at first
  bool legend = true;
  bool metres = true;        ///< lengths in metres on a map that says how large its cells are; else in cells
  bool minimap = true;       ///< the whole world in a corner, while some of it is out of sight
  bool hides_panes = false;  ///< there is no room for all of them
  static constexpr int kSmallest = -3, kLargest = 8;
  bool large_targets = false;  ///< all that is pressed is large enough for fingers, also without any
  int size_step = 0;           ///< of words, buttons and panels, beside what the display asks for
  void resize_window(int by) { size_step = std::clamp(size_step + by, kSmallest, kLargest); }
  [[nodiscard]] float size() const { return 1 + 0.125f * static_cast<float>(size_step); }
  std::optional<Cell> menu;  ///< the cell whose menu is asked for
  /// The cell that the mouse was over last, and in which pane: what is told of it stays until it is over another one.
  struct Pointed {
    Cell cell;
    std::size_t pane = 0;
  };
  std::optional<Pointed> pointed;
  // Wishes, until somebody has seen to them.
  bool repair_asked = false;  ///< for what the last replan touched
  int zoom_steps = 0;         ///< in, or below 0 out
  int pan_x = 0, pan_y = 0;   ///< steps towards which the view goes
  bool panned = false;        ///< something was dragged while Space was down
  bool captured = false;  ///< a picture or a film is made of the canvas: what only serves its user stays away
  bool live = true;  ///< a window; else a picture, which shows no wall times and waits for what is worked out
};

/// The frame in which places and lengths of the map are shown; nothing: in cells.
inline std::optional<MapFrame> shown_frame(const ViewState& view, const GridMap& map) {
  return view.metres ? metric_frame(map) : std::nullopt;
}
/// The unit in which lengths of the map are told.
inline LengthUnit shown_lengths(const ViewState& view, const GridMap& map) {
  const auto frame = shown_frame(view, map);
  return {frame ? frame->metres_per_cell() : 0};
}

}  // namespace replan::ui
