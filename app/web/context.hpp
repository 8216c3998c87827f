// WebGL 2: OpenGL ES 3.0 on a canvas of the page.
#pragma once

#include <string>

#include <emscripten/html5.h>

#include "core/base/result.hpp"
#include "ui/gl/gl.hpp"

namespace replan::app {

/// Makes a context on the canvas with that CSS selector, makes it current and fills the table of its functions.
Result<EMSCRIPTEN_WEBGL_CONTEXT_HANDLE> open_webgl(const std::string& canvas, ui::Gl& gl);

}  // namespace replan::app
