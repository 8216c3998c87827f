// The places that a scenario file names, written: what PlaceReader reads back. Only for the scenario's writer: it shows JSON
// types.
#pragma once

#include <vector>

#include "core/lattice/box.hpp"
#include "core/world/json_reader.hpp"

namespace replan {

/// Writes the places of one world.
class PlaceWriter {
 public:
  explicit PlaceWriter(const Box& world) : solid_(world.solid()) {}

  [[nodiscard]] bool solid() const { return solid_; }
  [[nodiscard]] Json cell(Cell cell) const;
  /// The cells as few rectangles, or boxes: each grows from its first cell to the right, then down, then to the next
  /// layers. Single cells are kept apart.
  [[nodiscard]] Json cells(std::vector<Cell> cells) const;

 private:
  bool solid_;
};

}  // namespace replan
