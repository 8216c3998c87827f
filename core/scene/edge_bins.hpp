// Where in the world the edges of a large tree lie, so that who looks at a part of it reads no more than what is there: kept
// up to date from the log.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/scene/stale_stretches.hpp"
#include "core/session/run.hpp"

namespace replan {

/// The world is cut into bins. An edge is the way from a vertex to what it hangs on; it belongs to its vertex, and is in the
/// bin of that, or among the long ones if it may leave the bins around that one.
class EdgeBins {
 public:
  /// Whether the box between two opposite corners, in the world's coordinates, is seen.
  using Seen = std::function<bool(const Point& low, const Point& high)>;

  /// Brings them to the run's cursor. Only stretches of vertices of which the log tells that they were written are looked at.
  void follow(const Run& run);
  /// The vertices, ascending, whose edges may be seen: all that are, and some around them. Nothing if there are more than `most`.
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> seen(std::size_t most, const Seen& seen) const;
  /// The cost of the dearest vertex that hangs on another one.
  [[nodiscard]] Cost dearest() const;
  /// How many stretches were looked at, all times together.
  [[nodiscard]] std::size_t scanned() const { return scanned_; }

 private:
  static constexpr std::size_t kStretch = 128 * SearchState::kPage;
  static constexpr std::uint32_t kNowhere = UINT32_MAX;

  void begin(const Box& world);
  void scan(const SearchState& state, std::size_t stretch, std::size_t first, std::size_t end);
  void put(std::uint32_t vertex, std::uint32_t bin);
  [[nodiscard]] std::uint32_t bin_for(const Point& from, const Point& to) const;
  [[nodiscard]] std::uint32_t long_ones() const { return static_cast<std::uint32_t>(bins_.size() - 1); }

  StaleStretches stale_{kStretch};
  std::size_t scanned_ = 0;
  bool solid_ = false;
  double side_ = 1;                               // of a bin, in cells
  std::array<std::uint32_t, 3> across_{1, 1, 1};  // bins along each axis
  std::vector<std::vector<std::uint32_t>>
      bins_;                           // x runs fastest, then y, then z; the last one has the long ones
  std::vector<std::uint32_t> bin_of_;  // of each vertex; kNowhere: it has no edge
  std::vector<Cost> dearest_;          // of each stretch
};

}  // namespace replan
