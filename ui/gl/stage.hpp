// One ImGui context with its renderer, look and input: what the window and the headless platform have in
// common. The platform owns the GL context, makes it current, and brings size, time and input.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "ui/gl/gl.hpp"
#include "ui/gl/imgui_renderer.hpp"
#include "ui/input.hpp"
#include "ui/look.hpp"
#include "ui/touch.hpp"

struct ImGuiContext;

namespace replan::ui {

class Stage {
 public:
  /// `gl` must outlive the stage, and its context be current here, in frame() and in the destructor.
  static Result<std::unique_ptr<Stage>> create(const Gl& gl, float scale);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  [[nodiscard]] const Look& look() const { return look_; }
  [[nodiscard]] ImGuiRenderer& renderer() { return *renderer_; }
  [[nodiscard]] InputQueue& input() { return input_; }
  [[nodiscard]] Touches& touches() { return touches_; }
  /// Before a frame, where there are fingers: what they do by time alone.
  void follow_touches(double now);
  [[nodiscard]] ImGuiIO& io();
  /// Which fonts were missing; refilled whenever the fonts are baked.
  [[nodiscard]] const std::vector<std::string>& notices() const { return notices_; }

  // Each takes effect at the beginning of the next frame.
  void set_theme(const Theme& theme);
  void set_scale(float scale);
  /// How much larger than at that scale the user wants everything.
  void set_size(float size);
  /// Whether all that is pressed is large enough for fingers.
  void set_fingers(bool fingers);
  /// The language's characters (see FontOptions::also).
  void set_language(std::string also, bool chinese);

  /// One frame of width x height pixels: input and `draw`. `seconds` since the last frame. No pixel of it is filled
  /// before render().
  void frame(int width, int height, float seconds, const std::function<void()>& draw);
  /// Fills the pixels of the last frame, while what it shows still is.
  void render();
  /// Whether a further frame is due: input waits, the look has changed, or a tooltip is about to show.
  [[nodiscard]] bool wants_frame() const {
    return !input_.empty() || fonts_stale_ || style_stale_ || awaits_hint_ || touches_.active();
  }

 private:
  Stage();
  void refresh();
  void rescale();

  ImGuiContext* context_;
  std::unique_ptr<ImGuiRenderer> renderer_;
  InputQueue input_;
  Touches touches_{input_};
  KeyboardFocus focus_;
  Look look_;
  FontOptions font_options_;
  float scale_ = 1, size_ = 1;
  bool fingers_ = false;
  std::vector<std::string> notices_;
  bool fonts_stale_ = true;
  bool style_stale_ = true;
  bool awaits_hint_ = false;
};

}  // namespace replan::ui
