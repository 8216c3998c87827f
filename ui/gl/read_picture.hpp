// The pixels of the framebuffer that is bound, as a picture.
#pragma once

#include "ui/gl/gl.hpp"
#include "ui/image.hpp"

namespace replan::ui {

/// Rows from the top, as pictures have them; OpenGL's first row is the lowest.
Image read_picture(const Gl& gl, int width, int height);

}  // namespace replan::ui
