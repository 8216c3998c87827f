#include "core/field/distance.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/field/wide.hpp"

namespace replan {
namespace {

/// Obstacles up to this far are found by scanning; a row with a cell farther from all gets the envelope.
constexpr int kScan = 48;
/// How many steps are scanned between two looks at whether they suffice.
constexpr int kLook = 4;

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
  for (int done = 0; done < kScan; done += kLook) {
    if (largest(row, width) <= (done + 1) * (done + 1)) return;
    scan(parabola, row, width, done + 1, done + kLook);
  }
  if (largest(row, width) > (kScan + 1) * (kScan + 1)) envelope.run(parabola, row, width);
}

}  // namespace

std::vector<std::int32_t> squared_distances(int width, int height, std::span<const std::uint8_t> blocked) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  const std::int32_t cap = (1 << 14) + 1;
  std::vector<std::int32_t> distances(w * h);
  const std::vector<std::int32_t> outside(w, cap);
  for (std::size_t y = 0; y < h; ++y)
    sweep_down(blocked.data() + y * w, y == 0 ? outside.data() : &distances[(y - 1) * w], &distances[y * w],
               width, cap);
  for (std::size_t y = h - 1; y-- > 0;) sweep_up(&distances[(y + 1) * w], &distances[y * w], width);
  std::vector<std::int32_t> padded(w + 2 * kScan, kNoObstacle);
  Envelope envelope(width);
  for (std::size_t y = 0; y < h; ++y) {
    std::int32_t* row = &distances[y * w];
    square(row, padded.data() + kScan, width, cap);
    row_pass(padded.data() + kScan, row, width, envelope);
  }
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
