// The faces of a world's obstacles, as an orbit view draws them: those between an obstacle and free space, joined to
// rectangles, and kept up to date block by block.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/deadline.hpp"
#include "core/base/point.hpp"
#include "core/lattice/box.hpp"
#include "core/scene/map_follower.hpp"
#include "core/scene/palette.hpp"
#include "core/scene/scene.hpp"

namespace replan {

/// A rectangle of cells' faces that look one way and have one colour: 16 bytes, as they go to the graphics card.
struct SolidFace {
  std::uint16_t x, y, z;  ///< the first of its cells
  std::uint16_t side;     ///< where it looks: 0 to 5 for -x, +x, -y, +y, -z, +z
  std::uint16_t across,
      on;  ///< how many cells it has along the two axes beside that of its side, in the order x, y, z
  Colour colour;
  friend bool operator==(const SolidFace&, const SolidFace&) = default;
};
static_assert(sizeof(SolidFace) == 16);

/// A world seen from outside would be hidden by its own walls: faces at its border that look outwards are left out, so that
/// one looks into it from every side.
class SolidMesh {
 public:
  static constexpr int kBlock = 32;  ///< cells along each side of a block

  /// Learns which blocks are no longer as the run's cursor has them. What the robot does not know of may be left out, as
  /// on slices without Overlay::unknown.
  void follow(const Run& run, const RunDigest& digest, const Palette& palette, bool shows_unknown = true);
  /// Makes such blocks anew, those nearest to the eye first, until the time is up; one in any case.
  void make(const Run& run, const Point& eye, const Deadline& deadline);
  /// How many blocks wait to be made.
  [[nodiscard]] std::size_t waiting() const { return waiting_; }

  [[nodiscard]] std::size_t block_count() const { return blocks_.size(); }
  [[nodiscard]] std::span<const SolidFace> faces(std::size_t block) const { return blocks_[block].faces; }
  /// The cells that a block has.
  [[nodiscard]] CellBox cells(std::size_t block) const;
  /// Another number whenever the block's faces have changed, and whenever those of some block have.
  [[nodiscard]] std::uint64_t revision(std::size_t block) const { return blocks_[block].revision; }
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] std::size_t face_count() const;
  /// What of its obstacles a legend has to tell.
  [[nodiscard]] SignSet signs() const;

 private:
  struct Block {
    std::vector<SolidFace> faces;
    std::uint64_t revision = 0;
    SignSet signs;
    bool stale = true;
  };
  /// What colours depend on.
  struct Colours {
    Colours(const Palette& palette, bool shows_unknown);
    Colours() = default;
    Colour obstacle = 0, mover = 0, surprise = 0, unknown = 0, gone = 0;
    friend bool operator==(const Colours&, const Colours&) = default;
  };
  class Reader;
  friend std::vector<SolidFace> cut_faces(const Run& run, Axis across, int layer, bool towards_higher,
                                          const Palette& palette, bool shows_unknown);

  void begin(const Run& run);
  void note_surprises(const Run& run);
  void mark(Cell cell);
  void mark_all();
  void mark_block(std::size_t block);
  void make_block(Reader& reader, std::size_t block);
  [[nodiscard]] SignSet signs_of(std::span<const SolidFace> faces) const;
  [[nodiscard]] std::size_t block_of(Cell cell) const;

  Box world_;
  Box grid_;  // of blocks
  Colours colours_;
  std::vector<Block> blocks_;
  std::vector<NodeId> surprising_;  // that some surprise blocks without telling the robot, ascending
  std::size_t waiting_ = 0;
  std::uint64_t log_id_ = 0;
  std::uint64_t revision_ = 0;
  MapFollower follower_;
};

/// The faces of one layer of obstacles that look along an axis towards a viewer: what a cut through the world shows. Their
/// colours are those of the obstacles, a little off, so that a cut is seen to be one. None where the world is longer than a
/// face can tell.
std::vector<SolidFace> cut_faces(const Run& run, Axis across, int layer, bool towards_higher,
                                 const Palette& palette, bool shows_unknown);

}  // namespace replan
