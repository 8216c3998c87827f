// Obstacles that move: where each is, and when it takes its next step.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/world/scenario.hpp"

namespace replan {

/// Simulated time in microseconds since the first plan stood. Whole numbers, so that every machine agrees.
using SimTime = std::int64_t;
inline constexpr SimTime kSecond = 1'000'000;

/// How far a moving obstacle has come.
struct MoverState {
  std::int64_t steps = -1;  ///< taken along its way; -1: it has not appeared yet
  SimTime due = 0;          ///< when it takes the next
  friend bool operator==(const MoverState&, const MoverState&) = default;
};

/// The way of a moving obstacle, cell by cell.
class Mover {
 public:
  explicit Mover(const MovingObstacle& setup);

  /// Its first cell, the upper left one of its lowest layer, after that many steps.
  [[nodiscard]] Cell at(std::int64_t steps) const;
  /// Whether it ever takes another step.
  [[nodiscard]] bool goes_on(std::int64_t steps) const;
  /// How many of the `most` steps after the first `steps` it takes before one would bring it onto a cell of
  /// `keep_clear` that it does not cover already. Looks at one round of its way at most, and only where it is
  /// near such a cell.
  [[nodiscard]] std::int64_t open_steps(std::int64_t steps, std::int64_t most,
                                        std::span<const Cell> keep_clear) const;
  /// How many steps are left to it: without an end, as many as there are numbers.
  [[nodiscard]] std::int64_t steps_left(std::int64_t steps) const;
  /// Seconds between two steps, as simulated time; at least one unit.
  [[nodiscard]] SimTime pace() const { return pace_; }
  /// The step of the robot at which it appears.
  [[nodiscard]] std::int64_t from() const { return from_; }
  [[nodiscard]] bool covers(Cell corner, Cell cell) const {
    return cell.x >= corner.x && cell.y >= corner.y && cell.z >= corner.z && cell.x < corner.x + width_ &&
           cell.y < corner.y + height_ && cell.z < corner.z + depth_;
  }
  /// The cells of the world that it covers with its first cell at `corner`, row by row.
  template <class Visit>
  void each_cell(Cell corner, const Box& world, const Visit& visit) const {
    for (int z = std::max(0, corner.z); z < std::min(world.depth(), corner.z + depth_); ++z)
      for (int y = std::max(0, corner.y); y < std::min(world.height(), corner.y + height_); ++y)
        for (int x = std::max(0, corner.x); x < std::min(world.width(), corner.x + width_); ++x)
          visit(Cell{x, y, z});
  }

 private:
  [[nodiscard]] std::int64_t round() const;
  [[nodiscard]] int gap(Cell corner, Cell cell) const;

  std::vector<Cell> cells_;  // of one run over the way; with WayEnd::loop also the way home
  int width_, height_, depth_;
  WayEnd at_end_;
  SimTime pace_;
  std::int64_t from_;
};

/// All moving obstacles of a scenario.
class Crowd {
 public:
  /// One more (+1) or one less (-1) obstacle covers the cell.
  struct Change {
    Cell cell;
    int by;
  };

  explicit Crowd(const Scenario& scenario);

  [[nodiscard]] bool empty() const { return movers_.empty(); }
  [[nodiscard]] const Mover& operator[](std::size_t index) const { return movers_[index]; }
  /// Before the run: those that are there from the start stand at the beginning of their ways.
  [[nodiscard]] std::vector<MoverState> initial() const;
  /// Lets those move that are due by `time`, in the order of the time at which they first are and then of the
  /// list, and those appear whose turn has come by the robot's `clock`. None comes onto a cell of
  /// `keep_clear`: it waits there and tries again after its usual pace. However many steps one of them takes,
  /// only its places before and after are told: nobody looks in between. So the changes are at most twice its
  /// cells.
  std::vector<Change> advance(std::vector<MoverState>& states, SimTime time, std::int64_t clock,
                              std::span<const Cell> keep_clear) const;

 private:
  void appear(std::size_t index, std::vector<MoverState>& states, SimTime time,
              std::span<const Cell> keep_clear, std::vector<Change>& changes) const;
  void move(std::size_t index, std::vector<MoverState>& states, SimTime time,
            std::span<const Cell> keep_clear, std::vector<Change>& changes) const;

  std::vector<Mover> movers_;
  Box world_;
};

/// A way of straight lines through the corners, cell by cell (Bresenham), each cell next to the one before.
std::vector<Cell> cells_of_way(const std::vector<Cell>& corners);

/// The world before a run: bit 0 of each cell is a wall of the map, the rest counts the moving obstacles that
/// cover it.
SharedBytes initial_truth(const Scenario& scenario, bool all_mapped = false);
inline constexpr std::uint8_t kWallBit = 1;    ///< of a cell of the true world
inline constexpr std::uint8_t kMoverUnit = 2;  ///< what a moving obstacle adds to the cells that it covers

}  // namespace replan
