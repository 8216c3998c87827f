#include "ui/gl/imgui_renderer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "ui/gl/shader.hpp"

namespace replan::ui {
namespace {

constexpr const char* kVertexShader = R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texture_position;
layout(location = 2) in vec4 colour;
uniform mat4 projection;
out vec2 fragment_texture_position;
out vec4 fragment_colour;
void main() {
  fragment_texture_position = texture_position;
  fragment_colour = colour;
  gl_Position = projection * vec4(position, 0.0, 1.0);
}
)";

constexpr const char* kFragmentShader = R"(
in vec2 fragment_texture_position;
in vec4 fragment_colour;
uniform sampler2D image;
layout(location = 0) out vec4 result;
void main() { result = fragment_colour * texture(image, fragment_texture_position); }
)";

GLuint name_of(ImTextureID id) {
  return static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(id));
}
ImTextureID id_of(GLuint name) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name));
}

}  // namespace

Result<std::unique_ptr<ImGuiRenderer>> ImGuiRenderer::create(const Gl& gl) {
  std::unique_ptr<ImGuiRenderer> renderer(new ImGuiRenderer(gl));
  if (const Result<void> built = renderer->build_program(); !built) return Error{built.error()};
  renderer->build_buffers();
  return renderer;
}

ImGuiRenderer::ImGuiRenderer(const Gl& gl) : gl_(gl) {
  gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &max_texture_size_);
}

ImGuiRenderer::~ImGuiRenderer() {
  for (const Texture& texture : textures_) gl_.DeleteTextures(1, &texture.name);
  gl_.DeleteBuffers(1, &vertex_buffer_);
  gl_.DeleteBuffers(1, &index_buffer_);
  gl_.DeleteVertexArrays(1, &vertex_array_);
  gl_.DeleteProgram(program_);
}

Result<void> ImGuiRenderer::build_program() {
  const Result<GLuint> program = ui::build_program(gl_, kVertexShader, kFragmentShader);
  if (!program) return Error{program.error()};
  program_ = *program;
  projection_location_ = gl_.GetUniformLocation(program_, "projection");
  gl_.UseProgram(program_);
  gl_.Uniform1i(gl_.GetUniformLocation(program_, "image"), 0);
  return {};
}

void ImGuiRenderer::build_buffers() {
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.GenBuffers(1, &vertex_buffer_);
  gl_.GenBuffers(1, &index_buffer_);
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
  for (GLuint location = 0; location < 3; ++location) gl_.EnableVertexAttribArray(location);
}

/// Indices count from that vertex on: OpenGL ES 3.0 and WebGL 2 have no glDrawElementsBaseVertex.
void ImGuiRenderer::count_from(unsigned vertex) {
  if (counted_from_ == vertex) return;
  counted_from_ = vertex;
  constexpr GLsizei stride = sizeof(ImDrawVert);
  const auto place = [vertex](std::size_t member) {
    return byte_offset(vertex * sizeof(ImDrawVert) + member);
  };
  gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, place(offsetof(ImDrawVert, pos)));
  gl_.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, place(offsetof(ImDrawVert, uv)));
  gl_.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, place(offsetof(ImDrawVert, col)));
}

void ImGuiRenderer::upload_fonts() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  unsigned char* texels = nullptr;
  int width = 0;
  int height = 0;
  atlas.GetTexDataAsRGBA32(&texels, &width, &height);
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (font_texture_ != nullptr) destroy_texture(font_texture_);
  font_texture_ =
      create_texture(width, height, {reinterpret_cast<const std::uint32_t*>(texels), count}, Filter::linear);
  atlas.SetTexID(font_texture_);
  atlas.ClearTexData();
}

ImTextureID ImGuiRenderer::create_texture(int width, int height, std::span<const std::uint32_t> texels,
                                          Filter filter) {
  Texture texture{0, filter, filter == Filter::cells};
  gl_.GenTextures(1, &texture.name);
  gl_.BindTexture(GL_TEXTURE_2D, texture.name);
  const GLint enlarge = filter == Filter::linear ? GL_LINEAR : GL_NEAREST;
  const GLint shrink = filter == Filter::cells ? GL_LINEAR_MIPMAP_LINEAR : enlarge;
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, enlarge);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, shrink);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.empty() ? nullptr : texels.data());
  textures_.push_back(texture);
  return id_of(texture.name);
}

void ImGuiRenderer::update_texture(ImTextureID id, int x, int y, int width, int height,
                                   std::span<const std::uint32_t> texels, int stride) {
  Texture* texture = find(id);
  if (texture == nullptr || width <= 0 || height <= 0) return;
  gl_.BindTexture(GL_TEXTURE_2D, texture->name);
  gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, stride);
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  texture->stale_mipmaps = texture->filter == Filter::cells;
}

void ImGuiRenderer::destroy_texture(ImTextureID id) {
  const Texture* texture = find(id);
  if (texture == nullptr) return;
  gl_.DeleteTextures(1, &texture->name);
  textures_.erase(textures_.begin() + (texture - textures_.data()));
}

ImGuiRenderer::Texture* ImGuiRenderer::find(ImTextureID id) {
  const auto found =
      std::find_if(textures_.begin(), textures_.end(),
                   [name = name_of(id)](const Texture& texture) { return texture.name == name; });
  return found == textures_.end() ? nullptr : &*found;
}

