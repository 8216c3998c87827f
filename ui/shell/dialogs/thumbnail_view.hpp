// Thumbnails on the screen: the texture and what is drawn over it.
#pragma once

#include "ui/documents/preview.hpp"
#include "ui/gl/imgui_renderer.hpp"
#include "ui/look.hpp"

namespace replan::ui {

/// The texture of one thumbnail, made anew if another theme is chosen. Its renderer's context must be current
/// in draw() and in the destructor.
class ThumbnailView {
 public:
  explicit ThumbnailView(ImGuiRenderer& renderer) : renderer_(&renderer) {}
  ThumbnailView(const ThumbnailView&) = delete;
  ThumbnailView& operator=(const ThumbnailView&) = delete;
  ~ThumbnailView() { clear(); }

  void show(Thumbnail thumbnail);
  void clear();
  /// Draws it as large as it fits into the rectangle, centred, with its start and goal.
  void draw(const Look& look, ImDrawList& list, ImVec2 min, ImVec2 max);

 private:
  ImGuiRenderer* renderer_;
  Thumbnail thumbnail_;
  ImTextureID texture_ = nullptr;
  bool dark_ = false;  // the theme that the texture was made for
};

}  // namespace replan::ui
