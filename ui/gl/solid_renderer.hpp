// Draws a world in space into a texture: faces of obstacles, small cubes, lines and the sheet of a slice, with depth.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include <imgui.h>

#include "core/scene/solid_mesh.hpp"
#include "core/scene/solid_scene.hpp"
#include "ui/gl/imgui_renderer.hpp"

namespace replan::ui {

/// What one frame is drawn of. The mesh's blocks are uploaded where they have changed since the frame before.
struct SolidFrame {
  const SolidMesh& mesh;
  const SolidScene& scene;
  std::array<float, 16> matrix;
  int width = 0, height = 0;  ///< pixels
  ImU32 background = 0;
};

/// Owns the GL objects. Needs its context current in every call, its destructor included. What it leaves bound, the
/// renderer of ImGui sets anew.
class SolidRenderer {
 public:
  explicit SolidRenderer(const Gl& gl);
  ~SolidRenderer();
  SolidRenderer(const SolidRenderer&) = delete;
  SolidRenderer& operator=(const SolidRenderer&) = delete;

  /// The texture with the frame, as large as it: rows from below, as OpenGL has them. The error says why there is none.
  Result<ImTextureID> draw(const SolidFrame& frame);

 private:
  struct Buffer {
    GLuint array = 0, buffer = 0;
    GLsizei count = 0;
    std::uint64_t revision = 0;
  };

  Result<void> build();
  Result<void> resize(int width, int height);
  void release_target();
  /// A part of what is drawn once for each instance, at the shader's location of its number in the list.
  struct Attribute {
    GLint count;
    GLenum type;
    std::size_t offset;
  };
  [[nodiscard]] Buffer make_instances(std::size_t size, std::span<const Attribute> attributes);
  [[nodiscard]] Buffer make_faces();
  [[nodiscard]] Buffer make_boxes();
  [[nodiscard]] Buffer make_lines();
  template <class Item>
  void upload(Buffer& buffer, std::span<const Item> items);
  void upload_blocks(const SolidMesh& mesh);
  void use(GLuint program, const SolidFrame& frame);
  void draw_faces(const SolidFrame& frame);
  void draw_boxes(const SolidFrame& frame);
  void draw_lines(const SolidFrame& frame);
  void release(Buffer& buffer);

  const Gl& gl_;
  GLuint faces_program_ = 0, boxes_program_ = 0, lines_program_ = 0;
  GLuint framebuffer_ = 0, colours_ = 0, depths_ = 0;  // drawn into, with several samples a pixel
  GLuint resolved_ = 0, texture_ = 0;                  // and made one of
  int width_ = 0, height_ = 0;
  std::vector<Buffer> blocks_;
  Buffer cut_, boxes_, lines_;
};

}  // namespace replan::ui
