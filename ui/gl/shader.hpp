// Shaders made into programs.
#pragma once

#include "core/base/result.hpp"
#include "ui/gl/gl.hpp"

namespace replan::ui {

/// The program of two shaders; the error has what the driver says.
Result<GLuint> build_program(const Gl& gl, const char* vertex, const char* fragment);

/// A place in a buffer, as OpenGL takes it.
inline const void* byte_offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}

}  // namespace replan::ui
