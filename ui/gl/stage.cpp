#include "ui/gl/stage.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <imgui_internal.h>

#include "ui/keys.hpp"

namespace replan::ui {
namespace {

/// Makes an ImGui context current for a scope: a headless stage may be drawn in the midst of a window's
/// frame.
class Current {
 public:
  explicit Current(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) {
    ImGui::SetCurrentContext(context);
  }
  ~Current() { ImGui::SetCurrentContext(before_); }
  Current(const Current&) = delete;
  Current& operator=(const Current&) = delete;

 private:
  ImGuiContext* before_;
};

/// What lies under the pointer, where that is not the world.
TouchGround ground_in(ImGuiContext& context) {
  ImGuiWindow* window = context.HoveredWindow;
  if (context.HoveredId == 0 || window == nullptr) return TouchGround::panel;
  const bool bar = context.HoveredId == ImGui::GetWindowScrollbarID(window, ImGuiAxis_Y);
  return window->ScrollMax.y > 0 && !bar ? TouchGround::row : TouchGround::control;
}

}  // namespace

Result<std::unique_ptr<Stage>> Stage::create(const Gl& gl, float scale) {
  std::unique_ptr<Stage> stage(new Stage);
  Result<std::unique_ptr<ImGuiRenderer>> renderer = ImGuiRenderer::create(gl);
  if (!renderer) return Error{renderer.error()};
  stage->renderer_ = std::move(*renderer);
  stage->set_scale(scale);
  const Current current(stage->context_);
  stage->refresh();
  return stage;
}

Stage::Stage() : context_(ImGui::CreateContext()) {
  const Current current(context_);
  ImGuiIO& settings = ImGui::GetIO();
  // The program remembers its own layout; ImGui shall leave no file behind.
  settings.IniFilename = nullptr;
  settings.LogFilename = nullptr;
  settings.ConfigWindowsMoveFromTitleBarOnly = true;
  settings.BackendRendererName = "replan";
  settings.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  key::install(settings);
  look_.focus = &focus_;
}

Stage::~Stage() {
  renderer_.reset();
  ImGui::DestroyContext(context_);
}

ImGuiIO& Stage::io() {
  const Current current(context_);
  return ImGui::GetIO();
}

void Stage::set_theme(const Theme& theme) {
  look_.theme = theme;
  style_stale_ = true;
}

void Stage::set_scale(float scale) {
  scale_ = scale;
  rescale();
}

void Stage::set_size(float size) {
  if (size == size_) return;
  size_ = size;
  rescale();
}

void Stage::set_fingers(bool fingers) {
  if (fingers == fingers_) return;
  fingers_ = fingers;
  look_.px = Metrics(font_options_.scale, fingers_);
  style_stale_ = true;
}

void Stage::follow_touches(double now) {
  const ImGuiWindow* window = context_->HoveredWindow;
  const bool world = window != nullptr && std::string_view(window->RootWindow->Name) == kCanvasArea;
  touches_.set_measures({.slack = look_.px(6), .wheel_notch = 5 * look_.fonts.ui->FontSize});
  touches_.update(now, world ? TouchGround::world : ground_in(*context_));
}

void Stage::rescale() {
  font_options_.scale = std::clamp(scale_ * size_, 0.5f, 4.0f);
  look_.px = Metrics(font_options_.scale, fingers_);
  fonts_stale_ = style_stale_ = true;
}

void Stage::set_language(std::string also, bool chinese) {
  font_options_.also = std::move(also);
  font_options_.chinese = chinese;
  fonts_stale_ = true;
}

void Stage::refresh() {
  if (style_stale_) apply(ImGui::GetStyle(), look_.theme, look_.px);
  if (fonts_stale_) {
    FontReport report = build_fonts(*ImGui::GetIO().Fonts, font_options_);
    look_.fonts = report.fonts;
    notices_ = std::move(report.notices);
    renderer_->upload_fonts();
    ImGui::GetIO().FontDefault = look_.fonts.ui;
  }
  style_stale_ = fonts_stale_ = false;
}

void Stage::frame(int width, int height, float seconds, const std::function<void()>& draw) {
  const Current current(context_);
  refresh();
  ImGuiIO& settings = ImGui::GetIO();
  settings.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  settings.DeltaTime = std::max(seconds, 1e-5f);
  input_.feed(settings);
  look_.pinch = input_.take_pinch();
  ImGui::NewFrame();
  focus_.begin_frame();
  draw();
  ImGui::Render();
  // A tooltip is about to be due: the mouse rests, so no event would bring the frame that shows it.
  const ImGuiContext& context = *context_;
  awaits_hint_ = context.HoveredId != 0 && context.HoveredIdTimer < kHintSeconds + 0.05f;
}

void Stage::render() {
  const Current current(context_);
  renderer_->render(*ImGui::GetDrawData(), look_.theme.background);
}

}  // namespace replan::ui
