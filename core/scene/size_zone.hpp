// Where the centre of a robot with a size cannot be, on its map at the cursor.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "core/lattice/inflation.hpp"
#include "core/scene/digest.hpp"

namespace replan {

/// Follows a run's cursor: only what changed on the way there is worked out again.
class SizeZone {
 public:
  /// The run's robot has a size.
  void follow(const Run& run, const RunDigest& digest);
  /// Nonzero: an obstacle, or too near one.
  [[nodiscard]] const std::vector<std::uint8_t>& cells() const { return cells_; }

 private:
  void begin(const Run& run);
  void turn(const Run& run, const RunDigest& digest);

  std::uint64_t log_id_ = 0;
  std::size_t position_ = 0;  // of the cursor
  std::variant<std::monostate, Inflation<2>, Inflation<3>> grown_;
  std::vector<std::uint8_t> cells_;
};

}  // namespace replan
