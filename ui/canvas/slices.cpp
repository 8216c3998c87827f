#include "ui/canvas/slices.hpp"

#include <algorithm>

namespace replan::ui {

void Slices::set(std::size_t pane, Slice slice, SlicePanes panes) {
  const Slice before = of(pane);
  if (panes == SlicePanes::alike) std::replace(slices_.begin(), slices_.end(), before, slice);
  slices_[pane % slices_.size()] = slice;
}

void Slices::show(std::size_t pane, Cell cell, SlicePanes panes) {
  Slice slice = of(pane);
  slice.layer = coordinate(cell, slice.along);
  set(pane, slice, panes);
}

void turn_slice(Slices& slices, std::size_t pane, const Box& world, Axis along, std::optional<Cell> pinned) {
  if (!world.solid() || slices.of(pane).along == along) return;
  const bool there = pinned && world.contains(*pinned);
  slices.set(pane, {along, there ? coordinate(*pinned, along) : SeenBox(world, along).depth() / 2});
}

void move_slice(Slices& slices, std::size_t pane, const Box& world, int by, SlicePanes panes) {
  const Sheet now = sheet_of(world, slices.of(pane));
  slices.follows_robot = false;
  slices.set(pane, {now.box.along(), std::clamp(now.layer + by, 0, now.box.depth() - 1)}, panes);
}

}  // namespace replan::ui
