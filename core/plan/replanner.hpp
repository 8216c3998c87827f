// Planning and replanning on a grid of one's own, for programs that want paths and nothing else.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"
#include "core/lattice/box.hpp"
#include "core/plan/planner.hpp"

namespace replan {

class Navigator;

/// A grid, a planner on it and the plan that stands. Any registered planner, in the plane or in space; CONTRIBUTING.md
/// has an example.
class Replanner {
 public:
  /// A setting by its key, its value as on the command line: {"heuristic", "euclidean"}.
  using Setting = std::pair<std::string, std::string>;
  struct Change {
    Cell cell;
    bool blocked;
  };

  /// The grid's cells are row-major, nonzero = obstacle; a box of one layer is a plane. `replan list planners`
  /// shows the planners and their settings. A robot with a radius, in cells, keeps its centre at least so far away
  /// from the square of every obstacle cell.
  static Result<Replanner> make(Box box, std::vector<std::uint8_t> cells,
                                std::string_view planner = "dstar-lite",
                                const std::vector<Setting>& settings = {}, double radius = 0);

  ~Replanner();
  Replanner(Replanner&&) noexcept;
  Replanner& operator=(Replanner&&) noexcept;

  /// Plans afresh. That no path was found is a status and no error; a cell outside the grid is an error, and leaves
  /// everything as it is, here and below.
  Result<PlanStatus> plan(Cell start, Cell goal);
  /// Cells have changed, and the robot stands at `start` now, or where it stood: repairs the plan, if one was asked
  /// for. Of several changes of a cell the last one holds.
  Result<PlanStatus> change(const std::vector<Change>& changes, Cell start);
  Result<PlanStatus> change(const std::vector<Change>& changes);

  /// `searching` until plan() is called; `status_sentence()` says it in words.
  [[nodiscard]] PlanStatus status() const;
  /// From start to goal, both included; neighbours, or cells that see each other if the planner leaves the grid's
  /// directions. Where its points need not be centres of cells, the cells that they lie in, and beside an obstacle's corner a
  /// free one. Empty if there is none.
  [[nodiscard]] std::vector<Cell> path() const;
  /// The same as points: cell (x, y) covers x..x+1, y..y+1, and its centre is (x + 0.5, y + 0.5).
  [[nodiscard]] std::vector<Point> points() const;
  /// In cells, penalties included; infinite without a path.
  [[nodiscard]] double cost() const;
  [[nodiscard]] bool blocked(Cell cell) const;  ///< by an obstacle; outside the grid all is

 private:
  explicit Replanner(std::unique_ptr<Navigator> navigator);

  std::unique_ptr<Navigator> navigator_;  // never null, but for one that was moved away
  std::optional<Cell> start_;             // of the plan, if one was asked for
};

}  // namespace replan
