// Draws a world in space into a texture: faces of obstacles, small cubes, lines and the sheet of a slice, with depth.
#pragma once

#include <array>
#include <cstdint>

#include <imgui.h>

#include "core/scene/orbit.hpp"
#include "core/scene/solid_mesh.hpp"
#include "core/scene/solid_scene.hpp"
#include "ui/gl/imgui_renderer.hpp"
#include "ui/gl/solid_buffers.hpp"
#include "ui/gl/solid_target.hpp"

namespace replan::ui {

/// What one frame is drawn of. The mesh's blocks are uploaded where they have changed since the frame before, the scene
/// where its number is another one.
struct SolidFrame {
  const SolidMesh& mesh;
  const SolidScene& scene;
  std::uint64_t scene_number = 0;
  const OrbitLens& lens;
  int width = 0, height = 0;  ///< pixels
  float scale = 1;            ///< pixels of a line of the design's
  ImU32 background = 0;
  ImU32 ink = 0;  ///< of outlines
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
  [[nodiscard]] const SolidBuffers::Uploads& uploads() const { return buffers_.uploads(); }

 private:
  Result<void> build();
  [[nodiscard]] GLint uniform(const char* name) const { return gl_.GetUniformLocation(program_, name); }
  void use(GLuint program, const SolidFrame& frame);
  void set_depths(const OrbitLens& lens);
  void set_cut(const SolidScene& scene);
  void draw_blocks(const SolidFrame& frame);
  void draw_faces(const SolidFrame& frame);
  void draw_glass(const SolidFrame& frame);
  void draw_boxes(const SolidFrame& frame);
  void draw_sheet(const SolidFrame& frame);
  void draw_outlines(const SolidFrame& frame);
  void draw_lines(const SolidFrame& frame);

  const Gl& gl_;
  SolidTarget target_;
  SolidBuffers buffers_;
  GLuint faces_program_ = 0, boxes_program_ = 0, lines_program_ = 0, sheet_program_ = 0,
         outlines_program_ = 0;
  GLuint program_ = 0;  // in use
  GLuint corners_ = 0;  // an array without attributes
};

}  // namespace replan::ui
