#include "core/drive/local_obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace replan {
namespace {

constexpr double kLeastBin = 0.25;  // m
constexpr int kMostBins = 256;      // along a side: what is farther out shares the last ones

}  // namespace

ObstacleSet::ObstacleSet(ObstacleShape shape, std::span<const Spot> centres)
    : shape_(shape), bin_(std::max(kLeastBin, 2 * shape.half)) {
  if (centres.empty()) return;
  corner_ = centres.front();
  Spot high = corner_;
  for (const Spot& at : centres) {
    corner_ = {std::min(corner_.x, at.x), std::min(corner_.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  columns_ = rows_ = kMostBins;
  columns_ = column(high.x) + 1;
  rows_ = row(high.y) + 1;
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  const auto bin = [this](const Spot& at) {
    return static_cast<std::size_t>(row(at.y)) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column(at.x));
  };
  for (const Spot& at : centres) ++first_[bin(at) + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  centres_.resize(centres.size());
  for (const Spot& at : centres) centres_[next[bin(at)]++] = at;
}

int ObstacleSet::column(double x) const {
  return static_cast<int>(std::clamp((x - corner_.x) * (1 / bin_), 0.0, columns_ - 1.0));
}
int ObstacleSet::row(double y) const {
  return static_cast<int>(std::clamp((y - corner_.y) * (1 / bin_), 0.0, rows_ - 1.0));
}

/// `least` is a squared distance, to the squares' edges or the discs' centres. The bins of a row lie one behind the
/// other.
void ObstacleSet::look_at(int row, int left, int right, Spot at, double& least) const {
  const std::size_t begin = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
  const Spot* const end = &centres_[0] + first_[begin + static_cast<std::size_t>(right) + 1];
  for (const Spot* centre = &centres_[0] + first_[begin + static_cast<std::size_t>(left)]; centre < end;
       ++centre) {
    const double x = std::max(std::abs(at.x - centre->x) - shape_.half, 0.0);
    const double y = std::max(std::abs(at.y - centre->y) - shape_.half, 0.0);
    least = std::min(least, x * x + y * y);
  }
}

double ObstacleSet::distance(Spot at, double most) const {
  if (empty() || most + shape_.radius <= 0) return most;
  const double far = (most + shape_.radius) * (most + shape_.radius);
  double least = far;
  const auto look_around = [&](int left, int right, int top, int bottom) {
    for (int y = std::max(top, 0); y <= std::min(bottom, rows_ - 1); ++y)
      look_at(y, std::max(left, 0), std::min(right, columns_ - 1), at, least);
  };
  // First the bin that `at` is in, or that is nearest to it, and the eight about it: what is in none of them is at
  // least a bin's side away, less what its square reaches over.
  const int x = column(at.x), y = row(at.y);
  look_around(x - 1, x + 1, y - 1, y + 1);
  const double seen = bin_ - shape_.half;
  if (least > seen * seen) {
    const double reach = std::sqrt(least) + shape_.half;
    look_around(column(at.x - reach), column(at.x + reach), row(at.y - reach), row(at.y + reach));
  }
  return least >= far ? most : std::sqrt(least) - shape_.radius;
}

double LocalObstacles::to_moving(Spot at, const SineCosine& heading, double time, double most) const {
  const auto [half, radius] = moving.shape();
  const double come_nearer = speed_of_moving * time;
  double least = most;
  for (const Spot& centre : moving.centres()) {
    const double x = centre.x - at.x, y = centre.y - at.y;
    const double nearest_edge = half * (std::abs(heading.cosine) + std::abs(heading.sine));
    if (x * heading.cosine + y * heading.sine + nearest_edge + come_nearer <= 0) continue;
    const double beside_x = std::max(std::abs(x) - half, 0.0), beside_y = std::max(std::abs(y) - half, 0.0);
    least = std::min(least, std::sqrt(beside_x * beside_x + beside_y * beside_y) - radius - come_nearer);
  }
  return least;
}

}  // namespace replan
