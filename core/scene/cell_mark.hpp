// Marks that are drawn cell by cell.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/scene/context.hpp"

namespace replan {

/// One mark of a scene in the making. Marks of the same layer are drawn in one pass over the cells in sight.
class CellMark {
 public:
  virtual ~CellMark() = default;
  /// Whether it can stand on any cell; if not, it is asked to finish() alone.
  [[nodiscard]] virtual bool wants_cells() const { return true; }
  /// The cells from `first` to the end of its page (SearchState::kPage) come next: whether the mark can stand on one
  /// of them. Most of a large map was never touched.
  virtual bool turn_to(NodeId first);
  virtual void add(Cell cell, NodeId node) = 0;
  /// After the last cell.
  virtual void finish() {}
};

/// Asks each of the marks for every cell in sight, or, where a pixel covers many, for one of them a pixel.
void add_cell_marks(SceneContext& context, std::span<const std::unique_ptr<CellMark>> marks);

/// Outlines a cell where cells are large enough for it, and tints it where they are small.
void mark_cell(SceneContext& context, Cell cell, OutlineShape shape, Colour colour, double strength,
               float stroke, float inset);

/// Hairlines between the cells in sight.
void add_cell_lines(SceneContext& context, Colour colour);

/// How wide words of the size of the numbers are, in the world.
double words_width(const SceneContext& context, std::string_view words);

}  // namespace replan
