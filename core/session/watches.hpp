// Watches of a session: quantities followed over the whole run.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace replan {

/// A value from a position of the log on.
struct WatchPoint {
  std::size_t position = 0;
  double value = 0;  ///< infinity where there is none yet
};

/// Read by panels; changed by the session's commands and update() alone.
class Watches {
 public:
  /// The expressions, as typed (core/debug/condition.hpp).
  [[nodiscard]] std::span<const std::string> list() const { return list_; }
  /// The values of a watch over the log of a pane, ascending and thinned out to what a chart can show; as far
  /// as the log was looked through.
  [[nodiscard]] std::span<const WatchPoint> series(std::size_t pane, std::size_t watch) const;
  /// The value at the cursor of a pane; infinity if there is none.
  [[nodiscard]] double value(std::size_t pane, std::size_t watch) const;

 private:
  std::vector<std::string> list_;
};

}  // namespace replan
