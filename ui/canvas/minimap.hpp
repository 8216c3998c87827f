// A small picture of the whole world in a corner of a pane that shows only a part of it, with that part framed. A click or
// a drag on it moves the view.
#pragma once

#include <optional>

#include "core/scene/overview.hpp"
#include "ui/gl/imgui_renderer.hpp"
#include "ui/look.hpp"

namespace replan::ui {

/// Whether some of a scene's world is out of sight.
bool exceeds_view(const Scene& scene);

class Minimap {
 public:
  explicit Minimap(ImGuiRenderer& renderer) : renderer_(renderer) {}
  ~Minimap();
  Minimap(const Minimap&) = delete;
  Minimap& operator=(const Minimap&) = delete;

  /// In a window of its own, its lower right corner at `foot`, within the ID of its pane. Where the middle of the view is
  /// asked to go, in cells; nothing if the mouse asks for nothing.
  std::optional<Point> draw(const Look& look, const Run& run, SceneMemory& memory, const Scene& scene,
                            const Slice& slice, const Palette& palette, ImVec2 foot);

 private:
  void upload();
  void paint(const Look& look, const Run& run, const Scene& scene, Axis along, ImVec2 min, ImVec2 size) const;

  ImGuiRenderer& renderer_;
  OverviewKeeper keeper_;
  ImTextureID texture_ = nullptr;
  int width_ = 0, height_ = 0;  // of the texture
};

}  // namespace replan::ui
