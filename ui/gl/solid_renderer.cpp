#include "ui/gl/solid_renderer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "ui/gl/shader.hpp"

namespace replan::ui {
namespace {

constexpr GLsizei kSamples = 4;

// Faces are rectangles of cells: one instance each, its corners from the number of the vertex. The light comes from above
// and is soft: each side has its own shade. Lines between cells are a little darker, and vanish where cells are small.
constexpr const char* kFaceVertices = R"(#version 330 core
layout(location = 0) in vec3 cell;
layout(location = 1) in float side;
layout(location = 2) in vec2 extent;
layout(location = 3) in vec4 colour;
uniform mat4 projection;
uniform float lift;
out vec3 place;
out vec2 on_face;
out vec4 shade;
const float kLight[6] = float[6](0.80, 0.80, 0.68, 0.90, 0.52, 1.0);
void main() {
  int s = int(side + 0.5);
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
  if (s == 1 || s == 2 || s == 5) corner = corner.yx;  // all turn the same way, seen from outside
  on_face = corner * extent;
  vec3 at = cell;
  float out_by = (s & 1) == 1 ? 1.0 + lift : -lift;
  if (s < 2) at += vec3(out_by, on_face.x, on_face.y);
  else if (s < 4) at += vec3(on_face.x, out_by, on_face.y);
  else at += vec3(on_face.x, on_face.y, out_by);
  place = at;
  shade = vec4(colour.rgb * kLight[s], colour.a);
  gl_Position = projection * vec4(at, 1.0);
}
)";

constexpr const char* kFaceFragments = R"(#version 330 core
in vec3 place;
in vec2 on_face;
in vec4 shade;
uniform vec4 cut;      // the plane's normal and its place along it: what is beyond is left out
uniform vec2 finish;   // opacity; strength of the lines between cells
layout(location = 0) out vec4 result;
void main() {
  if (dot(place, cut.xyz) > cut.w) discard;
  vec2 width = max(fwidth(on_face), vec2(1e-5));
  vec2 line = abs(fract(on_face - 0.5) - 0.5) / width;
  float near = 1.0 - min(min(line.x, line.y), 1.0);
  float seen = clamp(1.0 - max(width.x, width.y) * 3.0, 0.0, 1.0);
  result = vec4(shade.rgb * (1.0 - finish.y * near * seen), shade.a * finish.x);
}
)";

constexpr const char* kBoxVertices = R"(#version 330 core
layout(location = 0) in vec3 low;
layout(location = 1) in vec3 high;
layout(location = 2) in vec4 colour;
uniform mat4 projection;
out vec4 shade;
const float kLight[6] = float[6](0.80, 0.80, 0.68, 0.90, 0.52, 1.0);
const int kCorner[6] = int[6](0, 1, 2, 2, 1, 3);
void main() {
  int s = gl_VertexID / 6;
  int c = kCorner[gl_VertexID % 6];
  vec2 corner = vec2(float(c & 1), float(c >> 1));
  if (s == 1 || s == 2 || s == 5) corner = corner.yx;
  float out_by = (s & 1) == 1 ? 1.0 : 0.0;
  vec3 part = s < 2 ? vec3(out_by, corner) : s < 4 ? vec3(corner.x, out_by, corner.y) : vec3(corner, out_by);
  shade = vec4(colour.rgb * kLight[s], colour.a);
  gl_Position = projection * vec4(mix(low, high, part), 1.0);
}
)";

constexpr const char* kPlainFragments = R"(#version 330 core
in vec4 shade;
uniform vec2 finish;
layout(location = 0) out vec4 result;
void main() { result = vec4(shade.rgb, shade.a * finish.x); }
)";

// A piece of a line becomes a rectangle as many pixels wide as it is to be, with its ends drawn out by half of that.
constexpr const char* kLineVertices = R"(#version 330 core
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 colour;
layout(location = 3) in float width;
uniform mat4 projection;
uniform vec2 viewport;
out vec4 shade;
void main() {
  vec4 a = projection * vec4(from, 1.0), b = projection * vec4(to, 1.0);
  float least = 0.001;
  if (a.w < least && b.w >= least) a = mix(b, a, (b.w - least) / (b.w - a.w));
  if (b.w < least && a.w >= least) b = mix(a, b, (a.w - least) / (a.w - b.w));
  vec2 pa = a.xy / a.w * viewport, pb = b.xy / b.w * viewport;
  vec2 way = pb - pa;
  float far = length(way);
  vec2 ahead = far > 1e-4 ? way / far : vec2(1.0, 0.0);
  vec2 aside = vec2(-ahead.y, ahead.x) * width * (float(gl_VertexID & 1) * 2.0 - 1.0);
  bool last = gl_VertexID > 1;
  vec4 at = last ? b : a;
  vec2 drawn_out = ahead * width * 0.5 * (last ? 1.0 : -1.0);
  shade = colour;
  gl_Position = vec4(at.xy + (aside + drawn_out) / viewport * at.w, at.z - 0.0004 * at.w, at.w);
}
)";

}  // namespace

