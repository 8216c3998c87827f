#include "ui/gl/solid_target.hpp"

#include <array>
#include <string>

namespace replan::ui {

void SolidTarget::release() {
  const std::array<GLuint, 2> framebuffers = {framebuffer_, resolved_},
                              renderbuffers = {colour_samples_, depth_samples_},
                              textures = {picture_, depths_};
  gl_.DeleteFramebuffers(2, framebuffers.data());
  gl_.DeleteRenderbuffers(2, renderbuffers.data());
  gl_.DeleteTextures(2, textures.data());
  framebuffer_ = resolved_ = colour_samples_ = depth_samples_ = picture_ = depths_ = 0;
}

void SolidTarget::make_samples() {
  constexpr GLsizei kSamples = 4;
  const auto renderbuffer = [&](GLuint& name, GLenum format, GLenum attachment) {
    gl_.GenRenderbuffers(1, &name);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, name);
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, format, width_, height_);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
  };
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  renderbuffer(colour_samples_, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  renderbuffer(depth_samples_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
}

void SolidTarget::make_texture(GLuint& name, GLenum format, GLenum layout, GLenum type) {
  gl_.GenTextures(1, &name);
  gl_.BindTexture(GL_TEXTURE_2D, name);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width_, height_, 0, layout, type, nullptr);
}

Result<void> SolidTarget::resize(int width, int height) {
  if (width == width_ && height == height_ && picture_ != 0) return {};
  release();
  width_ = width;
  height_ = height;
  make_samples();
  const bool drawn = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  make_texture(picture_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
  make_texture(depths_, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
  gl_.GenFramebuffers(1, &resolved_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_, 0);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_, 0);
  const bool resolved = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  if (drawn && resolved) return {};
  release();
  return Error{"The OpenGL driver cannot draw into a texture of " + std::to_string(width) + " x " +
               std::to_string(height) + " pixels with depth."};
}

void SolidTarget::begin(ImU32 background) {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Viewport(0, 0, width_, height_);
  const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(background);
  gl_.Disable(GL_SCISSOR_TEST);  // it would hold for the clearing too
  gl_.DepthMask(GL_TRUE);
  gl_.ClearColor(ground.x, ground.y, ground.z, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void SolidTarget::resolve(GLbitfield what) {
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, what, GL_NEAREST);
}

GLuint SolidTarget::depths() {
  resolve(GL_DEPTH_BUFFER_BIT);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  return depths_;
}

GLuint SolidTarget::finish() {
  resolve(GL_COLOR_BUFFER_BIT);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return picture_;
}

}  // namespace replan::ui
