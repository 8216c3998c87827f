#include "ui/canvas/camera_hand.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace replan::ui {
namespace {

/// What one step of zooming comes to, and how far one of panning goes.
constexpr double kZoomStep = 1.25, kPanStep = 80;
/// How much of what is left of a zoom is gone after a second: all but e to the minus this.
constexpr double kGlide = 18;

double zoom_within(const CameraField& field, double zoom, const ViewState& state) {
  const double fitted = CameraHand::resolved(field, {}).zoom;
  const double most = std::max(fitted, 200 * state.view.scale);
  return std::clamp(zoom, std::min(fitted, 1.0) / 2, most);
}

/// A place of the screen, from the middle of the viewport on.
Point from_middle(const CameraField& field, double x, double y) {
  return {x - field.min.x - field.viewport.width / 2.0, y - field.min.y - field.viewport.height / 2.0};
}

/// What lies at a place of the screen.
Point seen_at(const CameraField& field, const Camera& camera, double x, double y) {
  const Point from = from_middle(field, x, y);
  return {camera.x + from.x / camera.zoom, camera.y + from.y / camera.zoom};
}

/// Moves the camera so that a point of the world lies at a place of the screen.
void hold(const CameraField& field, Camera& camera, Point point, double x, double y) {
  const Point from = from_middle(field, x, y);
  camera.x = point.x - from.x / camera.zoom;
  camera.y = point.y - from.y / camera.zoom;
}

Camera& camera_of(const CameraField& field, ViewState& state) {
  return state.camera(field.box.along());
}

}  // namespace

void CameraHand::take_wishes(const CameraField& field, ViewState& state) {
  const ImVec2 middle(field.min.x + static_cast<float>(field.viewport.width) * 0.5f,
                      field.min.y + static_cast<float>(field.viewport.height) * 0.5f);
  if (const int steps = std::exchange(state.zoom_steps, 0); steps != 0)
    zoom_by(field, state, std::pow(kZoomStep, steps), middle);
  const int x = std::exchange(state.pan_x, 0), y = std::exchange(state.pan_y, 0);
  if (x == 0 && y == 0) return;
  stop();
  Camera& camera = camera_of(field, state);
  camera = resolved(field, camera);
  camera.x += x * kPanStep * state.view.scale / camera.zoom;
  camera.y += y * kPanStep * state.view.scale / camera.zoom;
}

void CameraHand::zoom_by(const CameraField& field, ViewState& state, double factor, ImVec2 at) {
  Camera& camera = camera_of(field, state);
  camera = resolved(field, camera);
  const double from = zooming_.active ? zooming_.target : camera.zoom;
  zooming_ = {zoom_within(field, from * factor, state), seen_at(field, camera, at.x, at.y), at, true};
}

void CameraHand::pinch(const CameraField& field, ViewState& state, const Pinch& pinch) {
  stop();
  Camera& camera = camera_of(field, state);
  camera = resolved(field, camera);
  const Point kept = seen_at(field, camera, pinch.from_x, pinch.from_y);
  camera.zoom = zoom_within(field, camera.zoom * static_cast<double>(pinch.factor), state);
  hold(field, camera, kept, pinch.to_x, pinch.to_y);
}

void CameraHand::pan(const CameraField& field, ViewState& state, bool hovered, bool free) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool space = ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Space)) && !io.WantTextInput;
  const bool grabs = ImGui::IsMouseClicked(ImGuiMouseButton_Middle) ||
                     (space && ImGui::IsMouseClicked(ImGuiMouseButton_Left));
  if (hovered && grabs && free) {
    panning_ = true;
    state.panned = space;
  }
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Middle) && !ImGui::IsMouseDown(ImGuiMouseButton_Left))
    panning_ = false;
  if (panning_ || (hovered && space)) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  if (!panning_ || (io.MouseDelta.x == 0 && io.MouseDelta.y == 0)) return;
  stop();
  Camera& camera = camera_of(field, state);
  if (camera.zoom <= 0) camera = resolved(field, camera);
  camera.x -= static_cast<double>(io.MouseDelta.x) / camera.zoom;
  camera.y -= static_cast<double>(io.MouseDelta.y) / camera.zoom;
}

void CameraHand::glide(const CameraField& field, ViewState& state) {
  if (!zooming_.active) return;
  Camera& camera = camera_of(field, state);
  // Something else shows the whole world meanwhile.
  if (camera.zoom <= 0) return stop();
  const double rest = std::log(zooming_.target / camera.zoom);
  const double step = 1 - std::exp(-kGlide * static_cast<double>(ImGui::GetIO().DeltaTime));
  zooming_.active = std::abs(rest) > 0.004;
  camera.zoom = zooming_.active ? camera.zoom * std::exp(rest * step) : zooming_.target;
  hold(field, camera, zooming_.anchor, zooming_.at.x, zooming_.at.y);
}

}  // namespace replan::ui
