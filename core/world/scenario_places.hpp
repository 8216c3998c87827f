// The places that a scenario file names: cells and boxes of cells, of two coordinates in a plane and of three in a
// world of more than one layer. Only for the scenario's reader: it shows JSON types.
#pragma once

#include <cstddef>
#include <vector>

#include "core/lattice/box.hpp"
#include "core/world/json_reader.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// Reads places on one map. Errors are kept in the JsonReader.
class PlaceReader {
 public:
  PlaceReader() = default;
  explicit PlaceReader(const Box& world) : world_(world) {}

  /// A cell that must be on the map.
  [[nodiscard]] Cell cell(const JsonNode& node) const;
  /// Appends the cells of `{"cells": [...], "rectangles": [...]}`, in space `boxes`.
  void cells(const JsonNode& node, bool blocked, std::vector<CellChange>& changes);
  /// Puts changes in the order of nodes, each cell once; one that is both added and removed is an error at `node`.
  void tidy(const JsonNode& node, std::vector<CellChange>& changes) const;
  /// The sides of a moving obstacle.
  void size(const JsonNode& node, MovingObstacle& mover) const;

 private:
  void box(const JsonNode& node, bool blocked, std::vector<CellChange>& changes);
  [[nodiscard]] bool take(const JsonNode& node, std::size_t count);

  Box world_;
  std::size_t listed_ = 0;
};

}  // namespace replan
