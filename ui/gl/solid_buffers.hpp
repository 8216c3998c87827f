// What of a world in space lies on the graphics card: the faces of its blocks, and what a scene has besides. Only what has
// changed goes there.
#pragma once

#include <span>
#include <vector>

#include "core/scene/solid_mesh.hpp"
#include "core/scene/solid_scene.hpp"
#include "ui/gl/gl.hpp"

namespace replan::ui {

/// Owns its GL objects. Needs their context current in every call, its destructor included.
class SolidBuffers {
 public:
  /// Instances of one kind.
  struct Instances {
    GLuint array = 0, buffer = 0;
    GLsizei count = 0;
    std::uint64_t revision = 0;
  };

  explicit SolidBuffers(const Gl& gl) : gl_(gl) {}
  ~SolidBuffers();
  SolidBuffers(const SolidBuffers&) = delete;
  SolidBuffers& operator=(const SolidBuffers&) = delete;

  /// The blocks of a mesh that have changed.
  void upload(const SolidMesh& mesh);
  /// A scene whose number is another one than before.
  void upload(const SolidScene& scene, std::uint64_t number);
  /// What went to the graphics card, all frames together.
  struct Uploads {
    std::size_t blocks = 0, scenes = 0;
  };
  [[nodiscard]] const Uploads& uploads() const { return uploads_; }

  [[nodiscard]] const std::vector<Instances>& blocks() const { return blocks_; }
  [[nodiscard]] const Instances& cut() const { return cut_; }
  [[nodiscard]] const Instances& boxes() const { return boxes_; }
  [[nodiscard]] const Instances& lines() const { return lines_; }
  /// The texture of the picture on the slice.
  [[nodiscard]] GLuint sheet() const { return sheet_; }

 private:
  /// A part of what is drawn once for each instance, at the shader's location of its number in the list.
  struct Attribute {
    GLint count;
    GLenum type;
    std::size_t offset;
  };
  [[nodiscard]] Instances make_instances(std::size_t size, std::span<const Attribute> attributes);
  [[nodiscard]] Instances make_faces();
  [[nodiscard]] Instances make_boxes();
  [[nodiscard]] Instances make_lines();
  template <class Item>
  void fill(Instances& instances, std::span<const Item> items);
  void upload_sheet(const SolidSheet& sheet);
  static SolidSheet thinned(const SolidSheet& sheet, int largest);
  void release(Instances& instances);

  const Gl& gl_;
  std::vector<Instances> blocks_;
  Instances cut_, boxes_, lines_;
  GLuint sheet_ = 0;
  std::uint64_t scene_number_ = 0;
  Uploads uploads_;
};

}  // namespace replan::ui
