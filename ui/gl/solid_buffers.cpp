#include "ui/gl/solid_buffers.hpp"

#include <array>
#include <cstddef>

#include "ui/gl/shader.hpp"

namespace replan::ui {

SolidBuffers::~SolidBuffers() {
  for (Instances& each : blocks_) release(each);
  for (Instances* each : {&cut_, &boxes_, &lines_}) release(*each);
  gl_.DeleteTextures(1, &sheet_);
}

SolidBuffers::Instances SolidBuffers::make_instances(std::size_t size,
                                                     std::span<const Attribute> attributes) {
  Instances made;
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

SolidBuffers::Instances SolidBuffers::make_faces() {
  constexpr std::array<Attribute, 4> kAttributes = {{{3, GL_UNSIGNED_SHORT, offsetof(SolidFace, x)},
                                                     {1, GL_UNSIGNED_SHORT, offsetof(SolidFace, side)},
                                                     {2, GL_UNSIGNED_SHORT, offsetof(SolidFace, across)},
                                                     {4, GL_UNSIGNED_BYTE, offsetof(SolidFace, colour)}}};
  return make_instances(sizeof(SolidFace), kAttributes);
}

SolidBuffers::Instances SolidBuffers::make_boxes() {
  constexpr std::array<Attribute, 3> kAttributes = {{{3, GL_FLOAT, offsetof(SolidBox, low)},
                                                     {3, GL_FLOAT, offsetof(SolidBox, high)},
                                                     {4, GL_UNSIGNED_BYTE, offsetof(SolidBox, colour)}}};
  return make_instances(sizeof(SolidBox), kAttributes);
}

SolidBuffers::Instances SolidBuffers::make_lines() {
  constexpr std::array<Attribute, 4> kAttributes = {{{3, GL_FLOAT, offsetof(SolidLine, from)},
                                                     {3, GL_FLOAT, offsetof(SolidLine, to)},
                                                     {4, GL_UNSIGNED_BYTE, offsetof(SolidLine, colour)},
                                                     {1, GL_FLOAT, offsetof(SolidLine, width)}}};
  return make_instances(sizeof(SolidLine), kAttributes);
}

void SolidBuffers::release(Instances& instances) {
  gl_.DeleteBuffers(1, &instances.buffer);
  gl_.DeleteVertexArrays(1, &instances.array);
  instances = {};
}

template <class Item>
void SolidBuffers::fill(Instances& instances, std::span<const Item> items) {
  gl_.BindBuffer(GL_ARRAY_BUFFER, instances.buffer);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(items.size_bytes()), items.data(), GL_DYNAMIC_DRAW);
  instances.count = static_cast<GLsizei>(items.size());
}

void SolidBuffers::upload(const SolidMesh& mesh) {
  while (blocks_.size() > mesh.block_count()) {
    release(blocks_.back());
    blocks_.pop_back();
  }
  blocks_.resize(mesh.block_count());
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (blocks_[i].revision == mesh.revision(i)) continue;
    if (blocks_[i].array == 0) blocks_[i] = make_faces();  // most of a world may be empty
    fill(blocks_[i], mesh.faces(i));
    blocks_[i].revision = mesh.revision(i);
    ++uploads_.blocks;
  }
}

void SolidBuffers::upload(const SolidScene& scene, std::uint64_t number) {
  if (scene_number_ == number) return;
  scene_number_ = number;
  if (cut_.array == 0) {
    cut_ = make_faces();
    boxes_ = make_boxes();
    lines_ = make_lines();
  }
  fill(cut_, std::span<const SolidFace>(scene.cut_faces));
  fill(boxes_, std::span<const SolidBox>(scene.boxes));
  fill(lines_, std::span<const SolidLine>(scene.lines));
  upload_sheet(scene.sheet);
  ++uploads_.scenes;
}

/// The picture with so few texels that a texture has room for it: every n-th of a row, and every m-th row.
SolidSheet SolidBuffers::thinned(const SolidSheet& sheet, int largest) {
  const auto each = [largest](int side) { return (side + largest - 1) / largest; };
  const int across = each(sheet.columns), down = each(sheet.rows);
  SolidSheet thin{(sheet.columns + across - 1) / across, (sheet.rows + down - 1) / down, {}, {}, {}, {}};
  for (int row = 0; row < sheet.rows; row += down)
    for (int column = 0; column < sheet.columns; column += across)
      thin.texels.push_back(
          sheet.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(sheet.columns) +
                       static_cast<std::size_t>(column)]);
  return thin;
}

void SolidBuffers::upload_sheet(const SolidSheet& sheet) {
  if (sheet.texels.empty()) return;
  if (sheet_ == 0) gl_.GenTextures(1, &sheet_);
  gl_.BindTexture(GL_TEXTURE_2D, sheet_);
  for (const GLenum filter : std::array<GLenum, 2>{GL_TEXTURE_MAG_FILTER, GL_TEXTURE_MIN_FILTER})
    gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  for (const GLenum side : std::array<GLenum, 2>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_.TexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
  gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  GLint largest = 0;
  gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const bool fits = sheet.columns <= largest && sheet.rows <= largest;
  const SolidSheet thin = fits ? SolidSheet() : thinned(sheet, largest);
  const SolidSheet& fitting = fits ? sheet : thin;
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, fitting.columns, fitting.rows, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 fitting.texels.data());
}

}  // namespace replan::ui
