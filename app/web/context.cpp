#include "app/web/context.hpp"

namespace replan::app {
namespace {

void* find_webgl_function(const char* name) {
  return emscripten_webgl_get_proc_address(name);
}

}  // namespace

Result<EMSCRIPTEN_WEBGL_CONTEXT_HANDLE> open_webgl(const std::string& canvas, ui::Gl& gl) {
  EmscriptenWebGLContextAttributes wanted;
  emscripten_webgl_init_context_attributes(&wanted);
  wanted.majorVersion = 2;
  wanted.minorVersion = 0;
  wanted.alpha = EM_FALSE;
  wanted.depth = EM_FALSE;
  wanted.stencil = EM_FALSE;
  wanted.antialias = EM_FALSE;
  // Between its frames the page stands still: the browser must not lose what was drawn.
  wanted.preserveDrawingBuffer = EM_TRUE;
  const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_create_context(canvas.c_str(), &wanted);
  if (context <= 0)
    return Error{
        "This browser does not offer WebGL 2, by which Replan draws. Switch hardware acceleration on in its "
        "settings, or "
        "use a newer one."};
  emscripten_webgl_make_context_current(context);
  if (const Result<void> loaded = gl.load(find_webgl_function); !loaded) return Error{loaded.error()};
  return context;
}

}  // namespace replan::app
