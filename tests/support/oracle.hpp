// Brute force: what the engine computes, computed again by the plainest means and without a line of its code.
// Only the names of settings (enums) are shared. Slow and obviously right is the aim.
//
// A 2D world is a 3D one of depth 1 in which nothing moves along z.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/field/clearance.hpp"
#include "core/lattice/lattice.hpp"

namespace replan::oracle {

/// Costs as plain numbers in units of 2^-30 cells.
using Raw = std::int64_t;
inline constexpr Raw kUnit = Raw{1} << 30;
inline constexpr Raw kNever = Raw{1} << 61;  ///< as Cost::infinity()

/// x, y, z; z is 0 in 2D.
using Place = std::array<int, 3>;

/// A box of cells; outside is obstacle.
struct World {
  int dimensions = 2;
  Place size{1, 1, 1};
  std::vector<std::uint8_t> blocked;

  [[nodiscard]] bool inside(const Place& p) const;
  [[nodiscard]] bool bad(const Place& p) const { return !inside(p) || blocked[index(p)] != 0; }
  [[nodiscard]] std::size_t index(const Place& p) const;
  [[nodiscard]] Place place(std::size_t index) const;
};

/// floor(2^30 sqrt(n)) by bisection.
Raw root_floor(std::int64_t n);
/// The cost of a step along `axes` axes: 2^30 sqrt(axes), rounded up.
Raw step(int axes);

/// True if a robot may go from p by `by` (each part -1, 0 or 1): all cells of the box spanned are looked at.
bool may_move(const World& world, MoveRules rules, const Place& p, const Place& by);
/// Indices of the cells that may_move() leads to, ascending.
std::vector<std::size_t> neighbours(const World& world, MoveRules rules, std::size_t from);
/// The cost of the step between two neighbours.
Raw step_between(const World& world, std::size_t a, std::size_t b);

/// Distance from each cell to the nearest obstacle by the paper's two passes with weights 1, sqrt 2 (and sqrt
/// 3 in 3D), as printed; kNever if there is no obstacle. `border`: the ring of cells just outside counts.
std::vector<Raw> two_pass_chamfer(const World& world, bool border);
/// Distance to the nearest obstacle by looking at all of them.
std::vector<Raw> exact_euclidean(const World& world, bool border);
/// dist(s) of the DLD* Lite paper, definitions 1-3, or j(X) of the AUV paper; kNever where a cell is impassable.
std::vector<Raw> penalties(const World& world, const ClearanceRules& rules);

/// Cost from every cell to the goal by Dijkstra's algorithm: steps plus the penalty of each cell stepped
/// into. kNever where nothing leads. `penalty` may be empty.
std::vector<Raw> costs_to(const World& world, MoveRules rules, const std::vector<Raw>& penalty,
                          std::size_t goal);

/// The least n with n^2 >= `square`, by bisection.
Raw root_ceiling(std::int64_t square);
/// What the way from p across the square towards `by` (both parts -1 or 1) comes to that meets its far side between the
/// neighbour along an axis (0: x) and the one across the corner, of their costs: kNever if one of the four cells is bad,
/// or if an end of the side is better. The plane alone.
Raw way_across(const World& world, const std::vector<Raw>& costs, const Place& p, const Place& by, int axis);
/// Cost from every cell to the goal by moves and ways across squares, which is interpolated: by working it out anew for
/// all cells until nothing changes.
std::vector<Raw> interpolated_costs_to(const World& world, MoveRules rules, std::size_t goal);
/// Whether the open part of the segment between two points of the plane enters a bad cell, by a billionth of a cell.
bool enters_bad(const World& world, double ax, double ay, double bx, double by);
/// The same in space.
bool enters_bad(const World& world, const std::array<double, 3>& a, const std::array<double, 3>& b);
/// The least distance of that segment to the square of a bad cell, those outside included.
double least_distance(const World& world, double ax, double ay, double bx, double by);

/// The estimates of Heuristic, rounded down.
Raw estimate(const World& world, MoveRules rules, Heuristic heuristic, std::size_t a, std::size_t b);

/// True if a and b see each other where `bad` marks the bad cells. Supercover: each cell of the bounding box
/// is intersected with the segment in whole numbers; cells that are only touched fall under the corner rule,
/// together with the others touched at the same point. Bresenham: the k-th cell by rounding, not by running
/// errors.
bool sees(const World& world, const std::vector<std::uint8_t>& bad, CornerRule corners, SightRule rule,
          std::size_t a, std::size_t b);
/// Four times the squared distance from the centre of a to the square of b.
std::int64_t quarters(const World& world, std::size_t a, std::size_t b);
/// True if that square is nearer than the radius. The square of a double is worked out in whole numbers.
bool nearer(std::int64_t quarters, double radius);
/// The cells that are obstacles or nearer to one than the radius, by looking at all of them; 1 for each.
std::vector<std::uint8_t> grown(const World& world, double radius);
/// The least quarters() of a cell to an obstacle; INT64_MAX without one.
std::int64_t least_quarters(const World& world, std::size_t cell);
/// True if a and b see each other for a robot with a size: all points of the segment between two integer places are
/// taken, and no cell is bad that is less than one away from such a point along each axis.
bool sees_wide(const World& world, const std::vector<std::uint8_t>& bad, std::size_t a, std::size_t b);
/// The cells that the segment between two centres passes through (not those that it only touches), ascending.
std::vector<std::size_t> crossed_cells(const World& world, std::size_t a, std::size_t b);

}  // namespace replan::oracle
