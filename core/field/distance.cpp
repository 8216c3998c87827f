#include "core/field/distance.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/field/wide.hpp"

namespace replan {
namespace {

/// Obstacles up to this far are found by scanning; a row with a cell farther from all gets the envelope.
constexpr int kScan = 48;
/// How many steps are scanned between two looks at whether they suffice, and after how many one is seen to be of no
/// use: where some cell still has nothing near, it seldom comes before kScan.
constexpr int kLook = 4, kHopeless = 8;

/// Whether scanning goes on after so many steps, if the largest value is still that.
bool worth_scanning(int done, std::int32_t largest) {
  return done < kScan && !(done >= kHopeless && largest > kScan * kScan);
}

// Down: cells above. A column distance is capped, so that its square stays below kNoObstacle.
REPLAN_WIDE void sweep_down(const std::uint8_t* blocked, const std::int32_t* above, std::int32_t* row,
                            int width, std::int32_t cap) {
  for (int x = 0; x < width; ++x) row[x] = blocked[x] != 0 ? 0 : std::min(above[x] + 1, cap);
}
REPLAN_WIDE void sweep_up(const std::int32_t* below, std::int32_t* row, int width) {
  for (int x = 0; x < width; ++x) row[x] = std::min(row[x], below[x] + 1);
}

REPLAN_WIDE void square(const std::int32_t* column, std::int32_t* parabola, int width, std::int32_t cap) {
  for (int x = 0; x < width; ++x) parabola[x] = column[x] >= cap ? kNoObstacle : column[x] * column[x];
}

/// row = min over |d| <= last of parabola(x + d) + d^2, for d from `first` on. The parabolas are padded on
/// both sides.
REPLAN_WIDE void scan(const std::int32_t* parabola, std::int32_t* row, int width, int first, int last) {
  for (int d = first; d <= last; ++d) {
    const std::int32_t squared = d * d;
    for (int x = 0; x < width; ++x)
      row[x] = std::min(row[x], std::min(parabola[x - d], parabola[x + d]) + squared);
  }
}
REPLAN_WIDE std::int32_t largest(const std::int32_t* row, int width) {
  std::int32_t most = 0;
  for (int x = 0; x < width; ++x) most = std::max(most, row[x]);
  return most;
}
REPLAN_WIDE std::int32_t smallest(const std::int32_t* row, int width) {
  std::int32_t least = kNoObstacle;
  for (int x = 0; x < width; ++x) least = std::min(least, row[x]);
  return least;
}

/// The envelope of the parabolas over one row.
class Envelope {
 public:
  explicit Envelope(int width)
      : site_(static_cast<std::size_t>(width)), from_(static_cast<std::size_t>(width)) {}

  void run(const std::int32_t* parabola, std::int32_t* row, int width) {
    int top = -1;
    for (int i = 0; i < width; ++i) {
      if (parabola[i] >= kNoObstacle) continue;
      while (top >= 0 && overtakes(parabola, at(site_, top), i) <= at(from_, top)) --top;
      const int from = top < 0 ? 0 : overtakes(parabola, at(site_, top), i);
      if (from >= width) continue;
      ++top;
      at(site_, top) = i;
      at(from_, top) = from;
    }
    for (int x = width - 1; x >= 0 && top >= 0; --x) {
      const int i = at(site_, top);
      row[x] = parabola[i] + (x - i) * (x - i);
      if (x == at(from_, top)) --top;
    }
  }

 private:
  static int& at(std::vector<int>& values, int index) { return values[static_cast<std::size_t>(index)]; }
  /// The first x from which on the parabola at j > i is not above the one at i.
  static int overtakes(const std::int32_t* parabola, int i, int j) {
    const std::int64_t numerator =
        std::int64_t{parabola[j]} + std::int64_t{j} * j - parabola[i] - std::int64_t{i} * i;
    const std::int64_t denominator = 2 * (j - i);
    const std::int64_t down = numerator / denominator;
    return static_cast<int>(std::max<std::int64_t>(0, down + (numerator % denominator > 0 ? 1 : 0)));
  }

  std::vector<int> site_, from_;
};

void row_pass(const std::int32_t* parabola, std::int32_t* row, int width, Envelope& envelope) {
  std::copy(parabola, parabola + width, row);
  if (smallest(row, width) == kNoObstacle) return;
  for (int done = 0;; done += kLook) {
    const std::int32_t most = largest(row, width);
    if (most <= (done + 1) * (done + 1)) return;
    if (!worth_scanning(done, most)) return envelope.run(parabola, row, width);
    scan(parabola, row, width, done + 1, done + kLook);
  }
}

/// Squared distances within one layer.
void layer_pass(int width, int height, const std::uint8_t* blocked, std::int32_t* distances) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  const std::int32_t cap = (1 << 14) + 1;
  const std::vector<std::int32_t> outside(w, cap);
  for (std::size_t y = 0; y < h; ++y)
    sweep_down(blocked + y * w, y == 0 ? outside.data() : &distances[(y - 1) * w], &distances[y * w], width,
               cap);
  for (std::size_t y = h - 1; y-- > 0;) sweep_up(&distances[(y + 1) * w], &distances[y * w], width);
  std::vector<std::int32_t> padded(w + 2 * kScan, kNoObstacle);
  Envelope envelope(width);
  for (std::size_t y = 0; y < h; ++y) {
    std::int32_t* row = &distances[y * w];
    square(row, padded.data() + kScan, width, cap);
    row_pass(padded.data() + kScan, row, width, envelope);
  }
}

REPLAN_WIDE void lower_to(const std::int32_t* parabola, std::int32_t* row, int width, std::int32_t squared) {
  for (int x = 0; x < width; ++x) row[x] = std::min(row[x], parabola[x] + squared);
}

/// The last axis: across the layers, for one y at a time, all x beside each other.
class DepthPass {
 public:
  DepthPass(int width, int height, int depth)
      : width_(width),
        height_(height),
        depth_(depth),
        parabolas_(static_cast<std::size_t>(width) * static_cast<std::size_t>(depth)),
        envelope_(depth),
        line_(static_cast<std::size_t>(depth)),
        result_(line_) {}