void ImGuiRenderer::bind(ImTextureID id) {
  if (bound_ == name_of(id)) return;
  bound_ = name_of(id);
  gl_.BindTexture(GL_TEXTURE_2D, bound_);
  Texture* texture = find(id);
  if (texture == nullptr || !texture->stale_mipmaps) return;
  // Many small updates may precede one frame: the mipmaps are made once, when first drawn.
  gl_.GenerateMipmap(GL_TEXTURE_2D);
  texture->stale_mipmaps = false;
}

void ImGuiRenderer::render(const ImDrawData& data, ImU32 background) {
  const auto width = static_cast<GLsizei>(data.DisplaySize.x * data.FramebufferScale.x);
  const auto height = static_cast<GLsizei>(data.DisplaySize.y * data.FramebufferScale.y);
  if (width <= 0 || height <= 0) return;
  const ImVec4 clear = ImGui::ColorConvertU32ToFloat4(background);
  gl_.Viewport(0, 0, width, height);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.ClearColor(clear.x, clear.y, clear.z, clear.w);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  set_up(data);
  upload(data);
  draw(data);
}

void ImGuiRenderer::set_up(const ImDrawData& data) {
  gl_.Enable(GL_BLEND);
  gl_.BlendEquation(GL_FUNC_ADD);
  // Alpha of the frame stays 1, so that saved frames are opaque.
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.Disable(GL_CULL_FACE);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.UseProgram(program_);
  gl_.ActiveTexture(GL_TEXTURE0);
  bound_ = 0;
  const float left = data.DisplayPos.x;
  const float right = left + data.DisplaySize.x;
  const float top = data.DisplayPos.y;
  const float bottom = top + data.DisplaySize.y;
  const float w = right - left;
  const float h = top - bottom;
  const std::array<float, 16> projection = {
      2.0f / w, 0,   0, 0, 0, 2.0f / h, 0, 0, 0, 0, -1.0f, 0, -(right + left) / w, -(top + bottom) / h,
      0,        1.0f};
  gl_.UniformMatrix4fv(projection_location_, 1, GL_FALSE, projection.data());
}

void ImGuiRenderer::grow(GLenum target, GLsizeiptr& capacity, GLsizeiptr needed) {
  while (capacity < needed) capacity = std::max<GLsizeiptr>(capacity * 2, 1 << 16);
  // A fresh store each frame: the driver need not wait for the last frame's draws to finish.
  gl_.BufferData(target, capacity, nullptr, GL_STREAM_DRAW);
}

void ImGuiRenderer::upload(const ImDrawData& data) {
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
  grow(GL_ARRAY_BUFFER, vertex_capacity_, data.TotalVtxCount * static_cast<GLsizeiptr>(sizeof(ImDrawVert)));
  grow(GL_ELEMENT_ARRAY_BUFFER, index_capacity_,
       data.TotalIdxCount * static_cast<GLsizeiptr>(sizeof(ImDrawIdx)));
  GLintptr vertex_offset = 0;
  GLintptr index_offset = 0;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    gl_.BufferSubData(GL_ARRAY_BUFFER, vertex_offset, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data);
    gl_.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, index_offset, list.IdxBuffer.size_in_bytes(),
                      list.IdxBuffer.Data);
    vertex_offset += list.VtxBuffer.size_in_bytes();
    index_offset += list.IdxBuffer.size_in_bytes();
  }
}

void ImGuiRenderer::draw(const ImDrawData& data) {
  unsigned first_vertex = 0;
  unsigned first_index = 0;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback == nullptr) {
        draw_command(data, command, first_vertex, first_index);
      } else if (command.UserCallback != ImDrawCallback_ResetRenderState) {
        command.UserCallback(&list, &command);
      }
    }
    first_vertex += static_cast<unsigned>(list.VtxBuffer.Size);
    first_index += static_cast<unsigned>(list.IdxBuffer.Size);
  }
}

void ImGuiRenderer::draw_command(const ImDrawData& data, const ImDrawCmd& command, unsigned first_vertex,
                                 unsigned first_index) {
  const ImVec2 scale = data.FramebufferScale;
  const float frame_height = data.DisplaySize.y * scale.y;
  const float x0 = std::max((command.ClipRect.x - data.DisplayPos.x) * scale.x, 0.0f);
  const float y0 = std::max((command.ClipRect.y - data.DisplayPos.y) * scale.y, 0.0f);
  const float x1 = std::min((command.ClipRect.z - data.DisplayPos.x) * scale.x, data.DisplaySize.x * scale.x);
  const float y1 = std::min((command.ClipRect.w - data.DisplayPos.y) * scale.y, frame_height);
  if (x1 <= x0 || y1 <= y0) return;
  // OpenGL counts rows from below.
  gl_.Scissor(static_cast<GLint>(x0), static_cast<GLint>(frame_height - y1), static_cast<GLsizei>(x1 - x0),
              static_cast<GLsizei>(y1 - y0));
  bind(command.TextureId);
  const std::size_t first_byte = (first_index + command.IdxOffset) * sizeof(ImDrawIdx);
  count_from(first_vertex + command.VtxOffset);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), GL_UNSIGNED_SHORT,
                   byte_offset(first_byte));
}

}  // namespace replan::ui
