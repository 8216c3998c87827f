// Which cells are bad, laid out for lines of sight.
//
// In the plane a segment is a run of cells in each row that it crosses (or in
// each column, if it is steep), and a run is tested 64 cells at a time. Over
// open ground the rows are many: counts of bad cells in tiles of 64, 512, 4096
// ... cells a side say how many of them may be passed over at once. In space
// rays go cell by cell, and leap over tiles of 8 and of 64 cells a side without
// a bad cell.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/lattice/box_lattice.hpp"

namespace replan {

/// Bits in lines: rows, or columns.
class BitLines {
 public:
  BitLines() = default;
  BitLines(int lines, int length)
      : words_((static_cast<std::size_t>(length) + 63) / 64),
        bits_(static_cast<std::size_t>(lines) * words_ + 1) {}

  void set(int line, int at, bool value) {
    std::uint64_t& word = bits_[static_cast<std::size_t>(line) * words_ + static_cast<std::size_t>(at >> 6)];
    const std::uint64_t bit = std::uint64_t{1} << (at & 63);
    word = value ? word | bit : word & ~bit;
  }
  [[nodiscard]] const std::uint64_t* line(int number) const {
    return bits_.data() + static_cast<std::ptrdiff_t>(number) * stride();
  }
  /// From a line's first word to the next line's.
  [[nodiscard]] std::ptrdiff_t stride() const { return static_cast<std::ptrdiff_t>(words_); }

  /// Whether none of the bits first .. last of a line is set.
  static bool clear(const std::uint64_t* line, int first, int last) {
    const auto from = static_cast<unsigned>(first), more = static_cast<unsigned>(last - first);
    if (more >= kShort) return clear_long(line, from, static_cast<unsigned>(last));
    // From a whole byte on: eight bytes hold a short run, wherever it begins.
    std::uint64_t bits = 0;
    std::memcpy(&bits, reinterpret_cast<const unsigned char*>(line) + (from >> 3), sizeof bits);
    return (bits >> (from & 7) & kRuns[more]) == 0;
  }
  static bool test(const std::uint64_t* line, int at) { return (line[at >> 6] >> (at & 63) & 1) != 0; }

  [[nodiscard]] std::size_t memory_bytes() const { return bits_.capacity() * sizeof bits_[0]; }

 private:
  static_assert(std::endian::native == std::endian::little);
  static constexpr unsigned kShort = 57;
  static constexpr auto kRuns = [] {
    std::array<std::uint64_t, kShort> runs{};
    for (unsigned more = 0; more < kShort; ++more) runs[more] = (std::uint64_t{2} << more) - 1;
    return runs;
  }();

  static bool clear_long(const std::uint64_t* line, unsigned first, unsigned last) {
    const std::uint64_t from = ~std::uint64_t{0} << (first & 63),
                        to = ~std::uint64_t{0} >> (63 - (last & 63));
    unsigned word = first >> 6;
    const unsigned end = last >> 6;
    if (word == end) return (line[word] & from & to) == 0;
    if ((line[word] & from) != 0) return false;
    while (++word < end)
      if (line[word] != 0) return false;
    return (line[end] & to) == 0;
  }

  std::size_t words_ = 0;  // of a line; one more stands behind the last
  std::vector<std::uint64_t> bits_;
};

/// Tile counts over a box lattice of any dimension. Its owner tells it of every
/// cell that turns bad or good.
template <int D>
class SightMap {
 public:
  using Coordinates = typename BoxLattice<D>::Coordinates;

  SightMap() = default;
  /// Counts the cells for which `bad(node)` holds.
  template <class Bad>
  SightMap(const BoxLattice<D>& lattice, Bad&& bad) {
    std::size_t small = 1, large = 1;
    for (std::size_t axis = 0; axis < D; ++axis) {
      small_stride_[axis] = small;
      large_stride_[axis] = large;
      small *= static_cast<std::size_t>(lattice.size()[axis] + 7) / 8;
      large *= static_cast<std::size_t>(lattice.size()[axis] + 63) / 64;
    }
    small_.resize(small);
    large_.resize(large);
    for (NodeId node = 0; node < lattice.node_count(); ++node)
      if (bad(node)) change(lattice.coordinates(node), true);
  }