SolidRenderer::SolidRenderer(const Gl& gl) : gl_(gl) {}

SolidRenderer::~SolidRenderer() {
  for (Buffer& each : blocks_) release(each);
  for (Buffer* each : {&cut_, &boxes_, &lines_}) release(*each);
  for (const GLuint program : {faces_program_, boxes_program_, lines_program_})
    if (program != 0) gl_.DeleteProgram(program);
  release_target();
}

Result<void> SolidRenderer::build() {
  if (lines_program_ != 0) return {};
  const auto made = [this](const char* vertices, const char* fragments, GLuint& program) {
    const Result<GLuint> built = build_program(gl_, vertices, fragments);
    if (built) program = *built;
    return built ? Result<void>{} : Error{built.error()};
  };
  if (const auto faces = made(kFaceVertices, kFaceFragments, faces_program_); !faces) return faces;
  if (const auto boxes = made(kBoxVertices, kPlainFragments, boxes_program_); !boxes) return boxes;
  if (const auto lines = made(kLineVertices, kPlainFragments, lines_program_); !lines) return lines;
  cut_ = make_faces();
  boxes_ = make_boxes();
  lines_ = make_lines();
  return {};
}

void SolidRenderer::release_target() {
  const std::array<GLuint, 2> framebuffers = {framebuffer_, resolved_}, renderbuffers = {colours_, depths_};
  gl_.DeleteFramebuffers(2, framebuffers.data());
  gl_.DeleteRenderbuffers(2, renderbuffers.data());
  gl_.DeleteTextures(1, &texture_);
  framebuffer_ = resolved_ = colours_ = depths_ = texture_ = 0;
}

Result<void> SolidRenderer::resize(int width, int height) {
  if (width == width_ && height == height_ && texture_ != 0) return {};
  release_target();
  width_ = width;
  height_ = height;
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  const auto renderbuffer = [&](GLuint& name, GLenum format, GLenum attachment) {
    gl_.GenRenderbuffers(1, &name);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, name);
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, format, width, height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
  };
  renderbuffer(colours_, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  renderbuffer(depths_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
  const bool drawn = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  gl_.GenTextures(1, &texture_);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl_.GenFramebuffers(1, &resolved_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  const bool resolved = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  if (drawn && resolved) return {};
  release_target();
  return Error{"The OpenGL driver cannot draw into a texture of " + std::to_string(width) + " x " +
               std::to_string(height) + " pixels with depth."};
}

SolidRenderer::Buffer SolidRenderer::make_instances(std::size_t size, std::span<const Attribute> attributes) {
  Buffer made;
  gl_.GenVertexArrays(1, &made.array);
  gl_.GenBuffers(1, &made.buffer);
  gl_.BindVertexArray(made.array);
  gl_.BindBuffer(GL_ARRAY_BUFFER, made.buffer);
  GLuint location = 0;
  for (const Attribute& each : attributes) {
    const GLboolean normalised = each.type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE;  // a colour's
    gl_.VertexAttribPointer(location, each.count, each.type, normalised, static_cast<GLsizei>(size),
                            byte_offset(each.offset));
    gl_.EnableVertexAttribArray(location);
    gl_.VertexAttribDivisor(location, 1);
    ++location;
  }
  return made;
}

SolidRenderer::Buffer SolidRenderer::make_faces() {
  constexpr std::array<Attribute, 4> kAttributes = {{{3, GL_UNSIGNED_SHORT, offsetof(SolidFace, x)},
                                                     {1, GL_UNSIGNED_SHORT, offsetof(SolidFace, side)},
                                                     {2, GL_UNSIGNED_SHORT, offsetof(SolidFace, across)},
                                                     {4, GL_UNSIGNED_BYTE, offsetof(SolidFace, colour)}}};
  return make_instances(sizeof(SolidFace), kAttributes);
}

SolidRenderer::Buffer SolidRenderer::make_boxes() {
  constexpr std::array<Attribute, 3> kAttributes = {{{3, GL_FLOAT, offsetof(SolidBox, low)},
                                                     {3, GL_FLOAT, offsetof(SolidBox, high)},
                                                     {4, GL_UNSIGNED_BYTE, offsetof(SolidBox, colour)}}};
  return make_instances(sizeof(SolidBox), kAttributes);
}

SolidRenderer::Buffer SolidRenderer::make_lines() {
  constexpr std::array<Attribute, 4> kAttributes = {{{3, GL_FLOAT, offsetof(SolidLine, from)},
                                                     {3, GL_FLOAT, offsetof(SolidLine, to)},
                                                     {4, GL_UNSIGNED_BYTE, offsetof(SolidLine, colour)},
                                                     {1, GL_FLOAT, offsetof(SolidLine, width)}}};
  return make_instances(sizeof(SolidLine), kAttributes);
}

void SolidRenderer::release(Buffer& buffer) {
  gl_.DeleteBuffers(1, &buffer.buffer);
  gl_.DeleteVertexArrays(1, &buffer.array);
  buffer = {};
}

template <class Item>
void SolidRenderer::upload(Buffer& buffer, std::span<const Item> items) {
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer.buffer);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(items.size_bytes()), items.data(), GL_DYNAMIC_DRAW);
  buffer.count = static_cast<GLsizei>(items.size());
}

