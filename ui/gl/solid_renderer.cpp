#include "ui/gl/solid_renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/gl/shader.hpp"
#include "ui/gl/solid_shaders.hpp"

namespace replan::ui {
namespace {

/// How many cells nearer than they are lines are drawn.
constexpr float kNearer = 0.1f;
/// So many cells the faces that a cut lays open stand off from it, and the blocks end there.
constexpr float kCutLift = 0.004f;
/// How much of the background's colour what is farthest takes on.
constexpr float kHaze = 0.5f;
/// Strength of the lines between cells, and of outlines.
constexpr float kCellLines = 0.18f, kInk = 0.75f;
/// Of glass: all faces that look at the eye, and once more the nearest of them.
constexpr float kGlass = 0.08f, kGlassShell = 0.24f;

/// How much lighter the highest place of a world is than the lowest: in one of few layers they are told apart without.
float ramp_of(int layers) {
  return 0.5f * std::clamp(static_cast<float>(layers - 12) / 4.0f, 0.0f, 1.0f);
}

/// Whether something of a box may be in sight.
bool in_sight(const std::array<float, 16>& matrix, const CellBox& box) {
  std::array<int, 6> outside{};
  for (unsigned corner = 0; corner < 8; ++corner) {
    const std::array<float, 3> at = {static_cast<float>((corner & 1u) != 0 ? box.high.x + 1 : box.low.x),
                                     static_cast<float>((corner & 2u) != 0 ? box.high.y + 1 : box.low.y),
                                     static_cast<float>((corner & 4u) != 0 ? box.high.z + 1 : box.low.z)};
    const auto clip = [&](std::size_t row) {
      return matrix[row] * at[0] + matrix[4 + row] * at[1] + matrix[8 + row] * at[2] + matrix[12 + row];
    };
    const float w = clip(3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float place = clip(axis);
      outside[axis * 2] += place < -w ? 1 : 0;
      outside[axis * 2 + 1] += place > w ? 1 : 0;
    }
  }
  return std::find(outside.begin(), outside.end(), 8) == outside.end();
}

}  // namespace

SolidRenderer::SolidRenderer(const Gl& gl) : gl_(gl), target_(gl), buffers_(gl) {}

SolidRenderer::~SolidRenderer() {
  for (const GLuint program :
       {faces_program_, boxes_program_, lines_program_, sheet_program_, outlines_program_})
    if (program != 0) gl_.DeleteProgram(program);
  gl_.DeleteVertexArrays(1, &corners_);
}

Result<void> SolidRenderer::build() {
  if (corners_ != 0) return {};
  struct Program {
    const char *vertices, *fragments;
    GLuint* program;
  };
  for (const Program& each : {Program{kFaceVertices, kFaceFragments, &faces_program_},
                              {kBoxVertices, kPlainFragments, &boxes_program_},
                              {kLineVertices, kPlainFragments, &lines_program_},
                              {kSheetVertices, kSheetFragments, &sheet_program_},
                              {kOutlineVertices, kOutlineFragments, &outlines_program_}}) {
    if (*each.program != 0) continue;
    const Result<GLuint> built = build_program(gl_, each.vertices, each.fragments);
    if (!built) return Error{built.error()};
    *each.program = *built;
  }
  gl_.GenVertexArrays(1, &corners_);
  return {};
}

void SolidRenderer::use(GLuint program, const SolidFrame& frame) {
  program_ = program;
  gl_.UseProgram(program);
  gl_.UniformMatrix4fv(uniform("projection"), 1, GL_FALSE, frame.lens.matrix().data());
}

void SolidRenderer::set_depths(const OrbitLens& lens) {
  const OrbitLens::Depths depths = lens.depths();
  gl_.Uniform4f(uniform("depths"), static_cast<float>(depths.deep()), static_cast<float>(depths.shift()),
                kNearer, 0);
}

void SolidRenderer::set_cut(const SolidScene& scene) {
  std::array<float, 4> cut = {0, 0, 0, 1};
  if (scene.cut) {
    const float sign = scene.cut->keeps_lower ? 1.0f : -1.0f;
    cut[static_cast<std::size_t>(scene.cut->across)] = sign;
    cut[3] = sign * static_cast<float>(scene.cut->at) + kCutLift;
  }
  gl_.Uniform4f(uniform("cut"), cut[0], cut[1], cut[2], cut[3]);
}

void SolidRenderer::draw_blocks(const SolidFrame& frame) {
  const std::array<float, 16> matrix = frame.lens.matrix();
  set_cut(frame.scene);
  gl_.Uniform1f(uniform("lift"), 0);
  for (std::size_t i = 0; i < buffers_.blocks().size(); ++i) {
    const SolidBuffers::Instances& block = buffers_.blocks()[i];
    if (block.count == 0 || !in_sight(matrix, frame.mesh.cells(i))) continue;
    gl_.BindVertexArray(block.array);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, block.count);
  }
  if (buffers_.cut().count == 0) return;
  gl_.Uniform4f(uniform("cut"), 0, 0, 0, 1);
  gl_.Uniform1f(uniform("lift"), kCutLift);
  gl_.BindVertexArray(buffers_.cut().array);
  gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, buffers_.cut().count);
}

