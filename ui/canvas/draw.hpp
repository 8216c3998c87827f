// A scene on the screen.
#pragma once

#include <imgui.h>

#include "core/scene/scene.hpp"
#include "ui/colormap.hpp"
#include "ui/look.hpp"

namespace replan::ui {

/// The colours of scenes under a theme.
Palette scene_palette(const Theme& theme, FieldColours colours = FieldColours::viridis);

/// From world to screen for a scene whose view begins at `min`.
struct Projection {
  ImVec2 min;
  Camera camera;
  int width, height;

  Projection(const Scene& scene, ImVec2 corner)
      : min(corner), camera(scene.camera), width(scene.width), height(scene.height) {}
  [[nodiscard]] ImVec2 operator()(Point at) const {
    return {min.x + static_cast<float>((at.x - camera.x) * camera.zoom + width / 2.0),
            min.y + static_cast<float>((at.y - camera.y) * camera.zoom + height / 2.0)};
  }
  [[nodiscard]] Point world(ImVec2 at) const {
    return {camera.x + (at.x - min.x - width / 2.0) / camera.zoom,
            camera.y + (at.y - min.y - height / 2.0) / camera.zoom};
  }
};

/// The scene's raster as a texture, of which it may fill only a part.
struct RasterTexture {
  ImTextureID id = nullptr;
  ImVec2 used{1, 1};  ///< texture coordinates of its lower right end
};

void draw_scene(ImDrawList& list, const Look& look, const Scene& scene, ImVec2 min,
                const RasterTexture& raster);

}  // namespace replan::ui
