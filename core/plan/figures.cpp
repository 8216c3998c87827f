#include "core/plan/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "core/lattice/segment.hpp"
#include "core/lattice/sight.hpp"
#include "core/lattice/squares.hpp"

namespace replan {
namespace {

constexpr double kSampleStep = 0.1;  // cells between two samples of the clearance
constexpr double kCurveArm = 0.5;    // cells to either side over which a heading's change is taken
constexpr double kStraight = 1e-9;   // radians: a smaller change of heading is no turn
constexpr double kDegrees = 57.295779513082320876798;

/// Exact distance from any point to the nearest obstacle cell's square (cube).
///
/// A pyramid: each block of a level says whether one of its up to 2^D blocks below holds an obstacle. A
/// search goes down into the nearest blocks first and leaves out what cannot be nearer than the best so far,
/// so it costs about the pyramid's height, however far the nearest obstacle is.
template <int D>
class ObstacleDistance {
 public:
  using Point = std::array<double, D>;  // in cells; the centre of cell (x, y) is (x, y)
  using Block = std::array<int, D>;

  ObstacleDistance(const Block& sides, std::span<const std::uint8_t> cells) : cells_(cells), sizes_{sides} {
    while (*std::max_element(sizes_.back().begin(), sizes_.back().end()) > 1) add_level();
  }

  [[nodiscard]] bool any() const { return occupied(sizes_.size() - 1, Block{}); }
  /// The distance in cells, known to be at most `limit`. There must be an obstacle.
  [[nodiscard]] double at(const Point& point, double limit) const {
    double best = limit * limit;
    descend(sizes_.size() - 1, Block{}, point, best);
    return std::sqrt(best);
  }

 private:
  [[nodiscard]] static std::size_t index(const Block& size, const Block& block) {
    std::size_t result = 0;
    for (std::size_t axis = D; axis-- > 0;)
      result = result * static_cast<std::size_t>(size[axis]) + static_cast<std::size_t>(block[axis]);
    return result;
  }
  [[nodiscard]] bool occupied(std::size_t level, const Block& block) const {
    const std::size_t at = index(sizes_[level], block);
    return level == 0 ? cells_[at] != 0 : levels_[level - 1][at] != 0;
  }

  void add_level() {
    const std::size_t below = sizes_.size() - 1;
    const Block fine = sizes_.back();
    Block coarse{};
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < D; ++axis) {
      coarse[axis] = (fine[axis] + 1) / 2;
      count *= static_cast<std::size_t>(coarse[axis]);
    }
    std::vector<std::uint8_t> level(count);
    Block block{};
    const std::size_t fine_count = below == 0 ? cells_.size() : levels_[below - 1].size();
    const std::uint8_t* values = below == 0 ? cells_.data() : levels_[below - 1].data();
    for (std::size_t i = 0; i < fine_count; ++i) {
      if (values[i] != 0) {
        Block above = block;
        for (int& part : above) part /= 2;
        level[index(coarse, above)] = 1;
      }
      for (std::size_t axis = 0; axis < D && ++block[axis] == fine[axis]; ++axis) block[axis] = 0;
    }
    levels_.push_back(std::move(level));
    sizes_.push_back(coarse);
  }

  /// Squared distance from `point` to the box that a block of a level covers.
  [[nodiscard]] static double squared(std::size_t level, const Block& block, const Point& point) {
    const double side = static_cast<double>(std::int64_t{1} << level);
    double sum = 0;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double low = block[axis] * side - 0.5;
      const double off = std::max({low - point[axis], point[axis] - (low + side), 0.0});
      sum += off * off;
    }
    return sum;
  }

  void descend(std::size_t level, const Block& block, const Point& point, double& best) const {
    if (!occupied(level, block)) return;
    const double distance = squared(level, block, point);
    if (distance >= best) return;
    if (level == 0) {
      best = distance;
      return;
    }
    const double half = static_cast<double>(std::int64_t{1} << (level - 1));
    unsigned nearest = 0;  // the child on the point's side along each axis
    for (std::size_t axis = 0; axis < D; ++axis)
      nearest |= (point[axis] > (2 * block[axis] + 1) * half - 0.5 ? 1u : 0u) << axis;
    for (unsigned turn = 0; turn < (1u << D); ++turn) {
      Block child{};
      bool inside = true;
      for (std::size_t axis = 0; axis < D; ++axis) {
        child[axis] = 2 * block[axis] + static_cast<int>((nearest ^ turn) >> axis & 1u);
        inside &= child[axis] < sizes_[level - 1][axis];
      }
      if (inside) descend(level - 1, child, point, best);
    }
  }

