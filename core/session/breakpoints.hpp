// Breakpoints of a session: conditions at which the playhead stops by itself.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace replan {

/// A place of the run that is worth stopping at, as a condition (core/debug/condition.hpp).
struct Breakpoint {
  std::string condition;
  bool enabled = true;
  friend bool operator==(const Breakpoint&, const Breakpoint&) = default;
};

/// A position of the leading run's log at which an enabled breakpoint stops.
struct Hit {
  std::size_t position = 0;
  std::size_t breakpoint = 0;  ///< index
};

/// A search for a breakpoint or a change that goes on over several updates.
struct Hunt {
  int direction = 1;     ///< 1 forwards, -1 backwards
  double fraction = -1;  ///< of the way; below 0: not known
};

/// Read by panels; changed by the session's commands and update() alone.
class Breakpoints {
 public:
  [[nodiscard]] std::span<const Breakpoint> list() const { return list_; }
  /// Where the leading run stops, as far as it was looked through; ascending.
  [[nodiscard]] std::span<const Hit> hits() const { return hits_; }
  /// Why the cursor stands where it does, as a sentence; empty unless it was stopped there.
  [[nodiscard]] const std::string& stopped() const { return stopped_; }
  /// The search that is under way.
  [[nodiscard]] const std::optional<Hunt>& hunt() const { return hunt_; }

 private:
  std::vector<Breakpoint> list_;
  std::vector<Hit> hits_;
  std::string stopped_;
  std::optional<Hunt> hunt_;
};

}  // namespace replan
