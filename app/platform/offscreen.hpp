// Frames without a display, through OSMesa: the same drawing code as the window's, into memory. REPLAN_GL=es draws with the
// shaders of OpenGL ES.
#pragma once

#include <functional>
#include <memory>

#include "core/base/result.hpp"
#include "ui/gl/stage.hpp"
#include "ui/image.hpp"

namespace replan::app {

struct OffscreenSettings {
  int width = 1440;  ///< pixels of the picture
  int height = 900;
  float scale = 1.0f;
};

class Offscreen {
 public:
  static Result<std::unique_ptr<Offscreen>> create(const OffscreenSettings& settings);
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

  /// Look, theme, scripted input, textures. Textures may only be touched inside frame()'s `draw`.
  [[nodiscard]] ui::Stage& stage() { return *stage_; }
  /// Draws one frame. Windows that ImGui sizes by their content settle in the second frame.
  /// Time advances by a fixed step, so that films repeat exactly.
  void frame(const std::function<void()>& draw, float seconds = 1.0f / 60.0f);
  /// The pixels of the last frame, which are filled here: most of what a frame takes, and few are looked at.
  [[nodiscard]] ui::Image picture();

 private:
  struct Context;

  explicit Offscreen(const OffscreenSettings& settings);

  OffscreenSettings settings_;
  std::unique_ptr<Context> context_;
  ui::Gl gl_;
  std::unique_ptr<ui::Stage> stage_;
};

}  // namespace replan::app
