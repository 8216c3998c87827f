// Which layer each pane shows of a world of more than one.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/scene/view.hpp"

namespace replan::ui {

/// Which of the panes a change is for.
enum class SlicePanes { alike, alone };

class Slices {
 public:
  [[nodiscard]] const Slice& of(std::size_t pane) const { return slices_[pane % slices_.size()]; }
  /// Has a pane show another one: `alike` also has those do that show the same as it, so that panes stay together until one
  /// is moved alone.
  void set(std::size_t pane, Slice slice, SlicePanes panes = SlicePanes::alike);
  void set_all(Slice slice) {
    slices_.fill(slice);
    chosen_ = true;
  }
  /// Of another world: whoever draws it first chooses.
  void forget() { chosen_ = false; }
  [[nodiscard]] bool chosen() const { return chosen_; }
  /// The one that shows the layer of a cell of the world along the axis that the pane is seen.
  void show(std::size_t pane, Cell cell, SlicePanes panes = SlicePanes::alike);

  /// Whether a pane shows the whole world from outside, with its slice framed in it.
  [[nodiscard]] bool orbits(std::size_t pane) const { return orbits_[pane % orbits_.size()]; }
  void set_orbits(std::size_t pane, bool on) { orbits_[pane % orbits_.size()] = on; }

  bool follows_robot = false;  ///< the layer is the robot's, wherever it goes

 private:
  std::array<Slice, 4> slices_;  // a session has no more panes
  std::array<bool, 4> orbits_{};
  bool chosen_ = false;
};

/// "z"
constexpr const char* axis_name(Axis axis) {
  return axis == Axis::x ? "x" : axis == Axis::y ? "y" : "z";
}

/// Has a pane look along another axis, at the layer of the cell that is pinned, else at the middle one.
void turn_slice(Slices& slices, std::size_t pane, const Box& world, Axis along, std::optional<Cell> pinned);
/// Moves a pane's slice by so many layers, as far as there are some; it follows the robot no more.
void move_slice(Slices& slices, std::size_t pane, const Box& world, int by,
                SlicePanes panes = SlicePanes::alike);

}  // namespace replan::ui
