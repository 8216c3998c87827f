// Draws ImGui's draw lists on our own table of OpenGL functions: one drawing path for the window (GLFW) and
// for frames without a display (OSMesa), so that both show the same pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <imgui.h>

#include "core/base/result.hpp"
#include "ui/gl/gl.hpp"

namespace replan::ui {

/// How a texture is read between its texels.
enum class Filter {
  nearest,  ///< hard texels at every zoom
  linear,   ///< blended
  cells,    ///< hard texels when enlarged, averaged (mipmaps) when shrunk: thin walls do not flicker away
};

/// Owns the GL objects. Needs its context current in every call, its destructor included. It restores no GL
/// state: nothing else draws in these contexts.
class ImGuiRenderer {
 public:
  static Result<std::unique_ptr<ImGuiRenderer>> create(const Gl& gl);
  ~ImGuiRenderer();
  ImGuiRenderer(const ImGuiRenderer&) = delete;
  ImGuiRenderer& operator=(const ImGuiRenderer&) = delete;

  /// Uploads the current ImGui context's font atlas; again after every rebuild of the fonts.
  void upload_fonts();

  /// A texture of `width` x `height` RGBA texels (bytes R, G, B, A: the layout of IM_COL32), rows from the
  /// top. `texels` may be empty: the contents are then undefined until updated.
  ImTextureID create_texture(int width, int height, std::span<const std::uint32_t> texels, Filter filter);
  /// Replaces the rectangle at (x, y); `texels` holds its rows, `stride` texels apart (0: `width`).
  void update_texture(ImTextureID id, int x, int y, int width, int height,
                      std::span<const std::uint32_t> texels, int stride = 0);
  void destroy_texture(ImTextureID id);
  /// The longest side a texture may have in this context; larger rasters must be tiled.
  [[nodiscard]] int max_texture_size() const { return max_texture_size_; }

  [[nodiscard]] const Gl& gl() const { return gl_; }

  /// Clears the frame to `background` and draws `data` over it.
  void render(const ImDrawData& data, ImU32 background);

 private:
  struct Texture {
    GLuint name = 0;
    Filter filter = Filter::nearest;
    bool stale_mipmaps = false;
  };

  explicit ImGuiRenderer(const Gl& gl);
  Result<void> build_program();
  void build_buffers();
  Texture* find(ImTextureID id);
  void bind(ImTextureID id);
  void set_up(const ImDrawData& data);
  void upload(const ImDrawData& data);
  void draw(const ImDrawData& data);
  void draw_command(const ImDrawData& data, const ImDrawCmd& command, unsigned first_vertex,
                    unsigned first_index);
  void count_from(unsigned vertex);
  void grow(GLenum target, GLsizeiptr& capacity, GLsizeiptr needed);

  const Gl& gl_;
  GLuint program_ = 0;
  GLint projection_location_ = -1;
  GLuint vertex_array_ = 0;
  GLuint vertex_buffer_ = 0;
  GLuint index_buffer_ = 0;
  GLsizeiptr vertex_capacity_ = 0;
  GLsizeiptr index_capacity_ = 0;
  GLuint bound_ = 0;
  std::optional<unsigned> counted_from_;  // the vertex that the attributes begin at
  int max_texture_size_ = 0;
  ImTextureID font_texture_ = nullptr;
  std::vector<Texture> textures_;
};

}  // namespace replan::ui
