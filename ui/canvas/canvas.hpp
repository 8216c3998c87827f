// The canvas: a pane of the world with its plan, pan and zoom, and the tools' hands on it.
#pragma once

#include <memory>
#include <vector>

#include <imgui.h>

#include "core/scene/scene.hpp"
#include "core/session/session.hpp"
#include "ui/canvas/view_state.hpp"
#include "ui/gl/imgui_renderer.hpp"
#include "ui/look.hpp"

namespace replan::ui {

/// Draws a run into the current ImGui window's rectangle and turns input on it into commands.
class Canvas {
 public:
  explicit Canvas(ImGuiRenderer& renderer);
  ~Canvas();

  /// Draws pane `pane` of the session at `min`..`max` (screen coordinates), of which the lowest `below` pixels are left
  /// free by a fitted world. With `interactive` the mouse pans, zooms, hovers, pins and uses the tool; commands that come of
  /// it are appended to `commands`. With `may_wait` what takes long is left to the next frame.
  void draw(const Look& look, const Session& session, std::size_t pane, ViewState& state, ImVec2 min,
            ImVec2 max, bool interactive, std::vector<Command>& commands, float below = 0,
            bool may_wait = false);

  /// Whether it was drawn as it was before, or not at all, since it was left to the next frame.
  [[nodiscard]] bool behind() const;
  /// What was drawn last.
  [[nodiscard]] const Scene& scene() const;
  /// Makes the next draw show the whole world.
  void fit();
  /// The world is another one from now on: what was of the old one is forgotten at once and not by the next draw(), so that
  /// what is chosen meanwhile stays.
  void take_over(const Box& world, ViewState& state);
  /// True while a zoom is on its way or something is being worked out: further frames are due without input.
  [[nodiscard]] bool animating() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace replan::ui
