// What a world in space is drawn into: colours and depths with several samples a pixel, and made one of.
#pragma once

#include <imgui.h>

#include "core/base/result.hpp"
#include "ui/gl/gl.hpp"

namespace replan::ui {

/// Owns its GL objects. Needs their context current in every call, its destructor included.
class SolidTarget {
 public:
  explicit SolidTarget(const Gl& gl) : gl_(gl) {}
  ~SolidTarget() { release(); }
  SolidTarget(const SolidTarget&) = delete;
  SolidTarget& operator=(const SolidTarget&) = delete;

  /// Makes it as large as that. The error says why it cannot be.
  Result<void> resize(int width, int height);
  /// What is drawn from now on goes into it; it is empty.
  void begin(ImU32 background);
  /// The depths of what was drawn so far, one for each pixel, as a texture; what is drawn goes on into it.
  GLuint depths();
  /// The finished picture as a texture, rows from below.
  GLuint finish();

 private:
  void release();
  void resolve(GLbitfield what);
  void make_samples();
  void make_texture(GLuint& name, GLenum format, GLenum layout, GLenum type);

  const Gl& gl_;
  int width_ = 0, height_ = 0;
  GLuint framebuffer_ = 0, colour_samples_ = 0, depth_samples_ = 0;
  GLuint resolved_ = 0, picture_ = 0, depths_ = 0;
};

}  // namespace replan::ui
