#include "tests/support/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

namespace replan::oracle {
namespace {

constexpr std::array<std::size_t, 3> kAxes{0, 1, 2};

int tolerated(CornerRule corners) {
  switch (corners) {
    case CornerRule::none:
      return 0;
    case CornerRule::one:
      return 1;
    case CornerRule::any:
      break;
  }
  return 1000;
}

/// All offsets with parts -1, 0, 1 but for standing still; in 2D those with no part along z.
std::vector<Place> offsets(int dimensions) {
  std::vector<Place> result;
  const int deep = dimensions == 3 ? 1 : 0;
  for (int dz = -deep; dz <= deep; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (dx != 0 || dy != 0 || dz != 0) result.push_back({dx, dy, dz});
  return result;
}

int axes_of(const Place& by) {
  return std::abs(by[0]) + std::abs(by[1]) + std::abs(by[2]);
}

Place moved(const Place& p, const Place& by) {
  return {p[0] + by[0], p[1] + by[1], p[2] + by[2]};
}

}  // namespace

bool World::inside(const Place& p) const {
  return p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] < size[0] && p[1] < size[1] && p[2] < size[2];
}

std::size_t World::index(const Place& p) const {
  return static_cast<std::size_t>(p[0] + size[0] * (p[1] + size[1] * p[2]));
}

Place World::place(std::size_t index) const {
  const int i = static_cast<int>(index);
  return {i % size[0], i / size[0] % size[1], i / (size[0] * size[1])};
}

Raw root_floor(std::int64_t n) {
  __extension__ using Wide = unsigned __int128;
  const Wide target = static_cast<Wide>(n) << 60;
  Raw low = 0, high = Raw{1} << 56;
  while (high - low > 1) {
    const Raw middle = low + (high - low) / 2;
    (static_cast<Wide>(middle) * static_cast<Wide>(middle) <= target ? low : high) = middle;
  }
  return low;
}

Raw step(int axes) {
  static const std::array<Raw, 4> costs = {0, kUnit, root_floor(2) + 1, root_floor(3) + 1};
  return costs[static_cast<std::size_t>(axes)];
}

bool may_move(const World& world, MoveRules rules, const Place& p, const Place& by) {
  if (!rules.diagonals && axes_of(by) > 1) return false;
  if (world.bad(p) || world.bad(moved(p, by))) return false;
  int beside = 0;
  for (int z = 0; z <= std::abs(by[2]); ++z)
    for (int y = 0; y <= std::abs(by[1]); ++y)
      for (int x = 0; x <= std::abs(by[0]); ++x)
        beside += world.bad({p[0] + x * by[0], p[1] + y * by[1], p[2] + z * by[2]}) ? 1 : 0;
  return beside <= tolerated(rules.corners);  // the two ends are free: what is counted stands between them
}

std::vector<std::size_t> neighbours(const World& world, MoveRules rules, std::size_t from) {
  std::vector<std::size_t> result;
  const Place p = world.place(from);
  for (const Place& by : offsets(world.dimensions))
    if (may_move(world, rules, p, by)) result.push_back(world.index(moved(p, by)));
  std::sort(result.begin(), result.end());
  return result;
}

Raw step_between(const World& world, std::size_t a, std::size_t b) {
  const Place p = world.place(a), q = world.place(b);
  return step(axes_of({p[0] - q[0], p[1] - q[1], p[2] - q[2]}));
}

namespace {

/// A world with a ring of one cell around it, blocked or free, for the border switch.
World with_ring(const World& world, bool blocked) {
  const int deep = world.dimensions == 3 ? 1 : 0;
  World ring{world.dimensions, {world.size[0] + 2, world.size[1] + 2, world.size[2] + 2 * deep}, {}};
  ring.blocked.assign(static_cast<std::size_t>(ring.size[0] * ring.size[1] * ring.size[2]), blocked ? 1 : 0);
  for (std::size_t i = 0; i < world.blocked.size(); ++i) {
    const Place p = world.place(i);
    ring.blocked[ring.index({p[0] + 1, p[1] + 1, p[2] + deep})] = world.blocked[i];
  }
  return ring;
}

std::vector<Raw> without_ring(const World& world, const World& ring, const std::vector<Raw>& values) {
  const int deep = world.dimensions == 3 ? 1 : 0;
  std::vector<Raw> result(world.blocked.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Place p = world.place(i);
    result[i] = values[ring.index({p[0] + 1, p[1] + 1, p[2] + deep})];
  }
  return result;
}

std::vector<Raw> chamfer_passes(const World& world) {
  std::vector<Raw> distance(world.blocked.size());
  for (std::size_t i = 0; i < distance.size(); ++i) distance[i] = world.blocked[i] != 0 ? 0 : kNever;
  const std::vector<Place> all =
      offsets(world.dimensions);  // in raster order: the first half lies before the cell
  const auto look = [&](std::size_t i, const Place& by) {
    const Place there = moved(world.place(i), by);
    if (world.inside(there))
      distance[i] = std::min(distance[i], distance[world.index(there)] + step(axes_of(by)));
  };
  for (std::size_t i = 0; i < distance.size(); ++i)
    for (std::size_t k = 0; k < all.size() / 2; ++k) look(i, all[k]);
  for (std::size_t i = distance.size(); i-- > 0;)
    for (std::size_t k = all.size() / 2; k < all.size(); ++k) look(i, all[k]);
  for (Raw& value : distance) value = std::min(value, kNever);
  return distance;
}

std::vector<Raw> euclidean_search(const World& world) {
  std::vector<Place> obstacles;
  for (std::size_t i = 0; i < world.blocked.size(); ++i)
    if (world.blocked[i] != 0) obstacles.push_back(world.place(i));
  std::vector<Raw> distance(world.blocked.size(), kNever);
  for (std::size_t i = 0; i < distance.size() && !obstacles.empty(); ++i) {
    const Place p = world.place(i);
    std::int64_t least = kNever;
    for (const Place& q : obstacles) {
      const std::int64_t dx = p[0] - q[0], dy = p[1] - q[1], dz = p[2] - q[2];
      least = std::min(least, dx * dx + dy * dy + dz * dz);
    }
    distance[i] = root_floor(least);
  }
  return distance;
}

}  // namespace

std::vector<Raw> two_pass_chamfer(const World& world, bool border) {
  if (!border) return chamfer_passes(world);
  const World ring = with_ring(world, true);
  return without_ring(world, ring, chamfer_passes(ring));
}

std::vector<Raw> exact_euclidean(const World& world, bool border) {
  if (!border) return euclidean_search(world);
  const World ring = with_ring(world, true);
  return without_ring(world, ring, euclidean_search(ring));
}

/// j(X) of the AUV paper, within r_max, to the nearest unit.
static Raw threat_at(Raw distance, const ThreatCurve& curve) {
  const auto r_min = static_cast<Raw>(curve.r_min * static_cast<double>(kUnit) + 0.5);
  const long double beyond = static_cast<long double>(distance - r_min) / kUnit;
  if (beyond <= 0 && curve.impassable) return kNever;
  return std::llround(curve.c * std::exp(std::min(-beyond, 0.0L)) * kUnit);
}

std::vector<Raw> penalties(const World& world, const ClearanceRules& rules) {
  std::vector<Raw> result = rules.transform == Transform::chamfer
                                ? two_pass_chamfer(world, rules.border_is_obstacle)
                                : exact_euclidean(world, rules.border_is_obstacle);
  const Raw range = static_cast<Raw>(rules.range * static_cast<double>(kUnit) + 0.5);
  for (Raw& value : result)
    value = value > range ? 0 : rules.threat ? threat_at(value, *rules.threat) : range - value + kUnit;
  return result;
}

std::vector<Raw> costs_to(const World& world, MoveRules rules, const std::vector<Raw>& penalty,
                          std::size_t goal) {
  std::vector<Raw> cost(world.blocked.size(), kNever);
  if (world.blocked[goal] != 0) return cost;
  using Entry = std::pair<Raw, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const std::vector<Place> all = offsets(world.dimensions);
  cost[goal] = 0;
  open.push({0, goal});
  while (!open.empty()) {
    const auto [value, u] = open.top();
    open.pop();
    if (value > cost[u]) continue;
    const Place p = world.place(u);
    const Raw into_u = value + (penalty.empty() ? 0 : penalty[u]);
    for (const Place& by : all) {
      const Place there = moved(p, by);
      if (world.bad(there)) continue;
      const std::size_t s = world.index(there);
      const Raw sum = into_u + step(axes_of(by));
      if (sum >= cost[s] || !may_move(world, rules, p, by)) continue;
      cost[s] = sum;
      open.push({sum, s});
    }
  }
  return cost;
}

Raw root_ceiling(std::int64_t square) {
  Raw low = 0, high = Raw{1} << 31;  // low^2 < square <= high^2, or square is 0
  if (square == 0) return 0;
  while (high - low > 1) {
    const Raw middle = (low + high) / 2;
    (middle * middle < square ? low : high) = middle;
  }
  return high;
}

Raw way_across(const World& world, const std::vector<Raw>& costs, const Place& p, const Place& by, int axis) {
  const Place beside_x{p[0] + by[0], p[1], 0}, beside_y{p[0], p[1] + by[1], 0}, corner = moved(p, by);
  for (const Place& cell : {p, beside_x, beside_y, corner})
    if (world.bad(cell)) return kNever;
  const Raw straight = costs[world.index(axis == 0 ? beside_x : beside_y)],
            diagonal = costs[world.index(corner)];
  if (straight >= kNever || diagonal >= straight) return kNever;
  const Raw f = straight - diagonal;
  // Where it meets the side: f / sqrt(1 - f^2) of its length from the straight neighbour, less than all of it.
  if (f > 759'250'124) return kNever;
  return straight + root_ceiling(kUnit * kUnit - f * f);
}

std::vector<Raw> interpolated_costs_to(const World& world, MoveRules rules, std::size_t goal) {
  std::vector<Raw> cost(world.blocked.size(), kNever);
  if (world.blocked[goal] != 0) return cost;
  cost[goal] = 0;
  for (bool changes = true; changes;) {
    changes = false;
    for (std::size_t s = 0; s < cost.size(); ++s) {
      Raw best = s == goal ? 0 : kNever;
      const Place p = world.place(s);
      for (const std::size_t next : neighbours(world, rules, s))
        best = std::min(best, cost[next] + step_between(world, s, next));
      for (const int y : {-1, 1})
        for (const int x : {-1, 1})
          for (const int axis : {0, 1}) best = std::min(best, way_across(world, cost, p, {x, y, 0}, axis));
      changes |= best != cost[s];
      cost[s] = best;
    }
  }
  return cost;
}

bool enters_bad(const World& world, double ax, double ay, double bx, double by) {
  return enters_bad(world, {ax, ay, 0.5}, {bx, by, 0.5});
}

bool enters_bad(const World& world, const std::array<double, 3>& a, const std::array<double, 3>& b) {
  constexpr double kLeast = 1e-9;
  const auto inside_for_a_while = [&](const Place& cell) {
    // The part of the segment within each of the strips; they have a part in common if it enters the square (cube).
    double begin = 0, end = 1;
    for (const std::size_t axis : kAxes) {
      const double from = a[axis], to = b[axis], first = cell[axis] + kLeast, last = cell[axis] + 1 - kLeast;
      if (from == to) {
        if (from <= first || from >= last) return false;
        continue;
      }
      const double t = (first - from) / (to - from), u = (last - from) / (to - from);
      begin = std::max(begin, std::min(t, u));
      end = std::min(end, std::max(t, u));
    }
    return begin < end;
  };
  const int deep = world.dimensions == 3 ? 1 : 0;
  for (int z = -deep; z < world.size[2] + deep; ++z)
    for (int y = -1; y <= world.size[1]; ++y)
      for (int x = -1; x <= world.size[0]; ++x)
        if (world.bad({x, y, z}) && inside_for_a_while({x, y, z})) return true;
  return false;
}

double least_distance(const World& world, double ax, double ay, double bx, double by) {
  // Of two things without curves that do not meet, one is nearest with a corner or an end.
  const auto to_square = [](double x, double y, int low_x, int low_y) {
    const double dx = std::max({low_x - x, x - low_x - 1, 0.0}),
                 dy = std::max({low_y - y, y - low_y - 1, 0.0});
    return std::sqrt(dx * dx + dy * dy);
  };
  const auto to_segment = [&](double x, double y) {
    const double dx = bx - ax, dy = by - ay, squared = dx * dx + dy * dy;
    const double t = squared == 0 ? 0 : std::clamp(((x - ax) * dx + (y - ay) * dy) / squared, 0.0, 1.0);
    return std::sqrt((ax + t * dx - x) * (ax + t * dx - x) + (ay + t * dy - y) * (ay + t * dy - y));
  };
  if (enters_bad(world, ax, ay, bx, by)) return 0;
  double least = kNever;
  for (int y = -1; y <= world.size[1]; ++y)
    for (int x = -1; x <= world.size[0]; ++x) {
      if (!world.bad({x, y, 0})) continue;
      least = std::min({least, to_square(ax, ay, x, y), to_square(bx, by, x, y)});
      for (const int i : {0, 1})
        for (const int k : {0, 1}) least = std::min(least, to_segment(x + i, y + k));
    }
  return least;
}

Raw estimate(const World& world, MoveRules rules, Heuristic heuristic, std::size_t a, std::size_t b) {
  const Place p = world.place(a), q = world.place(b);
  std::array<std::int64_t, 3> d{};
  for (const std::size_t i : kAxes) d[i] = std::abs(p[i] - q[i]);
  const Raw manhattan = (d[0] + d[1] + d[2]) * kUnit;
  if (heuristic == Heuristic::zero) return 0;
  if (heuristic == Heuristic::manhattan) return manhattan;
  if (heuristic == Heuristic::chebyshev) return std::max({d[0], d[1], d[2]}) * kUnit;
  if (heuristic == Heuristic::euclidean) return root_floor(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  if (!rules.diagonals) return manhattan;
  Raw sum = 0;  // octile: as many axes at once as are left
  while (d[0] + d[1] + d[2] > 0) {
    int axes = 0;
    for (std::int64_t& part : d) axes += part > 0 ? 1 : 0;
    for (std::int64_t& part : d) part -= part > 0 ? 1 : 0;
    sum += step(axes);
  }
  return sum;
}

namespace {

/// The stretch of the segment a-b that lies in the closed cube of cell c, as times scaled by a common
/// denominator; first > second if there is none.
std::pair<std::int64_t, std::int64_t> stretch(const Place& a, const Place& b, const Place& c,
                                              std::int64_t whole) {
  std::int64_t first = 0, last = whole;
  for (const std::size_t i : kAxes) {
    // Centres at even places 2a, 2b; the cube spans 2c - 1 to 2c + 1.
    const std::int64_t length = 2 * (b[i] - a[i]);
    if (length == 0) {
      if (c[i] != a[i]) return {1, 0};
      continue;
    }
    const std::int64_t scale = whole / length;
    const std::int64_t t0 = (2 * c[i] - 1 - 2 * a[i]) * scale, t1 = (2 * c[i] + 1 - 2 * a[i]) * scale;
    first = std::max(first, std::min(t0, t1));
    last = std::min(last, std::max(t0, t1));
  }
  return {first, last};
}

std::int64_t denominator(const Place& a, const Place& b) {
  std::int64_t product = 2;
  for (const std::size_t i : kAxes)
    if (a[i] != b[i]) product *= 2 * std::abs(b[i] - a[i]);
  return product;
}

template <class Visit>
void for_box(const Place& a, const Place& b, Visit&& visit) {
  for (int z = std::min(a[2], b[2]); z <= std::max(a[2], b[2]); ++z)
    for (int y = std::min(a[1], b[1]); y <= std::max(a[1], b[1]); ++y)
      for (int x = std::min(a[0], b[0]); x <= std::max(a[0], b[0]); ++x) visit(Place{x, y, z});
}

bool sees_supercover(const World& world, const std::vector<std::uint8_t>& bad, CornerRule corners,
                     const Place& a, const Place& b) {
  const std::int64_t whole = denominator(a, b);
  std::vector<std::int64_t> touches;  // when a bad cell is only touched
  bool clear = true;
  for_box(a, b, [&](const Place& c) {
    if (!clear || bad[world.index(c)] == 0) return;
    const auto [first, last] = stretch(a, b, c, whole);
    if (first < last || a == b) clear = false;
    if (first == last) touches.push_back(first);
  });
  std::sort(touches.begin(), touches.end());
  for (std::size_t i = 0; i < touches.size(); ++i)
    clear &= std::count(touches.begin(), touches.end(), touches[i]) <= tolerated(corners);
  return clear;
}

bool sees_bresenham(const World& world, const std::vector<std::uint8_t>& bad, CornerRule corners,
                    const Place& a, const Place& b) {
  const auto is_bad = [&](const Place& p) { return bad[world.index(p)] != 0; };
  int longest = 0;
  for (const std::size_t i : kAxes) longest = std::max(longest, std::abs(b[i] - a[i]));
  const auto cell = [&](int k) {  // the nearest cell at k / longest of the way, halves going on ahead
    Place p = a;
    for (const std::size_t i : kAxes)
      if (longest > 0) {
        const int ahead = (2 * k * std::abs(b[i] - a[i]) + longest) / (2 * longest);
        p[i] += b[i] > a[i] ? ahead : -ahead;
      }
    return p;
  };
  if (is_bad(a) || is_bad(b)) return false;
  for (int k = 1; k <= longest; ++k) {
    const Place from = cell(k - 1), to = cell(k);
    int beside = 0;
    for_box(from, to, [&](const Place& p) { beside += p != from && p != to && is_bad(p) ? 1 : 0; });
    if (is_bad(to) || beside > tolerated(corners)) return false;
  }
  return true;
}

}  // namespace

bool sees(const World& world, const std::vector<std::uint8_t>& bad, CornerRule corners, SightRule rule,
          std::size_t a, std::size_t b) {
  const Place p = world.place(std::min(a, b)), q = world.place(std::max(a, b));
  return rule == SightRule::supercover ? sees_supercover(world, bad, corners, p, q)
                                       : sees_bresenham(world, bad, corners, p, q);
}

std::vector<std::size_t> crossed_cells(const World& world, std::size_t a, std::size_t b) {
  const Place p = world.place(a), q = world.place(b);
  const std::int64_t whole = denominator(p, q);
  std::vector<std::size_t> result;
  for_box(p, q, [&](const Place& c) {
    const auto [first, last] = stretch(p, q, c, whole);
    if (first < last) result.push_back(world.index(c));
  });
  std::sort(result.begin(), result.end());
  return result;
}

std::int64_t quarters(const World& world, std::size_t a, std::size_t b) {
  const Place p = world.place(a), q = world.place(b);
  std::int64_t sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t gap = std::max(2 * std::abs(p[axis] - q[axis]) - 1, 0);
    sum += gap * gap;
  }
  return sum;
}

bool nearer(std::int64_t quarters, double radius) {
  __extension__ using Wide = unsigned __int128;
  int exponent = 0;
  const auto digits = static_cast<std::uint64_t>(std::ldexp(std::frexp(2 * radius, &exponent), 53));
  const int shift = 2 * (53 - exponent);  // (2 radius)^2 = digits^2 / 2^shift
  if (quarters == 0 || shift > 112) return quarters == 0;
  return (static_cast<Wide>(quarters) << shift) < static_cast<Wide>(digits) * digits;
}

std::vector<std::uint8_t> grown(const World& world, double radius) {
  std::vector<std::uint8_t> cells(world.blocked.size());
  for (std::size_t b = 0; b < cells.size(); ++b)
    for (std::size_t a = 0; world.blocked[b] != 0 && a < cells.size(); ++a)
      if (a == b || nearer(quarters(world, a, b), radius)) cells[a] = 1;
  return cells;
}

std::int64_t least_quarters(const World& world, std::size_t cell) {
  std::int64_t least = INT64_MAX;
  for (std::size_t b = 0; b < world.blocked.size(); ++b)
    if (world.blocked[b] != 0) least = std::min(least, quarters(world, cell, b));
  return least;
}

// Along an axis the segment is at a + t d, 0 <= t <= 1. It is less than one away from c where
// c - 1 < a + t d < c + 1: an open stretch of times, or all or none if d is 0. All axes at once: the stretches meet.
bool sees_wide(const World& world, const std::vector<std::uint8_t>& bad, std::size_t a, std::size_t b) {
  const Place p = world.place(a), q = world.place(b);
  for (std::size_t c = 0; c < bad.size(); ++c) {
    if (bad[c] == 0) continue;
    const Place r = world.place(c);
    // As fractions: the latest beginning and the earliest end.
    std::int64_t begin = -1, begin_of = 1, end = 2, end_of = 1;
    bool meets = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int64_t d = q[axis] - p[axis];
      std::int64_t low = r[axis] - 1 - p[axis], high = r[axis] + 1 - p[axis];
      if (d == 0) {
        meets &= low < 0 && 0 < high;
        continue;
      }
      const std::int64_t size = std::abs(d);
      if (d < 0) std::tie(low, high) = std::pair(-high, -low);
      if (low * begin_of > begin * size) begin = low, begin_of = size;
      if (high * end_of < end * size) end = high, end_of = size;
    }
    // Between the two there must be a time from 0 to 1.
    meets &= begin * end_of < end * begin_of && begin < begin_of && end > 0;
    if (meets) return false;
  }
  return true;
}

}  // namespace replan::oracle
