// The path of a Field D* search: across open squares from point to point on their sides, where g is taken as linear
// between the two ends (core/lattice/interpolation.hpp).
//
// Settled here:
//  * From each point the way goes to that point of a square's sides, or that corner, which promises the least: the way
//    there and what is left from there. What is left from a point inside a side is not read off the side but looked up by
//    one more such step: where two ways round an obstacle meet, a point between two cells is
//    nearer to the goal by interpolation than by either way.
//  * Only settled vertices are trusted, and each step leads to ends of lower g: from a side to another whose larger g is
//    smaller or to a corner whose g is not larger, from a corner to what has smaller g alone. So no path goes in circles.
//  * The promise is not always kept. A path along moves is read out besides, and taken where it is shorter.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/lattice/interpolation.hpp"
#include "core/plan/path.hpp"

namespace replan {

/// No path is longer than so many times its interpolated cost, but for rounding: 1 / cos(pi / 8), rounded up. See
/// InterpolatedPath::along_moves().
inline constexpr double kMostOverInterpolated = 1.0823922003;

/// `Search` has start_, goal_, lattice_, the records nodes_ with g, parent and side, and settled(n).
template <class Search>
class InterpolatedPath {
 public:
  explicit InterpolatedPath(const Search& search) : search_(search) {}

  /// From the start on; there must be a path.
  [[nodiscard]] Path read() const {
    Line across = across_squares(), along = along_moves();
    return Path(across.length <= along.length ? std::move(across.points) : std::move(along.points));
  }

 private:
  static constexpr double kEnd = 1e-9;  // cells; a point nearer to a corner than that is the corner

  /// A vertex (both nodes are the same), or a point between two straight neighbours.
  struct Spot {
    NodeId a, b;
    double share = 0;  ///< of the way from a to b
    Point at;

    [[nodiscard]] bool vertex() const { return a == b; }
  };
  /// A polyline; steps that go straight on are one.
  struct Line {
    std::vector<Point> points;
    double length = 0;
    Point step{};

    void go_to(const Point& next) {
      if (!points.empty()) {
        const Point last = points.back(), by{next.x - last.x, next.y - last.y, 0};
        length += distance(last, next);
        if (by == step) points.pop_back();
        step = by;
      }
      points.push_back(next);
    }
  };

  /// Every way across a square is replaced by the move to one of its far side's ends. A way that bends by the angle a from
  /// the straight neighbour's direction lowers g by cos a over a move of length 1, or by sin a + cos a over one of length
  /// sqrt 2: one of the two is at most 1 / cos(pi / 8) times as long, the first up to a = pi / 8.
  [[nodiscard]] Line along_moves() const {
    constexpr std::int64_t kHalfWay = 410903206;  // 2^30 sin(pi / 8)
    Line line;
    for (NodeId s = search_.start_;;) {
      line.go_to(centre(s));
      if (s == search_.goal_) return line;
      const auto& node = search_.nodes_[s];
      const NodeId straight = neighbour(s, node.parent);
      const bool moves = node.side == WayOn::kNone;
      const NodeId diagonal = moves ? straight : neighbour(s, node.side);
      s = g(straight).raw - g(diagonal).raw <= kHalfWay ? straight : diagonal;
    }
  }

  [[nodiscard]] Line across_squares() const {
    Line line;
    for (Spot spot = vertex(search_.start_);; spot = next(spot)) {
      line.go_to(spot.at);
      if (spot.a == search_.goal_ && spot.vertex()) return line;
    }
  }

  [[nodiscard]] Spot next(const Spot& from) const {
    Spot best = from;
    double least = HUGE_VAL;
    each_step(from, [&](const Spot& to) {
      const double sum = distance(from.at, to.at) + left_from(to);
      if (!(sum < least)) return;
      least = sum;
      best = to;
    });
    return best;
  }
  /// What is left of the way from a spot, by looking one step ahead.
  [[nodiscard]] double left_from(const Spot& spot) const {
    if (spot.vertex()) return promised(spot);
    double least = HUGE_VAL;
    each_step(spot,
              [&](const Spot& to) { least = std::min(least, distance(spot.at, to.at) + promised(to)); });
    return least;
  }
  [[nodiscard]] double promised(const Spot& spot) const {
    const double from = g(spot.a).to_double();
    return spot.vertex() ? from : from + spot.share * (g(spot.b).to_double() - from);
  }

