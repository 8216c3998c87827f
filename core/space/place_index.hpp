// Finds the place nearest to another one, and those within a distance: places in the boxes of a grid that grows finer
// with their number, so that a box holds a few of them however many there are.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/space/place.hpp"

namespace replan {

/// Numbers of places that its owner holds, which each call is told of. What it finds depends on the places alone, not on
/// the order in which they came.
template <int D>
class PlaceIndex {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// For a world of that many units along each axis; nothing is in it.
  explicit PlaceIndex(const Place& extent) : extent_(extent) { clear(); }

  void clear() {
    count_ = 0;
    shift_ = kCoarsest;
    lay_out();
  }
  [[nodiscard]] std::size_t size() const { return count_; }
  void insert(std::span<const Place> places, std::uint32_t number) {
    boxes_[box_of(places[number])].push_back(number);
    if (++count_ > kPerBox * boxes_.size()) refine(places);
  }
  void remove(std::span<const Place> places, std::uint32_t number) {
    std::vector<std::uint32_t>& box = boxes_[box_of(places[number])];
    box.erase(std::find(box.begin(), box.end(), number));
    --count_;
  }

  /// The nearest, of equally near ones the least number; kNone if there are none.
  [[nodiscard]] std::uint32_t nearest(std::span<const Place> places, const Place& at) const {
    std::uint32_t best = kNone;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    const Box3 home = coordinates(at);
    for (std::int64_t ring = 0; count_ > 0 && ring <= longest(); ++ring) {
      // What lies beyond `ring` boxes is at least so far away.
      const std::int64_t gap = std::max<std::int64_t>(0, ring - 1) << shift_;
      if (best != kNone && gap * gap > least) break;
      each_box_at(home, ring, [&](const std::vector<std::uint32_t>& box) {
        for (const std::uint32_t number : box) {
          const std::int64_t squared = squared_between(places[number], at);
          if (squared > least || (squared == least && number > best)) continue;
          least = squared;
          best = number;
        }
      });
    }
    return best;
  }

  /// Calls visit(number) for each no farther than `reach` units away, in the order of the boxes: sort what must not
  /// depend on it.
  template <class Visit>
  void each_within(std::span<const Place> places, const Place& at, std::int64_t reach, Visit&& visit) const {
    Place low = at, high = at;
    for (std::size_t i = 0; i < D; ++i) {
      low[i] = std::max<std::int64_t>(0, at[i] - reach);
      high[i] = std::min(extent_[i] - 1, at[i] + reach);
    }
    const Box3 from = coordinates(low), to = coordinates(high);
    for (std::int64_t z = from[2]; z <= to[2]; ++z)
      for (std::int64_t y = from[1]; y <= to[1]; ++y)
        for (std::int64_t x = from[0]; x <= to[0]; ++x)
          for (const std::uint32_t number : boxes_[place_of(x, y, z)])
            if (squared_between(places[number], at) <= reach * reach) visit(number);
  }

  [[nodiscard]] std::size_t memory_bytes() const {
    std::size_t bytes = boxes_.capacity() * sizeof boxes_[0];
    for (const auto& box : boxes_) bytes += box.capacity() * sizeof(std::uint32_t);
    return bytes;
  }

 private:
  using Box3 = std::array<std::int64_t, 3>;
  static constexpr int kCoarsest = 40;       // one box holds any world
  static constexpr std::size_t kPerBox = 4;  // on average, where they lie evenly

  [[nodiscard]] Box3 coordinates(const Place& place) const {
    Box3 at{};
    for (std::size_t i = 0; i < D; ++i) at[i] = place[i] >> shift_;
    return at;
  }
  [[nodiscard]] std::size_t place_of(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::size_t>((z * sides_[1] + y) * sides_[0] + x);
  }
  [[nodiscard]] std::size_t box_of(const Place& place) const {
    const Box3 at = coordinates(place);
    return place_of(at[0], at[1], at[2]);
  }
  [[nodiscard]] std::int64_t longest() const { return *std::max_element(sides_.begin(), sides_.end()); }

  void lay_out() {
    std::size_t boxes = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      sides_[i] = i < D ? ((extent_[i] - 1) >> shift_) + 1 : 1;
      boxes *= static_cast<std::size_t>(sides_[i]);
    }
    boxes_.assign(boxes, {});
  }
  void refine(std::span<const Place> places) {
    const auto coarse = std::move(boxes_);
    do {
      --shift_;
      lay_out();
    } while (count_ > kPerBox * boxes_.size() && shift_ > 0);
    for (const auto& box : coarse)
      for (const std::uint32_t number : box) boxes_[box_of(places[number])].push_back(number);
  }
  /// The boxes whose largest distance along an axis is `ring`.
  template <class Visit>
  void each_box_at(const Box3& home, std::int64_t ring, Visit&& visit) const {
    Box3 low{}, high{};
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::max<std::int64_t>(0, home[i] - ring);
      high[i] = std::min(sides_[i] - 1, home[i] + ring);
    }
    const auto on_rim = [&](std::int64_t at, std::size_t i) {
      return at == home[i] - ring || at == home[i] + ring;
    };
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        if (on_rim(z, 2) || on_rim(y, 1)) {
          for (std::int64_t x = low[0]; x <= high[0]; ++x) visit(boxes_[place_of(x, y, z)]);
          continue;
        }
        if (home[0] - ring >= 0) visit(boxes_[place_of(home[0] - ring, y, z)]);
        if (ring > 0 && home[0] + ring < sides_[0]) visit(boxes_[place_of(home[0] + ring, y, z)]);
      }
  }

  Place extent_;
  int shift_ = kCoarsest;  // a box is 2^shift_ units wide
  Box3 sides_{1, 1, 1};
  std::size_t count_ = 0;
  std::vector<std::vector<std::uint32_t>> boxes_;
};

}  // namespace replan
