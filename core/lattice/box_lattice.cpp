#include "core/lattice/box_lattice.hpp"

#include <atomic>

namespace replan {
namespace {

std::uint64_t new_revision() {
  static std::atomic<std::uint64_t> latest = 0;
  return latest.fetch_add(1, std::memory_order_relaxed) + 1;
}

/// Of each direction the cells that a move along it squeezes past, worked out once: a large box asks for millions.
template <int D>
constexpr auto kSqueezedPast = [] {
  std::array<std::uint32_t, Directions<D>::kCount> masks{};
  for (int d = 0; d < Directions<D>::kCount; ++d)
    masks[static_cast<std::size_t>(d)] = Directions<D>::squeezed(d);
  return masks;
}();

/// The moves out of a free cell whose surroundings are blocked as in `blocked` (bit d: the cell in direction
/// d).
template <int D>
std::uint32_t moves_given(std::uint32_t blocked, MoveRules rules) {
  const int allowed = rules.corners == CornerRule::none ? 0 : rules.corners == CornerRule::one ? 1 : 8;
  std::uint32_t moves = 0;
  for (int d = 0; d < Directions<D>::kCount; ++d) {
    if ((blocked >> d & 1u) != 0) continue;
    if (!rules.diagonals && Directions<D>::axes(d) > 1) continue;
    const std::uint32_t past = blocked & kSqueezedPast<D>[static_cast<std::size_t>(d)];
    if (past == 0 || (allowed > 0 && std::popcount(past) <= allowed)) moves |= 1u << d;
  }
  return moves;
}

}  // namespace

template <int D>
BoxLattice<D>::BoxLattice(Coordinates size, MoveRules rules) : size_(size), rules_(rules) {
  std::size_t count = 1;
  for (const int extent : size) count *= static_cast<std::size_t>(extent);
  blocked_.assign(count, 0);
  prepare();
}

template <int D>
BoxLattice<D>::BoxLattice(Coordinates size, std::vector<std::uint8_t> blocked, MoveRules rules)
    : size_(size), rules_(rules), blocked_(std::move(blocked)) {
  prepare();
}

template <int D>
void BoxLattice<D>::prepare() {
  for (std::size_t axis = 0; axis < D; ++axis) inverse_[axis] = 1.0 / size_[axis];
  for (int d = 0; d < kDirections; ++d) {
    const auto offset = Directions<D>::offset(d);
    std::int32_t stride = 1, delta = 0;
    for (std::size_t axis = 0; axis < D; stride *= size_[axis], ++axis) delta += offset[axis] * stride;
    delta_[static_cast<std::size_t>(d)] = delta;
  }
  inflate();
  set_rules(rules_);
}

template <int D>
void BoxLattice<D>::inflate() {
  if (rules_.radius <= 0) return;
  inflation_.emplace(size_, std::move(blocked_), rules_.radius);
  blocked_ = inflation_->blocked();
}

template <int D>
void BoxLattice<D>::set_rules(MoveRules rules) {
  if (rules.radius != rules_.radius) {
    if (inflation_) blocked_.assign(obstacles().begin(), obstacles().end());
    inflation_.reset();
    rules_.radius = rules.radius;
    inflate();
  }
  rules_ = rules;
  if (inflation_) rules_.corners = CornerRule::none;
  revision_ = new_revision();
  open_moves_ = static_cast<MoveMask>(moves_given<D>(0, rules_));
  if constexpr (D == 2) {
    masks_by_surroundings_.resize(256);
    for (std::uint32_t blocked = 0; blocked < 256; ++blocked)
      masks_by_surroundings_[blocked] = static_cast<MoveMask>(moves_given<D>(blocked, rules_));
  }
  moves_.resize(blocked_.size());
  for (NodeId node = 0; node < moves_.size(); ++node) moves_[node] = moves_for(node);
}

template <int D>
Cost BoxLattice<D>::other_bound(Heuristic heuristic, const Coordinates& p, const Coordinates& q) const {
  std::int64_t sum = 0, longest = 0;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const std::int64_t d = std::abs(p[axis] - q[axis]);
    sum += d;
    longest = std::max(longest, d);
  }
  switch (heuristic) {
    case Heuristic::euclidean:
      return euclidean_floor(squared_distance(p, q));
    case Heuristic::chebyshev:
      return Cost::cells(longest);
    case Heuristic::zero:
      return Cost::zero();
    case Heuristic::octile:  // without diagonals
    case Heuristic::manhattan:
      break;
  }
  return Cost::cells(sum);
}

template <int D>
std::uint32_t BoxLattice<D>::blocked_around(NodeId node) const {
  const Coordinates at = coordinates(node);
  bool inside = true;
  for (std::size_t axis = 0; axis < D; ++axis) inside &= at[axis] > 0 && at[axis] + 1 < size_[axis];
  std::uint32_t blocked = 0;
  if (inside) {
    for (int d = 0; d < kDirections; ++d)
      blocked |= static_cast<std::uint32_t>(blocked_[neighbour(node, d)] != 0) << d;
    return blocked;
  }
  for (int d = 0; d < kDirections; ++d) {
    if (!contains(step(at, d)) || blocked_[neighbour(node, d)] != 0) blocked |= 1u << d;
  }
  return blocked;
}

template <int D>
auto BoxLattice<D>::moves_for(NodeId node) const -> MoveMask {
  if (blocked_[node] != 0) return 0;
  const std::uint32_t blocked = blocked_around(node);
  if (blocked == 0) return open_moves_;
  if constexpr (D == 2)
    return masks_by_surroundings_[blocked];
  else
    return static_cast<MoveMask>(moves_given<D>(blocked, rules_));
}

template <int D>
auto BoxLattice<D>::apply(std::span<const CellEdit> edits) -> std::span<const MoveChange> {
  touched_.clear();
  changes_.clear();
  if (inflation_) edits = inflation_->apply(edits, blocked_);
  for (const CellEdit& edit : edits) {
    if ((blocked_[edit.node] != 0) == edit.blocked) continue;
    blocked_[edit.node] = edit.blocked ? 1 : 0;
    touched_.push_back(edit.node);
  }
  if (!touched_.empty()) revision_ = new_revision();
  const auto refresh = [this](NodeId node) {
    const MoveMask before = moves_[node];
    moves_[node] = moves_for(node);
    if (moves_[node] != before) changes_.push_back({node, before});
  };
  // All cells are written before the first mask is made, so a node's first refresh is final: a second finds
  // it done.
  for (const NodeId node : touched_) {
    refresh(node);
    const Coordinates at = coordinates(node);
    for (int d = 0; d < kDirections; ++d)
      if (contains(step(at, d))) refresh(neighbour(node, d));
  }
  return changes_;
}

template class BoxLattice<2>;
template class BoxLattice<3>;

}  // namespace replan