  /// Calls visit(spot) for each spot that a way may go on to from there: the best one inside each side of an open square,
  /// the squares' corners and where moves lead.
  template <class Visit>
  void each_step(const Spot& from, Visit&& visit) const {
    const Cost least = std::max(g(from.a), g(from.b));
    const auto corner = [&](NodeId n) {
      if (leads_down(g(n), least, !from.vertex()) && search_.settled(n)) visit(vertex(n));
    };
    each_open_square(from, [&](const std::array<NodeId, 4>& square) {
      for (const auto& [i, k] : {std::pair{0, 1}, {2, 3}, {0, 2}, {1, 3}}) {
        const NodeId u = square[static_cast<std::size_t>(i)], w = square[static_cast<std::size_t>(k)];
        if (!leads_down(std::max(g(u), g(w)), least, false)) continue;
        const double share = best_share(from, u, w);
        const bool is_inside = share > kEnd && share < 1 - kEnd;
        if (is_inside && search_.settled(u) && search_.settled(w)) visit(inside(u, w, share));
      }
      if (!from.vertex())
        for (const NodeId n : square) corner(n);
    });
    if (from.vertex())
      for (std::uint32_t rest = search_.lattice_.moves(from.a); rest != 0; rest &= rest - 1)
        corner(search_.lattice_.neighbour(from.a, std::countr_zero(rest)));
  }

  /// By the larger g of both ends; from a side to a corner it may stay the same. So a side that the spot lies on never
  /// follows it.
  static bool leads_down(Cost to, Cost from, bool side_to_corner) {
    return to < from || (side_to_corner && to == from);
  }

  /// The squares that a spot is a corner of, or lies on a side of, as far as they are open; by rows.
  template <class Visit>
  void each_open_square(const Spot& spot, Visit&& visit) const {
    const Cell a = search_.lattice_.position(spot.a), b = search_.lattice_.position(spot.b);
    for (int y = b.y - 1; y <= a.y; ++y)
      for (int x = b.x - 1; x <= a.x; ++x) {
        const std::array<Cell, 4> cells = {Cell{x, y}, {x + 1, y}, {x, y + 1}, {x + 1, y + 1}};
        std::array<NodeId, 4> square{};
        bool open = true;
        for (std::size_t i = 0; i < 4 && open; ++i) {
          open = search_.lattice_.contains(cells[i]);
          if (open) square[i] = search_.lattice_.node(cells[i]);
          if (open) open = !search_.lattice_.blocked(square[i]);
        }
        if (open) visit(square);
      }
  }

  /// The share of the way from u to w at which a side is crossed best: where sqrt(d^2 + (t - foot)^2) + t (g(w) - g(u)) is
  /// least. Not between 0 and 1 where that is one of its ends.
  [[nodiscard]] double best_share(const Spot& from, NodeId u, NodeId w) const {
    const double slope = g(w).to_double() - g(u).to_double();
    if (!(std::abs(slope) < 1)) return -1;
    const Point q = centre(u);
    const bool level = w == u + 1;
    const double away = std::abs(level ? from.at.y - q.y : from.at.x - q.x),
                 foot = level ? from.at.x - q.x : from.at.y - q.y;
    return foot - away * slope / std::sqrt(1 - slope * slope);
  }

  [[nodiscard]] Point centre(NodeId n) const { return centre_of(search_.lattice_.position(n)); }
  [[nodiscard]] Spot vertex(NodeId n) const { return {n, n, 0, centre(n)}; }
  [[nodiscard]] Spot inside(NodeId a, NodeId b, double share) const {
    Spot spot{a, b, share, centre(a)};
    (b == a + 1 ? spot.at.x : spot.at.y) += share;
    return spot;
  }
  [[nodiscard]] Cost g(NodeId n) const { return search_.nodes_[n].g; }
  [[nodiscard]] NodeId neighbour(NodeId s, std::uint32_t d) const {
    return search_.lattice_.neighbour(s, static_cast<int>(d));
  }

  const Search& search_;
};

}  // namespace replan