  std::span<const std::uint8_t> cells_;
  std::vector<Block> sizes_;                       // of each level, the cells' own first
  std::vector<std::vector<std::uint8_t>> levels_;  // without the cells' own
};

double diagonal(const Box& box) {
  const std::array<double, 3> sides = {double(box.width()), double(box.height()),
                                       box.solid() ? double(box.depth()) : 0};
  return std::sqrt(sides[0] * sides[0] + sides[1] * sides[1] + sides[2] * sides[2]);
}

/// Minimum and mean over samples at arc lengths 0, 0.1, 0.2, ... and at the end of the polyline.
template <int D>
void measure_clearance(const Box& box, std::span<const std::uint8_t> cells, const Path& path,
                       PathFigures& figures) {
  const ObstacleDistance<D> obstacles(box.sides<D>(), cells);
  figures.min_clearance = figures.mean_clearance = std::numeric_limits<double>::infinity();
  if (!obstacles.any()) return;
  double sum = 0, last = diagonal(box);
  std::int64_t samples = 0;
  using At = typename ObstacleDistance<D>::Point;
  const auto sample = [&](const At& point) {
    // Two samples are at most a step apart, so the distance cannot have grown by more: a tight limit for the
    // search.
    last = obstacles.at(point, last + kSampleStep + 1e-6);
    figures.min_clearance = std::min(figures.min_clearance, last);
    sum += last;
    ++samples;
  };
  const auto in_cells = [&path](std::size_t i) {
    const std::array<double, 3> point = {path.point(i).x - 0.5, path.point(i).y - 0.5, path.point(i).z - 0.5};
    At at{};
    std::copy_n(point.begin(), D, at.begin());
    return at;
  };
  double travelled = 0;  // up to the segment's beginning
  At point{};
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double length = distance(path.point(i), path.point(i + 1));
    const At from = in_cells(i), to = in_cells(i + 1);
    for (double at; (at = static_cast<double>(samples) * kSampleStep) < travelled + length;) {
      const double part = std::max(0.0, at - travelled) / length;
      for (std::size_t axis = 0; axis < D; ++axis) point[axis] = from[axis] + (to[axis] - from[axis]) * part;
      sample(point);
    }
    travelled += length;
  }
  sample(in_cells(path.size() - 1));
  figures.mean_clearance = sum / static_cast<double>(samples);
}

/// The angle between two headings, in radians.
double angle(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  double dot = 0, crossed = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    dot += a[i] * b[i];
    for (std::size_t j = i + 1; j < 3; ++j)
      crossed += (a[i] * b[j] - a[j] * b[i]) * (a[i] * b[j] - a[j] * b[i]);
  }
  return std::atan2(std::sqrt(crossed), dot);
}

void measure_turns(const Path& path, PathFigures& figures) {
  std::array<double, 3> heading{};
  bool moving = false;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point from = path.point(i - 1), to = path.point(i);
    if (from == to) continue;
    const std::array<double, 3> next = {to.x - from.x, to.y - from.y, to.z - from.z};
    const double change = moving ? angle(heading, next) : 0;
    figures.turns += change > kStraight ? 1 : 0;
    figures.turning_angle_deg += change * kDegrees;
    heading = next;
    moving = true;
  }
}

/// A path by how far along it one is.
class PathWalk {
 public:
  explicit PathWalk(const Path& path) : path_(path), along_(path.size()) {
    for (std::size_t i = 1; i < path.size(); ++i)
      along_[i] = along_[i - 1] + distance(path.point(i - 1), path.point(i));
  }
  [[nodiscard]] const std::vector<double>& along() const { return along_; }
  [[nodiscard]] double length() const { return along_.back(); }
  [[nodiscard]] Point at(double way) const {
    const auto next = std::upper_bound(along_.begin(), along_.end(), way);
    if (next == along_.end()) return path_.point(path_.size() - 1);
    const auto i = static_cast<std::size_t>(next - along_.begin());
    const Point from = path_.point(i - 1), to = path_.point(i);
    const double part = (way - along_[i - 1]) / (along_[i] - along_[i - 1]);
    return {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y),
            from.z + part * (to.z - from.z)};
  }

 private:
  const Path& path_;
  std::vector<double> along_;  // of each point
};

