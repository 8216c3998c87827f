#include "app/platform/offscreen.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <GL/glcorearb.h>
#include <GL/osmesa.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/platform/gl_choice.hpp"

namespace replan::app {

/// An OSMesa context and the memory it draws into.
struct Offscreen::Context {
  OSMesaContext handle = nullptr;
  std::vector<std::uint8_t> pixels;

  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() {
    if (handle != nullptr) OSMesaDestroyContext(handle);
  }
};

namespace {

OSMesaContext create_context() {
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            0,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  return OSMesaCreateContextAttribs(attributes, nullptr);
}

void* find_mesa_function(const char* name) {
  return reinterpret_cast<void*>(OSMesaGetProcAddress(name));
}

/// Makes a context current for a scope. A window's context is taken off first and put back afterwards: Mesa
/// keeps one current context for GLX and OSMesa together, but each believes its own to be still current.
class Current {
 public:
  Current(OSMesaContext handle, std::vector<std::uint8_t>& pixels, int width, int height)
      : window_(glfwGetCurrentContext()) {
    if (window_ != nullptr) glfwMakeContextCurrent(nullptr);
    ok_ = OSMesaMakeCurrent(handle, pixels.data(), GL_UNSIGNED_BYTE, width, height) == GL_TRUE;
    if (ok_) OSMesaPixelStore(OSMESA_Y_UP, 0);
  }
  ~Current() {
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    if (window_ != nullptr) glfwMakeContextCurrent(window_);
  }
  Current(const Current&) = delete;
  Current& operator=(const Current&) = delete;
  [[nodiscard]] bool ok() const { return ok_; }

 private:
  GLFWwindow* window_;
  bool ok_ = false;
};

}  // namespace

Result<std::unique_ptr<Offscreen>> Offscreen::create(const OffscreenSettings& settings) {
  constexpr int kLargest = 16384;
  if (settings.width < 1 || settings.height < 1 || settings.width > kLargest || settings.height > kLargest) {
    return Error{"A picture must be 1 to 16384 pixels wide and high."};
  }
  std::unique_ptr<Offscreen> offscreen(new Offscreen(settings));
  Context& context = *offscreen->context_;
  context.handle = create_context();
  if (context.handle == nullptr) {
    return Error{
        "OSMesa could not make an OpenGL 3.3 context; check that the package libosmesa6 is installed."};
  }
  context.pixels.resize(static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height) *
                        4);
  const Result<GlChoice> choice = gl_choice();
  if (!choice) return Error{choice.error()};
  const Current current(context.handle, context.pixels, settings.width, settings.height);
  if (!current.ok()) return Error{"OSMesa refused a picture of this size; try a smaller one."};
  if (const Result<void> loaded = offscreen->gl_.load(find_mesa_function); !loaded)
    return Error{loaded.error()};
  // OSMesa has no context of OpenGL ES, but takes its shaders (GL_ARB_ES3_compatibility).
  offscreen->gl_.es = *choice == GlChoice::es;
  Result<std::unique_ptr<ui::Stage>> stage = ui::Stage::create(offscreen->gl_, settings.scale);
  if (!stage) return Error{stage.error()};
  offscreen->stage_ = std::move(*stage);
  return offscreen;
}

Offscreen::Offscreen(const OffscreenSettings& settings)
    : settings_(settings), context_(std::make_unique<Context>()) {}

Offscreen::~Offscreen() {
  if (stage_ == nullptr) return;
  const Current current(context_->handle, context_->pixels, settings_.width, settings_.height);
  stage_.reset();
}

void Offscreen::frame(const std::function<void()>& draw, float seconds) {
  const Current current(context_->handle, context_->pixels, settings_.width, settings_.height);
  stage_->frame(settings_.width, settings_.height, seconds, draw);
}

ui::Image Offscreen::picture() {
  const Current current(context_->handle, context_->pixels, settings_.width, settings_.height);
  stage_->render();
  gl_.Finish();
  return {settings_.width, settings_.height, context_->pixels};
}

}  // namespace replan::app