void SolidRenderer::upload_blocks(const SolidMesh& mesh) {
  while (blocks_.size() > mesh.block_count()) {
    release(blocks_.back());
    blocks_.pop_back();
  }
  while (blocks_.size() < mesh.block_count()) blocks_.push_back(make_faces());
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (blocks_[i].revision == mesh.revision(i)) continue;
    upload(blocks_[i], mesh.faces(i));
    blocks_[i].revision = mesh.revision(i);
  }
}

void SolidRenderer::use(GLuint program, const SolidFrame& frame) {
  gl_.UseProgram(program);
  gl_.UniformMatrix4fv(gl_.GetUniformLocation(program, "projection"), 1, GL_FALSE, frame.matrix.data());
}

/// Obstacles through which one sees are drawn without depth among themselves, so that none hides another.
void SolidRenderer::draw_faces(const SolidFrame& frame) {
  const SolidScene& scene = frame.scene;
  use(faces_program_, frame);
  const auto uniform = [this](const char* name) { return gl_.GetUniformLocation(faces_program_, name); };
  std::array<float, 4> cut = {0, 0, 0, 1};
  if (scene.cut) {
    const float sign = scene.cut->keeps_lower ? 1.0f : -1.0f;
    cut[static_cast<std::size_t>(scene.cut->across)] = sign;
    cut[3] = sign * static_cast<float>(scene.cut->at) + 0.001f;
  }
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_BACK);
  gl_.DepthMask(scene.opacity < 1 ? GL_FALSE : GL_TRUE);
  gl_.Uniform4f(uniform("cut"), cut[0], cut[1], cut[2], cut[3]);
  gl_.Uniform2f(uniform("finish"), scene.opacity, 0.22f);
  const GLint lift = uniform("lift");
  gl_.Uniform1f(lift, 0);
  for (const Buffer& block : blocks_) {
    if (block.count == 0) continue;
    gl_.BindVertexArray(block.array);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, block.count);
  }
  if (cut_.count > 0) {
    gl_.Uniform4f(uniform("cut"), 0, 0, 0, 1);
    gl_.Uniform1f(lift, 0.004f);
    gl_.BindVertexArray(cut_.array);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, cut_.count);
  }
  gl_.DepthMask(GL_TRUE);
}

void SolidRenderer::draw_boxes(const SolidFrame& frame) {
  if (boxes_.count == 0) return;
  use(boxes_program_, frame);
  gl_.Uniform2f(gl_.GetUniformLocation(boxes_program_, "finish"), 1, 0);
  gl_.Enable(GL_CULL_FACE);
  gl_.BindVertexArray(boxes_.array);
  gl_.DrawArraysInstanced(GL_TRIANGLES, 0, 36, boxes_.count);
}

/// Faintly where something hides them, then as they are: a path is followed behind obstacles too.
void SolidRenderer::draw_lines(const SolidFrame& frame) {
  if (lines_.count == 0) return;
  use(lines_program_, frame);
  gl_.Disable(GL_CULL_FACE);
  gl_.Uniform2f(gl_.GetUniformLocation(lines_program_, "viewport"), static_cast<float>(frame.width),
                static_cast<float>(frame.height));
  const GLint finish = gl_.GetUniformLocation(lines_program_, "finish");
  gl_.BindVertexArray(lines_.array);
  gl_.DepthMask(GL_FALSE);
  gl_.DepthFunc(GL_GREATER);
  gl_.Uniform2f(finish, 0.3f, 0);
  gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, lines_.count);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.Uniform2f(finish, 1, 0);
  gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, lines_.count);
  gl_.DepthMask(GL_TRUE);
}

Result<ImTextureID> SolidRenderer::draw(const SolidFrame& frame) {
  if (const auto built = build(); !built) return Error{built.error()};
  if (const auto sized = resize(frame.width, frame.height); !sized) return Error{sized.error()};
  upload_blocks(frame.mesh);
  upload(cut_, std::span<const SolidFace>(frame.scene.cut_faces));
  upload(boxes_, std::span<const SolidBox>(frame.scene.boxes));
  upload(lines_, std::span<const SolidLine>(frame.scene.lines));
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Viewport(0, 0, frame.width, frame.height);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.Enable(GL_BLEND);
  gl_.BlendEquation(GL_FUNC_ADD);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(frame.background);
  gl_.ClearColor(ground.x, ground.y, ground.z, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_faces(frame);
  draw_boxes(frame);
  draw_lines(frame);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  gl_.BlitFramebuffer(0, 0, frame.width, frame.height, 0, 0, frame.width, frame.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture_));
}

}  // namespace replan::ui
