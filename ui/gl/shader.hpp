// Shaders made into programs.
#pragma once

#include "core/base/result.hpp"
#include "ui/gl/gl.hpp"

namespace replan::ui {

/// The program of two shaders; the error has what the driver says. The sources are without their line of the version: one
/// text is compiled for OpenGL 3.3 core and for OpenGL ES 3.0, so it uses what both have (no implicit conversions of
/// numbers, no names of built-in functions).
Result<GLuint> build_program(const Gl& gl, const char* vertex, const char* fragment);

/// A place in a buffer, as OpenGL takes it.
inline const void* byte_offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}

}  // namespace replan::ui
