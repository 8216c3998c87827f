// Pictures that are not the page's: drawn on a canvas of their own that the page does not show.
#include "app/platform/offscreen.hpp"

#include <emscripten.h>

#include "app/web/context.hpp"
#include "ui/gl/read_picture.hpp"

namespace replan::app {
namespace {

constexpr const char* kOffscreenCanvas = "#replan-offscreen";

// clang-format off
EM_JS(void, make_offscreen_canvas, (int width, int height), {
  const canvas = document.createElement('canvas');
  canvas.id = 'replan-offscreen';
  canvas.hidden = true;
  canvas.width = width;
  canvas.height = height;
  document.body.appendChild(canvas);
});

EM_JS(void, remove_offscreen_canvas, (void), {
  document.getElementById('replan-offscreen').remove();
});
// clang-format on

/// Makes a context current for a scope, and the window's again afterwards.
class CurrentWebgl {
 public:
  explicit CurrentWebgl(EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context)
      : before_(emscripten_webgl_get_current_context()) {
    emscripten_webgl_make_context_current(context);
  }
  ~CurrentWebgl() { emscripten_webgl_make_context_current(before_); }
  CurrentWebgl(const CurrentWebgl&) = delete;
  CurrentWebgl& operator=(const CurrentWebgl&) = delete;

 private:
  EMSCRIPTEN_WEBGL_CONTEXT_HANDLE before_;
};

}  // namespace

struct Offscreen::Context {
  EMSCRIPTEN_WEBGL_CONTEXT_HANDLE handle = 0;

  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() {
    if (handle > 0) emscripten_webgl_destroy_context(handle);
    remove_offscreen_canvas();
  }
};

Result<std::unique_ptr<Offscreen>> Offscreen::create(const OffscreenSettings& settings) {
  std::unique_ptr<Offscreen> offscreen(new Offscreen(settings));
  const CurrentWebgl current(emscripten_webgl_get_current_context());  // opening makes another one current
  const auto context = open_webgl(kOffscreenCanvas, offscreen->gl_);
  if (!context) return Error{context.error()};
  offscreen->context_->handle = *context;
  Result<std::unique_ptr<ui::Stage>> stage = ui::Stage::create(offscreen->gl_, settings.scale);
  if (!stage) return Error{stage.error()};
  offscreen->stage_ = std::move(*stage);
  return offscreen;
}

Offscreen::Offscreen(const OffscreenSettings& settings)
    : settings_(settings), context_(std::make_unique<Context>()) {
  make_offscreen_canvas(settings.width, settings.height);
}

Offscreen::~Offscreen() {
  if (stage_ == nullptr) return;
  const CurrentWebgl current(context_->handle);
  stage_.reset();
}

void Offscreen::frame(const std::function<void()>& draw, float seconds) {
  const CurrentWebgl current(context_->handle);
  stage_->frame(settings_.width, settings_.height, seconds, draw);
}

ui::Image Offscreen::picture() {
  const CurrentWebgl current(context_->handle);
  stage_->render();
  return ui::read_picture(gl_, settings_.width, settings_.height);
}

}  // namespace replan::app