void measure_curvature(const Path& path, PathFigures& figures) {
  const PathWalk walk(path);
  const auto look = [&](double way) {
    const Point before = walk.at(std::max(way - kCurveArm, 0.0)), here = walk.at(way),
                behind = walk.at(std::min(way + kCurveArm, walk.length()));
    if (before == here || here == behind) return;
    const double change = angle({here.x - before.x, here.y - before.y, here.z - before.z},
                                {behind.x - here.x, behind.y - here.y, behind.z - here.z});
    figures.greatest_curvature = std::max(figures.greatest_curvature, change / kCurveArm);
  };
  for (const double corner : walk.along()) look(corner);
  const auto samples = static_cast<std::int64_t>(walk.length() / kSampleStep);
  for (std::int64_t i = 1; i <= samples; ++i) look(static_cast<double>(i) * kSampleStep);
}

/// True if `to` is a neighbour of `from` and the move between them is allowed.
template <int D>
bool is_move(const BoxLattice<D>& lattice, NodeId from, NodeId to) {
  const auto p = lattice.coordinates(from), q = lattice.coordinates(to);
  typename Directions<D>::Offset offset{};
  for (std::size_t axis = 0; axis < D; ++axis) {
    offset[axis] = q[axis] - p[axis];
    if (std::abs(offset[axis]) > 1) return false;
  }
  return from != to && (lattice.moves(from) >> Directions<D>::index(offset) & 1u) != 0;
}

}  // namespace

double path_length(const Path& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += distance(path.point(i - 1), path.point(i));
  return length;
}

double distance_to(const Path& path, const Point& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Point from = path.point(i == 0 ? 0 : i - 1), to = path.point(i);
    const Point way{to.x - from.x, to.y - from.y, to.z - from.z};
    const double squared = way.x * way.x + way.y * way.y + way.z * way.z;
    const double along = (point.x - from.x) * way.x + (point.y - from.y) * way.y + (point.z - from.z) * way.z;
    const double part = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
    least = std::min(least,
                     distance(point, {from.x + part * way.x, from.y + part * way.y, from.z + part * way.z}));
  }
  return least;
}

PathFigures path_figures(const Box& box, std::span<const std::uint8_t> cells, const Path& path) {
  PathFigures figures;
  if (path.empty()) return figures;
  figures.nodes = static_cast<std::int64_t>(path.size());
  figures.length = path_length(path);
  measure_turns(path, figures);
  measure_curvature(path, figures);
  with_dimensions(box, [&](auto d) { measure_clearance<d()>(box, cells, path, figures); });
  return figures;
}

template <int D>
bool path_is_free(const BoxLattice<D>& lattice, const Path& path) {
  const auto bad = [&](NodeId node) { return lattice.blocked(node); };
  const auto free_between = [&](std::size_t i) {
    if constexpr (D == 2)
      if (path.touches)
        return Squares(lattice).clear(half_point(path.point(i - 1)), half_point(path.point(i)),
                                      lattice.rules().corners);
    if (path.nodes().empty())
      return walk_segment(lattice.box(), path.point(i - 1), path.point(i), [&](NodeId n) { return !bad(n); });
    const NodeId from = path.nodes()[i - 1], to = path.nodes()[i];
    return is_move(lattice, from, to) || line_of_sight(lattice, path.sight(), from, to, bad);
  };
  if (path.size() == 1) return !bad(lattice.node(cell_of(path.point(0))));
  for (std::size_t i = 1; i < path.size(); ++i)
    if (!free_between(i)) return false;
  return true;
}

template bool path_is_free<2>(const BoxLattice<2>&, const Path&);
template bool path_is_free<3>(const BoxLattice<3>&, const Path&);

}  // namespace replan
