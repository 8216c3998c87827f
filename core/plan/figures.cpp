#include "core/plan/figures.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "core/lattice/sight.hpp"

namespace replan {
namespace {

constexpr double kSampleStep = 0.1;  // cells between two samples of the clearance
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

  explicit ObstacleDistance(const BoxLattice<D>& lattice) : cells_(lattice.cells()), sizes_{lattice.size()} {
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

template <int D>
double diagonal(const BoxLattice<D>& lattice) {
  double sum = 0;
  for (const int extent : lattice.size()) sum += double{1} * extent * extent;
  return std::sqrt(sum);
}

/// Minimum and mean over samples at arc lengths 0, 0.1, 0.2, ... and at the end of the polyline.
template <int D>
void measure_clearance(const BoxLattice<D>& lattice, std::span<const NodeId> path, PathFigures& figures) {
  const ObstacleDistance<D> obstacles(lattice);
  const double farthest = diagonal(lattice);
  figures.min_clearance = figures.mean_clearance = farthest;
  if (!obstacles.any()) return;
  double sum = 0, last = farthest;
  std::int64_t samples = 0;
  const auto sample = [&](const typename ObstacleDistance<D>::Point& point) {
    // Two samples are at most a step apart, so the distance cannot have grown by more: a tight limit for the
    // search.
    last = obstacles.at(point, last + kSampleStep + 1e-6);
    figures.min_clearance = std::min(figures.min_clearance, last);
    sum += last;
    ++samples;
  };
  double travelled = 0;  // up to the segment's beginning
  typename ObstacleDistance<D>::Point point{};
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double length = std::sqrt(static_cast<double>(lattice.squared_distance(path[i], path[i + 1])));
    const auto from = lattice.coordinates(path[i]), to = lattice.coordinates(path[i + 1]);
    for (double at; (at = static_cast<double>(samples) * kSampleStep) < travelled + length;) {
      const double part = std::max(0.0, at - travelled) / length;
      for (std::size_t axis = 0; axis < D; ++axis) point[axis] = from[axis] + (to[axis] - from[axis]) * part;
      sample(point);
    }
    travelled += length;
  }
  const auto end = lattice.coordinates(path.back());
  for (std::size_t axis = 0; axis < D; ++axis) point[axis] = end[axis];
  sample(point);
  figures.mean_clearance = sum / static_cast<double>(samples);
}

/// The angle between two headings, in radians.
template <int D>
double angle(const std::array<double, D>& a, const std::array<double, D>& b) {
  double dot = 0, crossed = 0;
  for (std::size_t i = 0; i < D; ++i) {
    dot += a[i] * b[i];
    for (std::size_t j = i + 1; j < D; ++j)
      crossed += (a[i] * b[j] - a[j] * b[i]) * (a[i] * b[j] - a[j] * b[i]);
  }
  return std::atan2(std::sqrt(crossed), dot);
}

template <int D>
void measure_turns(const BoxLattice<D>& lattice, std::span<const NodeId> path, PathFigures& figures) {
  std::array<double, D> heading{};
  bool moving = false;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path[i] == path[i - 1]) continue;
    const auto from = lattice.coordinates(path[i - 1]), to = lattice.coordinates(path[i]);
    std::array<double, D> next{};
    for (std::size_t axis = 0; axis < D; ++axis) next[axis] = to[axis] - from[axis];
    const double change = moving ? angle<D>(heading, next) : 0;
    figures.turns += change > kStraight ? 1 : 0;
    figures.turning_angle_deg += change * kDegrees;
    heading = next;
    moving = true;
  }
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

template <int D>
double path_length(const BoxLattice<D>& lattice, std::span<const NodeId> path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += std::sqrt(static_cast<double>(lattice.squared_distance(path[i - 1], path[i])));
  return length;
}

template <int D>
PathFigures path_figures(const BoxLattice<D>& lattice, std::span<const NodeId> path) {
  PathFigures figures;
  if (path.empty()) return figures;
  figures.nodes = static_cast<std::int64_t>(path.size());
  figures.length = path_length(lattice, path);
  measure_turns(lattice, path, figures);
  measure_clearance(lattice, path, figures);
  return figures;
}

template <int D>
bool path_is_free(const BoxLattice<D>& lattice, std::span<const NodeId> path, SightRule sight) {
  const auto bad = [&](NodeId node) { return lattice.blocked(node); };
  if (path.size() == 1) return !bad(path.front());
  for (std::size_t i = 1; i < path.size(); ++i)
    if (!is_move(lattice, path[i - 1], path[i]) && !line_of_sight(lattice, sight, path[i - 1], path[i], bad))
      return false;
  return true;
}

PathFigures path_figures(const Box& box, const SharedBytes& cells, MoveRules rules,
                         std::span<const NodeId> path) {
  return with_dimensions(box, [&](auto d) {
    return path_figures(BoxLattice<d()>(box.sides<d()>(), cells.plain(), rules), path);
  });
}

template double path_length<2>(const BoxLattice<2>&, std::span<const NodeId>);
template double path_length<3>(const BoxLattice<3>&, std::span<const NodeId>);
template PathFigures path_figures<2>(const BoxLattice<2>&, std::span<const NodeId>);
template PathFigures path_figures<3>(const BoxLattice<3>&, std::span<const NodeId>);
template bool path_is_free<2>(const BoxLattice<2>&, std::span<const NodeId>, SightRule);
template bool path_is_free<3>(const BoxLattice<3>&, std::span<const NodeId>, SightRule);

}  // namespace replan
