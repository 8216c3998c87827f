#include "core/field/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <span>

#include "core/base/trigonometry.hpp"
#include "core/field/distance.hpp"
#include "core/field/wide.hpp"

namespace replan {
namespace {

/// Distance along an offset, in raw cost.
template <int D>
std::int64_t measure(const std::array<int, D>& by, Transform transform) {
  std::array<std::int64_t, D> d{};
  std::int64_t squared = 0;
  for (std::size_t axis = 0; axis < D; ++axis) {
    d[axis] = std::abs(by[axis]);
    squared += d[axis] * d[axis];
  }
  if (transform == Transform::euclidean) return euclidean_floor(squared).raw;
  std::sort(d.begin(), d.end(), std::greater<>());
  std::int64_t sum = 0;
  for (std::size_t axis = 0; axis < D; ++axis)
    sum += (d[axis] - (axis + 1 < D ? d[axis + 1] : 0)) * kStepCost[axis + 1].raw;
  return sum;
}

std::int64_t raw_of(double cells) {
  return std::llround(cells * static_cast<double>(Cost::kScale));
}

/// What a free cell at that distance costs, which is within the range; all in raw cost.
Cost penalty_at(const ClearanceRules& rules, std::int64_t distance) {
  if (!rules.threat) return {raw_of(rules.range) - distance + Cost::kScale};
  const ThreatCurve& threat = *rules.threat;
  const std::int64_t beyond = distance - raw_of(threat.r_min);
  if (beyond <= 0) return threat.impassable ? Cost::infinity() : Cost{raw_of(threat.c)};
  const double cells = static_cast<double>(beyond) / static_cast<double>(Cost::kScale);
  return {raw_of(threat.c * exponential(-cells))};
}

/// Cells that are gathered at a time.
using Bytes [[gnu::vector_size(32)]] = std::uint8_t;
constexpr int kLanes = sizeof(Bytes);

/// The rank of an obstacle that stands so far behind a cell.
struct Shifted {
  std::ptrdiff_t delta;
  std::uint8_t rank;
};

/// The least rank of the obstacles around each of `count` cells. There are cells at all shifts from each, and
/// from kLanes more.
REPLAN_WIDE void gather_row(std::uint8_t* ranks, const std::uint8_t* cells, int count,
                            std::span<const Shifted> shifts) {
  for (int x = 0; x < count; x += kLanes) {
    Bytes least = Bytes{} - 1;
    for (const Shifted& shift : shifts) {
      Bytes there;
      std::memcpy(&there, cells + x + shift.delta, sizeof there);
      const Bytes offered = reinterpret_cast<Bytes>(there == 0) | shift.rank;
      least = least < offered ? least : offered;
    }
    if (count - x >= kLanes)
      std::memcpy(ranks + x, &least, sizeof least);
    else
      std::memcpy(ranks + x, &least, static_cast<std::size_t>(count - x));
  }
}

}  // namespace

template <int D>
ClearanceField<D>::ClearanceField(const BoxLattice<D>& lattice, ClearanceRules rules) : rules_(rules) {
  prepare(lattice);
  ranks_.assign(lattice.node_count(), kFar);
  // All give the same ranks: cells are gathered many at a time, obstacles scattered one at a time; and a transform
  // takes as long whatever the range.
  constexpr std::size_t kGatheredAtATime = 24, kLookedAt = 13, kTransformed = 8;
  std::size_t obstacles = 0;
  for (std::size_t n = 0; n < ranks_.size(); n += kLookedAt) obstacles += lattice.cells()[n] != 0;
  obstacles *= kLookedAt;
  if (obstacles * kGatheredAtATime > ranks_.size() && stencil_.size() <= kFewOffsets)
    gather(lattice);
  else if (rules_.transform == Transform::euclidean &&
           obstacles * stencil_.size() > kTransformed * ranks_.size())
    transform(lattice);
  else
    scatter(lattice);
  if (rules_.border_is_obstacle)
    for (NodeId node = 0; node < ranks_.size(); ++node)
      if (!is_inside(lattice, lattice.coordinates(node), reach_)) ranks_[node] = rank_of(lattice, node);
}

/// Row by row, many cells at a time: each takes the least rank of all offsets at which there is an obstacle.
/// That is looked up in a copy of the cells with as many free ones around as an offset reaches, so that none
/// leads out.
template <int D>
void ClearanceField<D>::gather(const BoxLattice<D>& lattice) {
  std::array<std::ptrdiff_t, D> stride{};
  std::ptrdiff_t size = 1;
  for (std::size_t axis = 0; axis < D; size *= lattice.size()[axis] + 2 * reach_, ++axis) stride[axis] = size;
  const auto place = [&](const std::array<int, D>& at) {
    std::ptrdiff_t sum = 0;
    for (std::size_t axis = 0; axis < D; ++axis) sum += at[axis] * stride[axis];
    return sum;
  };
  std::array<int, D> corner{};
  corner.fill(reach_);
  std::vector<std::uint8_t> padded(static_cast<std::size_t>(size + kLanes));
  const auto row_of = [&](NodeId first) {
    return &padded[static_cast<std::size_t>(place(corner) + place(lattice.coordinates(first)))];
  };
  std::vector<Shifted> shifts = {{0, 0}};
  for (const Offset& offset : stencil_) shifts.push_back({place(offset.by), offset.rank});
  const auto width = static_cast<NodeId>(lattice.width());
  for (NodeId first = 0; first < ranks_.size(); first += width)
    std::memcpy(row_of(first), &lattice.cells()[first], width);
  for (NodeId first = 0; first < ranks_.size(); first += width)
    gather_row(&ranks_[first], row_of(first), lattice.width(), shifts);
}

/// By the distances of all cells at once, however many offsets there are.
template <int D>
void ClearanceField<D>::transform(const BoxLattice<D>& lattice) {
  const auto squared = [](const std::array<int, D>& by) {
    int sum = 0;
    for (const int part : by) sum += part * part;
    return static_cast<std::size_t>(sum);
  };
  std::vector<std::uint8_t> rank(stencil_.empty() ? 1 : squared(stencil_.back().by) + 1, kFar);
  rank[0] = 0;
  for (const Offset& offset : stencil_) rank[squared(offset.by)] = offset.rank;
  const std::vector<std::int32_t> distances = squared_distances(
      lattice.width(), lattice.height(), D == 3 ? lattice.size()[D - 1] : 1, lattice.cells());
  for (std::size_t n = 0; n < ranks_.size(); ++n)
    if (const auto at = static_cast<std::size_t>(distances[n]); at < rank.size()) ranks_[n] = rank[at];
}

/// Obstacle by obstacle: the cells around it take their ranks if they had none that is nearer.
template <int D>
void ClearanceField<D>::scatter(const BoxLattice<D>& lattice) {
  const auto cells = lattice.cells();
  constexpr std::size_t kTogether = sizeof(std::uint64_t);
  for (std::size_t first = 0; first < cells.size(); first += kTogether) {
    const std::size_t count = std::min(kTogether, cells.size() - first);
    std::uint64_t any = 0;
    std::memcpy(&any, &cells[first], count);
    if (any == 0) continue;
    for (std::size_t n = first; n < first + count; ++n) {
      if (cells[n] == 0) continue;
      const auto node = static_cast<NodeId>(n);
      ranks_[node] = 0;
      if (is_inner(lattice, node)) continue;
      for_stencil(lattice, node,
                  [&](NodeId there, std::uint8_t rank) { ranks_[there] = std::min(ranks_[there], rank); });
    }
  }
}

/// True if no obstacle is nearest to any free cell because of this one: all its face neighbours are obstacles
/// too. (From the nearest obstacle, the face neighbour towards the free cell along the longer axis is nearer
/// still.)
template <int D>
bool ClearanceField<D>::is_inner(const BoxLattice<D>& lattice, NodeId node) const {
  const auto at = lattice.coordinates(node);
  NodeId stride = 1;
  for (std::size_t axis = 0; axis < D; stride *= static_cast<NodeId>(lattice.size()[axis]), ++axis) {
    if (at[axis] > 0 && !lattice.blocked(node - stride)) return false;
    if (at[axis] + 1 < lattice.size()[axis] && !lattice.blocked(node + stride)) return false;
  }
  return true;
}

template <int D>
void ClearanceField<D>::prepare(const BoxLattice<D>& lattice) {
  const std::int64_t limit = raw_of(rules_.range);
  reach_ = static_cast<int>(limit / Cost::kScale);
  std::map<std::int64_t, std::vector<std::array<int, D>>> by_distance;
  const int side = 2 * reach_ + 1;
  const int count = D == 2 ? side * side : side * side * side;
  for (int code = 0; code < count; ++code) {
    std::array<int, D> by{};
    int rest = code;
    for (std::size_t axis = 0; axis < D; ++axis, rest /= side) by[axis] = rest % side - reach_;
    const std::int64_t distance = measure<D>(by, rules_.transform);
    if (distance > 0 && distance <= limit) by_distance[distance].push_back(by);
  }
  penalties_.assign(256, Cost::zero());
  penalties_[0] = penalty_at(rules_, 0);
  std::uint8_t rank = 0;
  for (const auto& [distance, offsets] : by_distance) {
    penalties_[++rank] = penalty_at(rules_, distance);
    for (const auto& by : offsets) {
      std::int32_t stride = 1, delta = 0;
      for (std::size_t axis = 0; axis < D; stride *= lattice.size()[axis], ++axis) delta += by[axis] * stride;
      stencil_.push_back({by, delta, rank});
    }
  }
}

template <int D>
template <class Visit>
void ClearanceField<D>::for_stencil(const BoxLattice<D>& lattice, NodeId node, Visit&& visit) const {
  const auto at = lattice.coordinates(node);
  const bool all_inside = is_inside(lattice, at, reach_);
  for (const Offset& offset : stencil_) {
    auto there = at;
    for (std::size_t axis = 0; axis < D; ++axis) there[axis] += offset.by[axis];
    if (all_inside || lattice.contains(there)) visit(node + static_cast<NodeId>(offset.delta), offset.rank);
  }
}

/// Whether a place is at least so far from each side that there is a cell at any offset up to it.
template <int D>
bool ClearanceField<D>::is_inside(const BoxLattice<D>& lattice, const typename BoxLattice<D>::Coordinates& at,
                                  int margin) {
  bool inside = true;
  for (std::size_t axis = 0; axis < D; ++axis)
    inside &= at[axis] >= margin && lattice.size()[axis] - 1 - at[axis] >= margin;
  return inside;
}

template <int D>
std::uint8_t ClearanceField<D>::rank_of(const BoxLattice<D>& lattice, NodeId node) const {
  if (lattice.blocked(node)) return 0;
  const auto at = lattice.coordinates(node);
  for (const Offset& offset : stencil_) {
    auto there = at;
    for (std::size_t axis = 0; axis < D; ++axis) there[axis] += offset.by[axis];
    const bool blocked = lattice.contains(there) ? lattice.blocked(node + static_cast<NodeId>(offset.delta))
                                                 : rules_.border_is_obstacle;
    if (blocked) return offset.rank;
  }
  return kFar;
}

template <int D>
void ClearanceField<D>::note(NodeId node) {
  if (noted_[node] != 0) return;
  noted_[node] = 1;
  changes_.push_back({node, penalty(node)});
}

template <int D>
void ClearanceField<D>::lower(NodeId node, std::uint8_t rank) {
  if (rank >= ranks_[node]) return;
  note(node);
  ranks_[node] = rank;
}

template <int D>
std::span<const ClearanceChange> ClearanceField<D>::update(const BoxLattice<D>& lattice,
                                                           std::span<const CellEdit> edits) {
  changes_.clear();
  noted_.resize(ranks_.size());
  // Removals first: they look at the finished map, so additions are in what they find already.
  for (const CellEdit& edit : edits) {
    if (edit.blocked) continue;
    const auto look_again = [&](NodeId there, std::uint8_t rank) {
      if (ranks_[there] < rank) return;  // something nearer than the removed obstacle decides here
      note(there);
      ranks_[there] = rank_of(lattice, there);
    };
    look_again(edit.node, 0);
    for_stencil(lattice, edit.node, look_again);
  }
  for (const CellEdit& edit : edits) {
    if (!edit.blocked) continue;
    lower(edit.node, 0);
    for_stencil(lattice, edit.node, [&](NodeId there, std::uint8_t rank) { lower(there, rank); });
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    noted_[changes_[i].node] = 0;
    if (penalty(changes_[i].node) != changes_[i].before) changes_[kept++] = changes_[i];
  }
  changes_.resize(kept);
  return changes_;
}

template class ClearanceField<2>;
template class ClearanceField<3>;

}  // namespace replan
