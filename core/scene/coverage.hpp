// How much of each block of cells is obstacle, for views in which a pixel covers many cells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/lattice/seen_box.hpp"
#include "core/scene/digest.hpp"
#include "core/scene/map_follower.hpp"

namespace replan {

/// Blocks of 2, 4, 8 ... cells a side. A share is kept in 255ths, rounded up: a block with one obstacle is
/// never 0.
class Coverage {
 public:
  Coverage() = default;
  /// Of a layer, as it is seen, of the true or the known map as it is in `state`.
  Coverage(const SeenBox& world, int layer, const SearchState& state, EventKind map);

  struct Level {
    int columns = 0, rows = 0;
    std::vector<std::uint8_t> shares;
    std::uint8_t& at(int x, int y) {
      return shares[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(x)];
    }
    [[nodiscard]] const std::uint8_t* row(int y) const {
      return shares.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(columns);
    }
  };
  /// Level n has blocks of 2^n cells; there is none below 1.
  [[nodiscard]] const Level& level(int n) const { return levels_[static_cast<std::size_t>(n - 1)]; }
  [[nodiscard]] int levels() const { return static_cast<int>(levels_.size()); }

  /// The 2 x 2 cells around (x, y) have changed; `blocked` of them are obstacles now.
  void change(Cell cell, int blocked);

 private:
  void allocate(int columns, int rows);
  template <class AddRow>
  void fill(Level& level, int rows_below, const AddRow& add);
  void gather(std::size_t level, int x, int y);

  std::vector<Level> levels_;
};

/// Coverage of one layer by the true and by the known map at a run's cursor.
class MapCoverage {
 public:
  /// Brings both to the cursor's state.
  void follow(const Run& run, const RunDigest& digest, const SeenBox& world, int layer);
  [[nodiscard]] const Coverage& truth() const { return truth_; }
  [[nodiscard]] const Coverage& known() const { return known_; }
  /// Another number whenever one of them has changed.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  void recount(const Run& run, const MapEvent& event);

  std::uint64_t revision_ = 0;
  SeenBox world_;
  int layer_ = 0;
  MapFollower follower_;
  Coverage truth_, known_;
};

}  // namespace replan
