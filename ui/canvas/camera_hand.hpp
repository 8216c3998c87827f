// The hand on a pane's camera: wheel, keys, buttons, the middle button, two fingers.
#pragma once

#include <imgui.h>

#include "core/lattice/seen_box.hpp"
#include "core/scene/scene.hpp"
#include "ui/canvas/view_state.hpp"
#include "ui/input.hpp"

namespace replan::ui {

/// What a camera looks at, and where it is seen on the screen.
struct CameraField {
  SeenBox box;
  Viewport viewport;
  ImVec2 min;  ///< of the viewport, on the screen
};

class CameraHand {
 public:
  /// The camera as it is drawn (resolve()).
  [[nodiscard]] static Camera resolved(const CameraField& field, const Camera& camera) {
    return resolve(camera, field.box.width(), field.box.height(), field.viewport);
  }

  /// What was asked for by keys and buttons. The camera is that of all panes: the first that is drawn takes it up.
  void take_wishes(const CameraField& field, ViewState& state);
  /// Begins to zoom by that factor, with what lies at a place of the screen staying there.
  void zoom_by(const CameraField& field, ViewState& state, double factor, ImVec2 at);
  /// By two fingers, at once: what lies under their middle goes with it.
  void pinch(const CameraField& field, ViewState& state, const Pinch& pinch);
  /// By the middle button, or by the left one while Space is down. It begins over the pane (`hovered`), if nothing else is
  /// held (`free`).
  void pan(const CameraField& field, ViewState& state, bool hovered, bool free);
  /// Moves a zoom that is on its way on by this frame.
  void glide(const CameraField& field, ViewState& state);
  /// Ends a zoom that is on its way, where the camera goes elsewhere.
  void stop() { zooming_.active = false; }

  [[nodiscard]] bool gliding() const { return zooming_.active; }
  [[nodiscard]] bool panning() const { return panning_; }

 private:
  /// A zoom on its way: towards `target`, with `anchor` staying where it is on the screen.
  struct Glide {
    double target = 0;
    Point anchor;
    ImVec2 at;
    bool active = false;
  };

  Glide zooming_;
  bool panning_ = false;
};

}  // namespace replan::ui