void SolidRenderer::draw_faces(const SolidFrame& frame) {
  use(faces_program_, frame);
  const OrbitLens::Depths depths = frame.lens.depths();
  const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(frame.background);
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_BACK);
  gl_.Uniform4f(uniform("haze"), ground.x, ground.y, ground.z, kHaze);
  gl_.Uniform2f(uniform("reach"), static_cast<float>(depths.first), static_cast<float>(depths.last));
  const int layers = frame.scene.slice.box.box().depth();
  gl_.Uniform2f(uniform("ramp"), ramp_of(layers), static_cast<float>(layers));
  gl_.Uniform2f(uniform("finish"), 1, kCellLines);
  if (frame.scene.opacity < 1)
    draw_glass(frame);
  else
    draw_blocks(frame);
}

/// All faces faintly, so that one behind another is seen; then the nearest a little stronger, which gives what is seen
/// through them a shape.
void SolidRenderer::draw_glass(const SolidFrame& frame) {
  const GLint finish = uniform("finish");
  gl_.DepthMask(GL_FALSE);
  gl_.Uniform2f(finish, kGlass, kCellLines);
  draw_blocks(frame);
  gl_.DepthMask(GL_TRUE);
  gl_.Uniform2f(finish, 0, 0);  // depths alone
  draw_blocks(frame);
  gl_.Uniform2f(finish, kGlassShell, kCellLines);
  draw_blocks(frame);
}

void SolidRenderer::draw_boxes(const SolidFrame& frame) {
  if (buffers_.boxes().count == 0) return;
  use(boxes_program_, frame);
  const Point eye = frame.lens.eye();
  gl_.Uniform4f(uniform("eye"), static_cast<float>(eye.x), static_cast<float>(eye.y),
                static_cast<float>(eye.z), 0);
  gl_.Uniform2f(uniform("finish"), 1, 0);
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_BACK);
  gl_.BindVertexArray(buffers_.boxes().array);
  gl_.DrawArraysInstanced(GL_TRIANGLES, 0, 18, buffers_.boxes().count);
}

/// Seen from both sides; a little transparent where it hides half of the world.
void SolidRenderer::draw_sheet(const SolidFrame& frame) {
  const SolidSheet& sheet = frame.scene.sheet;
  if (sheet.texels.empty()) return;
  use(sheet_program_, frame);
  const auto place = [&](const char* name, const Point& at) {
    gl_.Uniform4f(uniform(name), static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z),
                  0);
  };
  place("corner", sheet.corner);
  place("right", sheet.right);
  place("down", sheet.down);
  gl_.Uniform2f(uniform("finish"), frame.scene.cut ? 1.0f : 0.85f, 0);
  gl_.Uniform1i(uniform("picture"), 0);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, buffers_.sheet());
  gl_.Disable(GL_CULL_FACE);
  gl_.BindVertexArray(corners_);
  gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, 1);
}

/// Around what has been drawn so far.
void SolidRenderer::draw_outlines(const SolidFrame& frame) {
  const GLuint depths = target_.depths();
  use(outlines_program_, frame);
  set_depths(frame.lens);
  const ImVec4 ink = ImGui::ColorConvertU32ToFloat4(frame.ink);
  gl_.Uniform4f(uniform("ink"), ink.x, ink.y, ink.z, kInk);
  gl_.Uniform2f(uniform("viewport"), static_cast<float>(frame.width), static_cast<float>(frame.height));
  gl_.Uniform2f(uniform("finish"), static_cast<float>(frame.lens.pixel_angle()), std::round(frame.scale));
  gl_.Uniform1i(uniform("picture"), 0);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, depths);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.BindVertexArray(corners_);
  gl_.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 1);
  gl_.Enable(GL_DEPTH_TEST);
}

/// Faintly where something hides them, then as they are: a path is followed behind obstacles too.
void SolidRenderer::draw_lines(const SolidFrame& frame) {
  if (buffers_.lines().count == 0) return;
  use(lines_program_, frame);
  set_depths(frame.lens);
  gl_.Disable(GL_CULL_FACE);
  gl_.Uniform2f(uniform("viewport"), static_cast<float>(frame.width), static_cast<float>(frame.height));
  const GLint finish = uniform("finish");
  gl_.BindVertexArray(buffers_.lines().array);
  gl_.DepthMask(GL_FALSE);
  gl_.DepthFunc(GL_GREATER);
  gl_.Uniform2f(finish, 0.3f, 0);  // where joints overlapped, they would be stronger
  gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, buffers_.lines().count);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.Uniform2f(finish, 1, 0.5f);
  gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, buffers_.lines().count);
  gl_.DepthMask(GL_TRUE);
}

/// Lines lie over what is opaque, and inside of glass.
Result<ImTextureID> SolidRenderer::draw(const SolidFrame& frame) {
  if (const auto built = build(); !built) return Error{built.error()};
  if (const auto sized = target_.resize(frame.width, frame.height); !sized) return Error{sized.error()};
  buffers_.upload(frame.mesh);
  buffers_.upload(frame.scene, frame.scene_number);
  target_.begin(frame.background);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.Enable(GL_BLEND);
  gl_.BlendEquation(GL_FUNC_ADD);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const bool glass = frame.scene.opacity < 1;
  if (!glass) draw_faces(frame);
  draw_boxes(frame);
  draw_sheet(frame);
  if (glass) {
    draw_lines(frame);
    draw_faces(frame);
  }
  draw_outlines(frame);
  if (!glass) draw_lines(frame);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(target_.finish()));
}

}  // namespace replan::ui
