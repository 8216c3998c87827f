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

/// `least` is a squared distance, to the squares' edges or the discs' centres.
void ObstacleSet::look_at(int column, int row, Spot at, double& least) const {
  const std::size_t bin =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  for (std::uint32_t i = first_[bin]; i < first_[bin + 1]; ++i) {
    const double x = std::max(std::abs(at.x - centres_[i].x) - shape_.half, 0.0);
    const double y = std::max(std::abs(at.y - centres_[i].y) - shape_.half, 0.0);
    least = std::min(least, x * x + y * y);
  }
}

double ObstacleSet::distance(Spot at, double most) const {
  if (empty() || most + shape_.radius <= 0) return most;
  const double far = (most + shape_.radius) * (most + shape_.radius);
  double least = far;
  // By rings of bins around the one that `at` is in, or that is nearest to it. A bin of the ring is at least so many
  // bins away, less the one that `at` may stand at the edge of.
  const int middle_x = column(at.x), middle_y = row(at.y);
  for (int ring = 0;; ++ring) {
    const double nearest = (ring - 1) * bin_ - shape_.half;
    if (ring > 0 && nearest > 0 && nearest * nearest >= least) break;
    const int left = middle_x - ring, right = middle_x + ring, top = middle_y - ring,
              bottom = middle_y + ring;
    if (left < 0 && top < 0 && right >= columns_ && bottom >= rows_) break;
    for (int y = std::max(top, 0); y <= std::min(bottom, rows_ - 1); ++y) {
      const int step = y == top || y == bottom ? 1 : std::max(1, 2 * ring);
      for (int x = left; x <= right; x += step)
        if (x >= 0 && x < columns_) look_at(x, y, at, least);
    }
  }
  return least >= far ? most : std::sqrt(least) - shape_.radius;
}

}  // namespace replan
