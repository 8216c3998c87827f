#include "core/scene/edge_bins.hpp"

#include <cmath>

#include "core/plan/tree_values.hpp"

namespace replan {

void EdgeBins::begin(const Box& world) {
  // So many along its longest side that a bin of a large tree has some tens of vertices.
  constexpr int kAcrossPlane = 128, kAcrossSpace = 24;
  solid_ = world.solid();
  const std::array<int, 3> cells{world.width(), world.height(), world.depth()};
  side_ = std::max(1.0, static_cast<double>(*std::max_element(cells.begin(), cells.end())) /
                            (solid_ ? kAcrossSpace : kAcrossPlane));
  std::size_t count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    across_[axis] = static_cast<std::uint32_t>(std::ceil(cells[axis] / side_));
    count *= across_[axis];
  }
  bins_.assign(count + 1, {});
  bin_of_.clear();
  dearest_.assign(stale_.count(), Cost::zero());
}

void EdgeBins::follow(const Run& run) {
  const Timeline& log = run.timeline();
  // A vertex has its place before it hangs on anything, and keeps it as long as it does.
  if (stale_.follow({log, run.log_id(), log.cursor(), kMostVertices},
                    {fields::kVertexParent.kind, fields::kVertexCost.kind}))
    begin(run.lattice());
  stale_.refresh(Deadline::never(), [&](std::size_t stretch, std::size_t first, std::size_t end) {
    scan(log.state(), stretch, first, end);
  });
}

void EdgeBins::scan(const SearchState& state, std::size_t stretch, std::size_t first, std::size_t end) {
  ++scanned_;
  dearest_[stretch] = Cost::zero();
  const std::size_t count = std::min<std::size_t>(vertex_count(state), end);
  if (bin_of_.size() < count) bin_of_.resize(count, kNowhere);
  for (std::size_t at = first; at < count; at += VertexPage::kSize) {
    const VertexPage page(state, static_cast<std::uint32_t>(at), solid_);
    for (std::uint32_t i = 0; i < VertexPage::kSize && at + i < count; ++i) {
      const auto vertex = static_cast<std::uint32_t>(at + i);
      const std::uint32_t parent = page.parent(i);
      if (parent == kNoNode || page.cost(i).is_infinite()) {
        put(vertex, kNowhere);
        continue;
      }
      dearest_[stretch] = std::max(dearest_[stretch], page.cost(i));
      put(vertex, bin_for(point_of(page.place(i)), point_of(vertex_place(state, parent, solid_))));
    }
  }
  for (std::size_t at = std::max(first, count); at < std::min(end, bin_of_.size()); ++at)
    put(static_cast<std::uint32_t>(at), kNowhere);
}

void EdgeBins::put(std::uint32_t vertex, std::uint32_t bin) {
  const std::uint32_t before = bin_of_[vertex];
  if (before == bin) return;
  bin_of_[vertex] = bin;
  if (bin != kNowhere) bins_[bin].push_back(vertex);
  if (before == kNowhere) return;
  std::vector<std::uint32_t>& left = bins_[before];
  *std::find(left.begin(), left.end(), vertex) = left.back();
  left.pop_back();
}

std::uint32_t EdgeBins::bin_for(const Point& from, const Point& to) const {
  const double reach = std::max({std::abs(to.x - from.x), std::abs(to.y - from.y), std::abs(to.z - from.z)});
  if (reach > side_) return long_ones();
  const auto along = [this](double at, std::size_t axis) {
    return std::min(static_cast<std::uint32_t>(at / side_), across_[axis] - 1);
  };
  return (along(from.z, 2) * across_[1] + along(from.y, 1)) * across_[0] + along(from.x, 0);
}

std::optional<std::vector<std::uint32_t>> EdgeBins::seen(std::size_t most, const Seen& seen) const {
  std::vector<std::uint32_t> vertices;
  const auto take = [&](const std::vector<std::uint32_t>& bin) {
    if (bin.size() + vertices.size() > most) return false;
    vertices.insert(vertices.end(), bin.begin(), bin.end());
    return true;
  };
  if (!take(bins_.back())) return std::nullopt;
  std::size_t bin = 0;
  for (std::uint32_t z = 0; z < across_[2]; ++z)
    for (std::uint32_t y = 0; y < across_[1]; ++y)
      for (std::uint32_t x = 0; x < across_[0]; ++x, ++bin) {
        if (bins_[bin].empty()) continue;
        const Point low{(x - 1.0) * side_, (y - 1.0) * side_, (z - 1.0) * side_};
        if (!seen(low, {low.x + 3 * side_, low.y + 3 * side_, low.z + 3 * side_})) continue;
        if (!take(bins_[bin])) return std::nullopt;
      }
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

Cost EdgeBins::dearest() const {
  return dearest_.empty() ? Cost::zero() : *std::max_element(dearest_.begin(), dearest_.end());
}

}  // namespace replan
