// The hand on the canvas: turns presses and drags into commands.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

#include "ui/canvas.hpp"

namespace replan::ui {

/// A rectangle of cells, both ends included.
struct CellRect {
  Cell low, high;
};

/// What the mouse does in one frame.
struct Pointer {
  Cell cell;    ///< under the cursor; may lie outside the world
  bool inside;  ///< the cursor is over the canvas, and the canvas has the mouse
  bool left_pressed, right_pressed;
  bool left_down, right_down;
  double reach;  ///< how many cells away a start or goal can still be grabbed
};

class Hand {
 public:
  /// Takes in a frame's input and appends what it comes to.
  void update(const Session& session, const Run& run, ViewState& state, const Pointer& pointer,
              std::vector<Command>& commands);

  /// A drag is under way.
  [[nodiscard]] bool busy() const { return action_ != Action::none; }
  /// A start or goal is held.
  [[nodiscard]] bool holds() const { return action_ == Action::start || action_ == Action::goal; }
  /// Whether a press at this cell would take hold of the start or the goal.
  [[nodiscard]] static bool could_hold(const Session& session, const Pointer& pointer);
  /// The rectangle that would be filled if the button were let go now.
  [[nodiscard]] std::optional<CellRect> preview() const;
  /// Whether what is being drawn is an obstacle.
  [[nodiscard]] bool adds() const { return blocked_; }
  /// The cells that a brush covers around a cell.
  static CellRect brush(Cell cell, int side);

 private:
  enum class Action : std::uint8_t { none, brush, rectangle, surprise, start, goal, pin };

  void press(const Session& session, const Run& run, const ViewState& state, const Pointer& pointer);
  void move(const Run& run, const ViewState& state, const Pointer& pointer, std::vector<Command>& commands);
  void release(const Run& run, ViewState& state, std::vector<Command>& commands);
  void dab(const Run& run, Cell cell, int side, std::vector<CellChange>& changes);
  [[nodiscard]] std::vector<CellChange> filled(const Run& run) const;
  [[nodiscard]] bool protects(const Run& run, Cell cell) const;

  Action action_ = Action::none;
  bool right_ = false;    // held by the right button
  bool blocked_ = false;  // paints rather than erases
  bool moved_ = false;
  Cell first_, last_;
  std::uint64_t stroke_ = 0;
  std::unordered_set<std::uint32_t> done_;  // nodes of this stroke
};

}  // namespace replan::ui
