#include "core/lattice/inflation.hpp"

#include <algorithm>
#include <cmath>

namespace replan {
// The product is rounded to the nearest double; where that is no whole number, the true one lies between the same two
// whole numbers. Where it is, the error of the product says on which side the true one lies.
std::int64_t limit_of(double radius) {
  const double side = 2 * radius, square = side * side, error = std::fma(side, side, -square);
  const double above = std::ceil(square);
  const auto limit = static_cast<std::int64_t>(above) + (above == square && error > 0 ? 1 : 0);
  return std::max(limit, std::int64_t{1});  // the square of the smallest numbers is zero
}

template <int D>
Inflation<D>::Inflation(const Coordinates& size, std::vector<std::uint8_t> obstacles, double radius)
    : size_(size), obstacles_(std::move(obstacles)) {
  prepare(radius);
  count_all();
}

template <int D>
void Inflation<D>::prepare(double radius) {
  const std::int64_t limit = limit_of(radius);
  const int reach = static_cast<int>(std::ceil(radius)), side = 2 * reach + 1;
  const int rows = D == 2 ? side : side * side;
  for (int code = 0; code < rows; ++code) {
    Row row{{}, -1};
    int rest = code;
    for (std::size_t axis = 1; axis < D; ++axis, rest /= side) row.by[axis] = rest % side - reach;
    const std::int64_t across = quarters_of(row.by);
    while (row.reach < reach && across + quarters_of(std::array{row.reach + 1}) < limit) ++row.reach;
    if (row.reach < 0) continue;
    rows_.push_back(row);
    for (row.by[0] = -row.reach; row.by[0] <= row.reach; ++row.by[0])
      offsets_.push_back({row.by, quarters_of(row.by)});
  }
  std::stable_sort(offsets_.begin(), offsets_.end(),
                   [](const Offset& a, const Offset& b) { return a.quarters < b.quarters; });
}

template <int D>
auto Inflation<D>::coordinates(NodeId node) const -> Coordinates {
  Coordinates at{};
  for (std::size_t axis = 0; axis < D; ++axis) {
    at[axis] = static_cast<int>(node % static_cast<NodeId>(size_[axis]));
    node /= static_cast<NodeId>(size_[axis]);
  }
  return at;
}

template <int D>
template <class Visit>
void Inflation<D>::each_row(NodeId obstacle, Visit&& visit) const {
  const Coordinates at = coordinates(obstacle);
  for (const Row& row : rows_) {
    NodeId begin = 0;
    bool inside = true;
    for (std::size_t axis = D; axis-- > 1;) {
      const int there = at[axis] + row.by[axis];
      inside &= there >= 0 && there < size_[axis];
      begin = (begin + static_cast<NodeId>(there)) * static_cast<NodeId>(size_[axis - 1]);
    }
    if (!inside) continue;
    visit(begin + static_cast<NodeId>(std::max(0, at[0] - row.reach)),
          begin + static_cast<NodeId>(std::min(size_[0] - 1, at[0] + row.reach)));
  }
}

/// Each obstacle adds one where a row of its cells begins, and takes one away behind the row's end; sums along the
/// map's rows are the counts then.
template <int D>
void Inflation<D>::count_all() {
  counts_.assign(obstacles_.size(), 0);
  const auto width = static_cast<NodeId>(size_[0]);
  for (NodeId node = 0; node < obstacles_.size(); ++node)
    if (obstacles_[node] != 0)
      each_row(node, [&](NodeId first, NodeId last) {
        ++counts_[first];
        if ((last + 1) % width != 0) --counts_[last + 1];
      });
  for (NodeId node = 0; node < counts_.size(); ++node)
    if (node % width != 0) counts_[node] = static_cast<Count>(counts_[node] + counts_[node - 1]);
}

template <int D>
std::vector<std::uint8_t> Inflation<D>::blocked() const {
  std::vector<std::uint8_t> blocked(counts_.size());
  std::transform(counts_.begin(), counts_.end(), blocked.begin(),
                 [](Count count) { return static_cast<std::uint8_t>(count != 0); });
  return blocked;
}

template <int D>
std::span<const CellEdit> Inflation<D>::apply(std::span<const CellEdit> edits,
                                              std::span<const std::uint8_t> blocked) {
  touched_.clear();
  turned_.clear();
  for (const CellEdit& edit : edits) {
    if ((obstacles_[edit.node] != 0) == edit.blocked) continue;
    obstacles_[edit.node] = edit.blocked ? 1 : 0;
    each_row(edit.node, [&](NodeId first, NodeId last) {
      for (NodeId node = first; node <= last; ++node) {
        Count& count = counts_[node];
        count = static_cast<Count>(edit.blocked ? count + 1 : count - 1);
        if (count == (edit.blocked ? 1 : 0)) touched_.push_back(node);
      }
    });
  }
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  for (const NodeId node : touched_)
    if ((blocked[node] != 0) != (counts_[node] != 0)) turned_.push_back({node, counts_[node] != 0});
  return turned_;
}

template <int D>
std::int64_t Inflation<D>::quarters(NodeId node) const {
  if (counts_[node] == 0) return kClear;
  if (obstacles_[node] != 0) return 0;
  const Coordinates at = coordinates(node);
  for (const Offset& offset : offsets_) {
    NodeId there = 0;
    bool inside = true;
    for (std::size_t axis = D; axis-- > 0;) {
      const int place = at[axis] + offset.by[axis];
      inside &= place >= 0 && place < size_[axis];
      there = there * static_cast<NodeId>(size_[axis]) + static_cast<NodeId>(place);
    }
    if (inside && obstacles_[there] != 0) return offset.quarters;
  }
  return kClear;
}

template class Inflation<2>;
template class Inflation<3>;

}  // namespace replan