  /// A cell has turned bad, or good again.
  void change(const Coordinates& at, bool bad) {
    small_[tile(at, 3, small_stride_)] += bad ? 1 : -1;
    large_[tile(at, 6, large_stride_)] += bad ? 1 : -1;
  }

  /// The side of the largest tile around a cell that has no bad cell in it: 64,
  /// 8, or 1 if there is none.
  [[nodiscard]] int empty_tile(const Coordinates& at) const {
    if (large_[tile(at, 6, large_stride_)] == 0) return 64;
    return small_[tile(at, 3, small_stride_)] == 0 ? 8 : 1;
  }

  [[nodiscard]] std::size_t memory_bytes() const {
    return small_.capacity() * sizeof small_[0] + large_.capacity() * sizeof large_[0];
  }

 private:
  static std::size_t tile(const Coordinates& at, int shift, const std::array<std::size_t, D>& stride) {
    std::size_t index = 0;
    for (std::size_t axis = 0; axis < D; ++axis)
      index += static_cast<std::size_t>(at[axis] >> shift) * stride[axis];
    return index;
  }

  std::array<std::size_t, D> small_stride_{}, large_stride_{};
  std::vector<std::int32_t> small_, large_;
};

/// In the plane: bits in rows and in columns, and counts of tiles that are ever
/// larger.
template <>
class SightMap<2> {
 public:
  using Coordinates = Grid2::Coordinates;

  SightMap() = default;
  template <class Bad>
  SightMap(const Grid2& lattice, Bad&& bad)
      : lines_{BitLines(lattice.height(), lattice.width()), BitLines(lattice.width(), lattice.height())} {
    const int longest = std::max(lattice.width(), lattice.height());
    for (int shift = 6; shift == 6 || (longest >> (shift - 3)) > 0; shift += 3) {
      const auto across = static_cast<std::size_t>(((lattice.width() - 1) >> shift) + 1);
      const auto down = static_cast<std::size_t>(((lattice.height() - 1) >> shift) + 1);
      levels_.push_back({shift, across, std::vector<std::int32_t>(across * down)});
    }
    NodeId node = 0;
    for (int y = 0; y < lattice.height(); ++y)
      for (int x = 0; x < lattice.width(); ++x, ++node)
        if (bad(node)) change({x, y}, true);
  }

  /// A cell has turned bad, or good again.
  void change(const Coordinates& at, bool bad) {
    lines_[0].set(at[1], at[0], bad);
    lines_[1].set(at[0], at[1], bad);
    for (Level& level : levels_) level.count(at) += bad ? 1 : -1;
  }

  /// Rows (0), a bit for each x, or columns (1), a bit for each y.
  [[nodiscard]] const BitLines& lines(int axis) const { return lines_[static_cast<std::size_t>(axis)]; }
  /// The side of the largest tile around a cell that has no bad cell in it,
  /// from 64 on; 1 if there is none.
  [[nodiscard]] int empty_tile(const Coordinates& at) const {
    int side = 1;
    for (const Level& level : levels_) {
      if (level.count(at) != 0) break;
      side = 1 << level.shift;
    }
    return side;
  }

  [[nodiscard]] std::size_t memory_bytes() const {
    std::size_t bytes = lines_[0].memory_bytes() + lines_[1].memory_bytes();
    for (const Level& level : levels_) bytes += level.counts.capacity() * sizeof level.counts[0];
    return bytes;
  }

 private:
  struct Level {
    int shift;
    std::size_t across;
    std::vector<std::int32_t> counts;

    [[nodiscard]] std::size_t tile(const Coordinates& at) const {
      return static_cast<std::size_t>(at[1] >> shift) * across + static_cast<std::size_t>(at[0] >> shift);
    }
    [[nodiscard]] std::int32_t& count(const Coordinates& at) { return counts[tile(at)]; }
    [[nodiscard]] std::int32_t count(const Coordinates& at) const { return counts[tile(at)]; }
  };

  std::array<BitLines, 2> lines_;
  std::vector<Level> levels_;
};

/// Stands in where there are no tiles: a ray then looks at every cell.
struct NoSightMap {
  template <class Coordinates>
  static constexpr int empty_tile(const Coordinates&) {
    return 1;
  }
};

}  // namespace replan
