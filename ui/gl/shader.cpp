#include "ui/gl/shader.hpp"

#include <array>
#include <string>

namespace replan::ui {
namespace {

/// With what each shader begins. OpenGL ES has no precision of its own for numbers in fragments, and too low a one for
/// textures of depths.
constexpr const char* kCoreHeader = "#version 330 core\n";
constexpr const char* kEsHeader =
    "#version 300 es\n"
    "precision highp float;\n"
    "precision highp int;\n"
    "precision highp sampler2D;\n";

Result<GLuint> compile(const Gl& gl, GLenum kind, const char* source) {
  const GLuint shader = gl.CreateShader(kind);
  const std::array<const char*, 2> parts = {gl.es ? kEsHeader : kCoreHeader, source};
  gl.ShaderSource(shader, static_cast<GLsizei>(parts.size()), parts.data(), nullptr);
  gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  std::array<char, 512> log{};
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteShader(shader);
  return Error{std::string("The OpenGL driver refused a shader: ") + log.data()};
}

}  // namespace

Result<GLuint> build_program(const Gl& gl, const char* vertex_source, const char* fragment_source) {
  const Result<GLuint> vertex = compile(gl, GL_VERTEX_SHADER, vertex_source);
  if (!vertex) return Error{vertex.error()};
  const Result<GLuint> fragment = compile(gl, GL_FRAGMENT_SHADER, fragment_source);
  if (!fragment) return Error{fragment.error()};
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program, *vertex);
  gl.AttachShader(program, *fragment);
  gl.LinkProgram(program);
  gl.DeleteShader(*vertex);
  gl.DeleteShader(*fragment);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return program;
  std::array<char, 512> log{};
  gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteProgram(program);
  return Error{std::string("The OpenGL driver could not link the shaders: ") + log.data()};
}

}  // namespace replan::ui
