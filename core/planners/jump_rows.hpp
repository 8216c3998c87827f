// Rows and columns of a plane as bits, 64 cells a word: how a jump passes over cells without looking at each.
//
//  Harabor & Grastien, "Improving Jump Point Search", ICAPS 2014, section 3 (block-based scanning)
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/lattice/box_lattice.hpp"

namespace replan {

/// The obstacles of a plane along one axis: a line of bits for each row, set where a cell is blocked, with a blocked
/// cell before and behind and a blocked row on either side. Beside it, for ways forwards and backwards along the row,
/// where a jump has to stop: at what is blocked, and where the way may have to turn, since beside it an obstacle ends.
/// With `cuts_corners` that is beside the obstacle's last cell, where a diagonal leads round it, else one cell farther.
class BitRows {
 public:
  BitRows() = default;
  BitRows(int length, int count, bool cuts_corners)
      : cuts_corners_(cuts_corners),
        words_(static_cast<std::size_t>(length + 2 + 63) / 64),
        bits_(words_ * static_cast<std::size_t>(count + 2), ~std::uint64_t{0}),
        stops_{bits_, bits_} {}

  /// What was set before refresh() is called shows in stop() thereafter.
  void set(int at, int row, bool blocked) {
    std::uint64_t& word = bits_[first_word(row) + static_cast<std::size_t>(at + 1) / 64];
    const std::uint64_t bit = std::uint64_t{1} << (static_cast<unsigned>(at + 1) % 64);
    word = blocked ? word | bit : word & ~bit;
  }
  void refresh(int row) {
    for (std::size_t word = 0; word < words_; ++word) refresh_word(first_word(row), word);
  }
  /// What that cell has a share in.
  void refresh_around(int at, int row, int rows) {
    const std::size_t middle = static_cast<std::size_t>(at + 1) / 64;
    for (int near = std::max(0, row - 1); near <= std::min(rows - 1, row + 1); ++near)
      for (std::size_t word = middle - (middle > 0 ? 1 : 0); word < std::min(words_, middle + 2); ++word)
        refresh_word(first_word(near), word);
  }
  [[nodiscard]] std::size_t memory_bytes() const { return 3 * bits_.capacity() * sizeof bits_[0]; }

  /// The first cell to stop at from `at` on along a row.
  template <bool kForwards>
  [[nodiscard]] int stop(int at, int row) const {
    const std::uint64_t* const stops = &stops_[kForwards ? 0 : 1][first_word(row)];
    auto word = static_cast<std::size_t>(at + 1) / 64;
    const unsigned bit = static_cast<unsigned>(at + 1) % 64;
    // The cells of its word that lie ahead.
    const std::uint64_t ahead = kForwards ? ~std::uint64_t{1} << bit : (std::uint64_t{1} << bit) - 1;
    std::uint64_t found = stops[word] & ahead;
    while (found == 0) found = stops[kForwards ? ++word : --word];
    return static_cast<int>(word) * 64 +
           (kForwards ? std::countr_zero(found) : 63 - std::countl_zero(found)) - 1;
  }
  [[nodiscard]] bool blocked(int at, int row) const {
    return (bits_[first_word(row) + static_cast<std::size_t>(at + 1) / 64] >>
                (static_cast<unsigned>(at + 1) % 64) &
            1u) != 0;
  }

 private:
  [[nodiscard]] std::size_t first_word(int row) const { return static_cast<std::size_t>(row + 1) * words_; }

  void refresh_word(std::size_t first, std::size_t word) {
    const std::uint64_t* const here = &bits_[first];
    stops_[0][first + word] = here[word] | ends<true>(here - words_, word) | ends<true>(here + words_, word);
    stops_[1][first + word] =
        here[word] | ends<false>(here - words_, word) | ends<false>(here + words_, word);
  }
  /// Where an obstacle of that row ends, on a way forwards or backwards. What lies beyond the row counts as blocked.
  template <bool kForwards>
  [[nodiscard]] std::uint64_t ends(const std::uint64_t* row, std::size_t word) const {
    const std::uint64_t bits = row[word];
    if (kForwards != cuts_corners_) {
      // The cell at the smaller index beside each.
      const std::uint64_t before = bits << 1 | (word == 0 ? 1 : row[word - 1] >> 63);
      return kForwards ? before & ~bits : bits & ~before;
    }
    const std::uint64_t after =
        bits >> 1 | (word + 1 == words_ ? std::uint64_t{1} << 63 : row[word + 1] << 63);
    return kForwards ? bits & ~after : after & ~bits;
  }

  bool cuts_corners_ = false;
  std::size_t words_ = 0;  // of a row
  std::vector<std::uint64_t> bits_;
  std::array<std::vector<std::uint64_t>, 2> stops_;  // forwards, backwards
};

/// Both axes of a plane.
class JumpRows {
 public:
  explicit JumpRows(bool cuts_corners) : cuts_corners_(cuts_corners) {}

  /// Of the lattice as it is; made anew only if that has changed untold.
  void make(const Grid2& lattice) {
    if (revision_ == lattice.revision()) return;
    revision_ = lattice.revision();
    const int width = lattice.width(), height = lattice.height();
    along_x_ = BitRows(width, height, cuts_corners_);
    along_y_ = BitRows(height, width, cuts_corners_);
    const auto cells = lattice.cells();
    for (int y = 0, n = 0; y < height; ++y)
      for (int x = 0; x < width; ++x, ++n)
        if (cells[static_cast<std::size_t>(n)] == 0) set(x, y, false);
    for (int y = 0; y < height; ++y) along_x_.refresh(y);
    for (int x = 0; x < width; ++x) along_y_.refresh(x);
  }
  /// The lattice shows these edits already, and nothing else has changed.
  void update(const Grid2& lattice, std::span<const CellEdit> edits) {
    for (const CellEdit& edit : edits) {
      const auto [x, y] = lattice.coordinates(edit.node);
      set(x, y, edit.blocked);
      along_x_.refresh_around(x, y, lattice.height());
      along_y_.refresh_around(y, x, lattice.width());
    }
    revision_ = lattice.revision();
  }
  [[nodiscard]] std::size_t memory_bytes() const { return along_x_.memory_bytes() + along_y_.memory_bytes(); }

  [[nodiscard]] bool blocked(int x, int y) const { return along_x_.blocked(x, y); }
  /// The coordinate along the axis of the first cell to stop at from (x, y) on; `sign` is 1 or -1.
  [[nodiscard]] int stop(std::size_t axis, int sign, int x, int y) const {
    if (axis == 0) return sign > 0 ? along_x_.stop<true>(x, y) : along_x_.stop<false>(x, y);
    return sign > 0 ? along_y_.stop<true>(y, x) : along_y_.stop<false>(y, x);
  }

 private:
  void set(int x, int y, bool blocked) {
    along_x_.set(x, y, blocked);
    along_y_.set(y, x, blocked);
  }

  bool cuts_corners_;
  BitRows along_x_, along_y_;
  std::uint64_t revision_ = 0;  // of the lattice that both are of; 0: none
};

}  // namespace replan
