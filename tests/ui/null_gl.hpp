// OpenGL functions that do nothing but claim to have worked: what is left of a frame is the time of our own code.
#pragma once

#include <cstddef>
#include <type_traits>

#include "ui/gl/gl.hpp"

namespace replan::ui {

template <class Function>
struct NullCall;
template <class R, class... Arguments>
struct NullCall<R(APIENTRYP)(Arguments...)> {
  static R APIENTRY call(Arguments...) {
    if constexpr (!std::is_void_v<R>) return R{};
  }
};

/// Counts the buffers that are filled, and with how many bytes.
struct NullGl {
  struct Uploads {
    std::size_t buffers = 0, bytes = 0;
  };
  static Uploads& uploads() {
    static Uploads counted;
    return counted;
  }

  static Gl table() {
    Gl gl;
#define REPLAN_NULL_CALL(type, name) gl.name = NullCall<PFNGL##type##PROC>::call;
    REPLAN_GL_FUNCTIONS(REPLAN_NULL_CALL)
#undef REPLAN_NULL_CALL
    gl.CreateShader = [](GLenum) { return GLuint{1}; };
    gl.CreateProgram = [] { return GLuint{1}; };
    gl.GetShaderiv = [](GLuint, GLenum, GLint* value) { *value = GL_TRUE; };
    gl.GetProgramiv = [](GLuint, GLenum, GLint* value) { *value = GL_TRUE; };
    gl.GetIntegerv = [](GLenum, GLint* value) { *value = 8192; };
    gl.CheckFramebufferStatus = [](GLenum) -> GLenum { return GL_FRAMEBUFFER_COMPLETE; };
    gl.GenTextures = gl.GenBuffers = gl.GenVertexArrays = gl.GenFramebuffers =
        gl.GenRenderbuffers = [](GLsizei count, GLuint* names) {
          static GLuint last = 0;
          for (GLsizei i = 0; i < count; ++i) names[i] = ++last;
        };
    gl.BufferData = [](GLenum, GLsizeiptr size, const void*, GLenum) {
      ++uploads().buffers;
      uploads().bytes += static_cast<std::size_t>(size);
    };
    return gl;
  }
};

}  // namespace replan::ui
