// Ways across the squares between four cells' centres, for searches whose paths leave the centres.
//
//  Ferguson & Stentz, "Using Interpolation to Improve Path Planning: The Field D* Algorithm", Journal of Field Robotics
//  23(2), 2006, doi 10.1002/rob.20109
//
// There vertices are corners of cells and a cell has a cost of traversal; here, where start and goal are centres of cells
// that are free or not, vertices are centres, and what a way crosses is the square between four of them: open if all
// four cells are free, closed else. A straight way inside an open square touches no other cell, so that it is free
// under every corner rule, and for a robot with a size besides (box_lattice.hpp). Along a side of a square two cells are
// enough, and its diagonal is a move of the lattice, so that whatever the lattice joins is joined here.
//
// The way to the far side of an open square, from the straight neighbour s1 to the diagonal one s2, is
//   sqrt(1 + y^2) + (1 - y) g(s1) + y g(s2),  least at y = f / sqrt(1 - f^2) with f = g(s1) - g(s2):  g(s1) + sqrt(1 - f^2)
// as long as 0 < y < 1, that is 0 < f < 1 / sqrt 2. In whole numbers, the root rounded up. So it is more than both g, and
// never less if one of them grows: a strictly weakly superior function (Ramalingam & Reps 1996, doi
// 10.1006/jagm.1996.0046), which is what a search with a lookahead needs to be exact.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "core/lattice/box_lattice.hpp"

namespace replan {

/// A side of a square that a cell is a corner of, on the other side of it: the directions to its two ends.
struct FarSide {
  int straight = 0, diagonal = 0;
  std::uint32_t moves = 0;  ///< of the cell, that show the square to be open
};

/// All eight, by their ends.
inline constexpr auto kFarSides = [] {
  using Dirs = Directions<2>;
  std::array<FarSide, 8> sides{};
  std::size_t next = 0;
  for (int straight = 0; straight < Dirs::kCount; ++straight)
    for (int diagonal = 0; diagonal < Dirs::kCount; ++diagonal) {
      const std::uint32_t beside = Dirs::squeezed(diagonal);
      if ((beside >> straight & 1u) != 0) sides[next++] = {straight, diagonal, beside | 1u << diagonal};
    }
  return sides;
}();

/// The two of them that the neighbour in each direction is an end of.
inline constexpr auto kSidesBeside = [] {
  std::array<std::array<FarSide, 2>, 8> beside{};
  for (int d = 0; d < 8; ++d) {
    std::size_t next = 0;
    for (const FarSide& side : kFarSides)
      if (side.straight == d || side.diagonal == d) beside[static_cast<std::size_t>(d)][next++] = side;
  }
  return beside;
}();

/// floor(2^30 / sqrt 2): f beyond which the way across a square leads into its corner.
inline constexpr std::int64_t kSteepest = 759250124;

/// The least n with n^2 >= `square`, which is at most 2^60.
inline std::int64_t root_up(std::int64_t square) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square)));
  while (root * root < square) ++root;
  while ((root - 1) * (root - 1) >= square) --root;
  return root;
}

/// What the way across an open square to a point between the ends of a far side comes to, of their g; infinite where it
/// is best to go to one of the ends.
inline Cost across(Cost straight, Cost diagonal) {
  const std::int64_t f = straight.raw - diagonal.raw;
  if (f <= 0 || f > kSteepest) return Cost::infinity();
  return {straight.raw + root_up(Cost::kScale * Cost::kScale - f * f)};
}

/// Where the way across meets the far side: its distance from the straight neighbour.
inline double crossing(Cost straight, Cost diagonal) {
  const Cost f{straight.raw - diagonal.raw};
  return f.to_double() / std::sqrt(1 - f.to_double() * f.to_double());
}

/// A way on from a cell: a move, or across a square to a far side.
struct WayOn {
  static constexpr std::uint32_t kNone = 31;

  Cost cost = Cost::infinity();  ///< to the goal
  std::uint32_t to = kNone;      ///< the direction of the move, or to the far side's straight end
  std::uint32_t and_to = kNone;  ///< the direction to the diagonal end; none of a move

  /// Of equal ones the first: by the first direction, a move before ways across, then by the second direction.
  friend constexpr bool operator<(const WayOn& a, const WayOn& b) {
    return std::tuple(a.cost, a.to, (a.and_to + 1) & kNone) <
           std::tuple(b.cost, b.to, (b.and_to + 1) & kNone);
  }
};

/// Calls visit(way) for the ways across open squares to those of the sides, from a cell of those moves; g(direction) is
/// that of a neighbour. Ways that cost more than `most`, which may fall meanwhile, are left out without taking a root.
template <class Sides, class G, class Visit>
void each_way_across(const Sides& sides, std::uint32_t moves, G&& g, const Cost& most, Visit&& visit) {
  for (const FarSide& side : sides) {
    if ((moves & side.moves) != side.moves) continue;
    const Cost straight = g(side.straight), diagonal = g(side.diagonal);
    if (straight.raw + kSteepest >= most.raw) continue;
    visit(WayOn{across(straight, diagonal), static_cast<std::uint32_t>(side.straight),
                static_cast<std::uint32_t>(side.diagonal)});
  }
}

/// The move in direction d.
template <class G>
WayOn move_on(int d, G&& g) {
  return {Grid2::step_cost(d) + g(d), static_cast<std::uint32_t>(d), WayOn::kNone};
}

/// The better of a known way on, and those to the neighbour in direction d or beside it, from a cell of those moves.
template <class G>
WayOn better_way_over(int d, std::uint32_t moves, G&& g, WayOn best) {
  const auto take = [&best](const WayOn& way) {
    if (way < best) best = way;
  };
  take(move_on(d, g));
  each_way_across(kSidesBeside[static_cast<std::size_t>(d)], moves, g, best.cost, take);
  return best;
}

/// The best of all ways on from a cell of those moves; none if each costs infinity.
template <class G>
WayOn best_way_on(std::uint32_t moves, G&& g) {
  WayOn best;
  const auto take = [&best](const WayOn& way) {
    if (way.cost < Cost::infinity() && way < best) best = way;
  };
  for (std::uint32_t rest = moves; rest != 0; rest &= rest - 1) take(move_on(std::countr_zero(rest), g));
  each_way_across(kFarSides, moves, g, best.cost, take);
  return best;
}

/// So many times a lattice's lower bound the cost of a way across squares is at least: 1 / sqrt 2, rounded down. No more, to
/// be consistent: g falls by as little as that from a cell to the straight neighbour that its way across is made of.
inline constexpr Cost kInterpolatedShare{kSteepest};

/// A lower bound of such costs between two cells, rounded down; consistent over their ways on.
inline Cost interpolated_bound(Cost bound) {
  __extension__ using Wide = __int128;
  return {static_cast<std::int64_t>(static_cast<Wide>(bound.raw) * kInterpolatedShare.raw >> 30)};
}
/// The same rounded up, of a bound rounded up (law 6 in lattice.hpp).
inline Cost interpolated_bound_up(Cost bound) {
  __extension__ using Wide = __int128;
  const Wide product = static_cast<Wide>(bound.raw) * kInterpolatedShare.raw;
  return {static_cast<std::int64_t>((product + (Cost::kScale - 1)) >> 30)};
}

}  // namespace replan