  void run(std::int32_t* distances, int y) {
    for (int z = 0; z < depth_; ++z) std::copy_n(row(distances, y, z), width_, parabola(z));
    for (int z = 0; z < depth_; ++z)
      if (!scan_rows(row(distances, y, z), z)) return envelop(distances, y);
  }

 private:
  [[nodiscard]] std::int32_t* row(std::int32_t* distances, int y, int z) const {
    return distances + (std::ptrdiff_t{z} * height_ + y) * width_;
  }
  [[nodiscard]] std::int32_t* parabola(int z) { return parabolas_.data() + std::ptrdiff_t{z} * width_; }

  /// False if some obstacle may be farther than is scanned.
  bool scan_rows(std::int32_t* row, int z) {
    for (int done = 0; z - done > 0 || z + done + 1 < depth_; ++done) {
      if (done % kLook == 0) {
        const std::int32_t most = largest(row, width_);
        if (most <= (done + 1) * (done + 1)) return true;
        if (!worth_scanning(done, most)) return false;
      }
      const int d = done + 1;
      if (z - d >= 0) lower_to(parabola(z - d), row, width_, d * d);
      if (z + d < depth_) lower_to(parabola(z + d), row, width_, d * d);
    }
    return true;
  }

  void envelop(std::int32_t* distances, int y) {
    for (int x = 0; x < width_; ++x) {
      for (int z = 0; z < depth_; ++z) line_[static_cast<std::size_t>(z)] = parabola(z)[x];
      result_ = line_;
      envelope_.run(line_.data(), result_.data(), depth_);
      for (int z = 0; z < depth_; ++z) row(distances, y, z)[x] = result_[static_cast<std::size_t>(z)];
    }
  }

  int width_, height_, depth_;
  std::vector<std::int32_t> parabolas_;
  Envelope envelope_;
  std::vector<std::int32_t> line_, result_;
};

}  // namespace

std::vector<std::int32_t> squared_distances(int width, int height, std::span<const std::uint8_t> blocked) {
  std::vector<std::int32_t> distances(blocked.size());
  layer_pass(width, height, blocked.data(), distances.data());
  return distances;
}

std::vector<std::int32_t> squared_distances(int width, int height, int depth,
                                            std::span<const std::uint8_t> blocked) {
  const auto layer = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<std::int32_t> distances(blocked.size());
  for (std::size_t z = 0; z < static_cast<std::size_t>(depth); ++z)
    layer_pass(width, height, blocked.data() + z * layer, &distances[z * layer]);
  if (depth == 1) return distances;
  DepthPass across(width, height, depth);
  for (int y = 0; y < height; ++y) across.run(distances.data(), y);
  return distances;
}

std::vector<Cost> chamfer_distances(int width, int height, std::span<const std::uint8_t> blocked) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  constexpr std::int64_t straight = kStepCost[1].raw, diagonal = kStepCost[2].raw;
  std::vector<Cost> result(w * h);
  // The row at hand and the one beside it, each with an infinitely far cell at both ends, so that the passes
  // need not ask where the map ends.
  std::vector<std::int64_t> first(w + 2, Cost::kInfinityRaw), second(first);
  std::int64_t *row = first.data() + 1, *beside = second.data() + 1;
  const auto from_beside = [&beside](std::size_t x) {
    return std::min(beside[x] + straight, std::min(beside[x - 1], beside[x + 1]) + diagonal);
  };
  for (std::size_t y = 0; y < h; ++y, std::swap(row, beside))
    for (std::size_t x = 0; x < w; ++x) {
      row[x] = blocked[y * w + x] != 0 ? 0 : std::min(from_beside(x), row[x - 1] + straight);
      result[y * w + x] = {row[x]};
    }
  std::fill(beside, beside + w, Cost::kInfinityRaw);
  for (std::size_t y = h; y-- > 0; std::swap(row, beside))
    for (std::size_t x = w; x-- > 0;) {
      row[x] = std::min(result[y * w + x].raw, std::min(from_beside(x), row[x + 1] + straight));
      result[y * w + x] = {std::min(row[x], Cost::kInfinityRaw)};
    }
  return result;
}

}  // namespace replan
