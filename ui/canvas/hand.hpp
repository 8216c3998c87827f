// The hand on the canvas: turns presses and drags into commands.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

#include "core/world/brush.hpp"
#include "ui/canvas/canvas.hpp"

namespace replan::ui {

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
  /// Start, goal, robot or the corner of a way are held.
  [[nodiscard]] bool holds() const {
    return action_ == Action::start || action_ == Action::goal || action_ == Action::robot ||
           action_ == Action::corner;
  }
  /// Whether a press at this cell would take hold of the start, the goal or the robot.
  [[nodiscard]] static bool could_hold(const Run& run, const Pointer& pointer);
  /// The cells that would be written if the button were let go now, or pressed at `hovered`; empty if the
  /// tool writes none.
  [[nodiscard]] std::vector<CellSpan> preview(const ViewState& state, std::optional<Cell> hovered) const;
  /// Whether what is being drawn is an obstacle.
  [[nodiscard]] bool adds() const { return adds_; }

 private:
  enum class Action : std::uint8_t {
    none,
    brush,
    rectangle,
    line,
    surprise,
    start,
    goal,
    robot,
    region,
    measure,
    corner,
    idle,  ///< what the press was for is done
  };

  void press(const Session& session, const Run& run, ViewState& state, const Pointer& pointer,
             std::vector<Command>& commands);
  void press_tool(const Session& session, const Run& run, ViewState& state, const Pointer& pointer,
                  std::vector<Command>& commands);
  void press_way(const Session& session, ViewState& state, const Pointer& pointer,
                 std::vector<Command>& commands);
  void move(const Session& session, const Run& run, ViewState& state, const Pointer& pointer,
            std::vector<Command>& commands);
  void move_held(const Session& session, const Run& run, const ViewState& state, Cell to,
                 std::vector<Command>& commands);
  void release(const Session& session, const Run& run, ViewState& state, std::vector<Command>& commands);
  void release_region(const Run& run, ViewState& state) const;
  void drop_surprise(const Session& session, const Run& run, ViewState& state,
                     std::vector<Command>& commands);
  void write(const Run& run, const std::vector<CellSpan>& spans, std::vector<CellChange>& changes);
  [[nodiscard]] static std::optional<Action> grabbed(const Run& run, const Pointer& pointer);

  Action action_ = Action::none;
  bool right_ = false;  // held by the right button
  bool adds_ = false;   // paints rather than erases
  bool moved_ = false;
  Cell first_, last_;
  std::size_t corner_ = 0;  // of the selected moving obstacle's way
  std::uint64_t stroke_ = 0;
  std::unordered_set<std::uint32_t> done_;  // nodes of this stroke
};

/// Selects cells, and nothing else.
void select_region(Editing& editing, const CellRect& region);
/// Ends the way that is being drawn: it becomes a moving obstacle, which is selected. Nothing if there is
/// none.
void finish_way(const Session& session, ViewState& state, std::vector<Command>& commands);
/// The corner of the box's upper left cell for a box of this side with its middle at a cell, on the map.
Cell box_corner(Cell middle, int side, const GridMap& map);
/// The scheduled surprise that has a cell there and has not happened yet at the cursor, the latest first.
std::optional<std::size_t> surprise_at(const Run& run, Cell cell);

}  // namespace replan::ui
