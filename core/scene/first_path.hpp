// The first path of a plan by samples, kept to be drawn beside the one that it has become.
#pragma once

#include <cstdint>
#include <vector>

#include "core/debug/path_gains.hpp"
#include "core/scene/digest.hpp"

namespace replan {

class FirstPath {
 public:
  /// Reads it out of the log of a run for the plan that the cursor stands in, or stands behind.
  void follow(const Run& run, const RunDigest& digest);

  /// Its points from the goal to the start, in the world's coordinates; none before there is a path, and none while it is
  /// the best one still.
  [[nodiscard]] const std::vector<Point>& points() const { return shown_ ? points_ : none_; }
  [[nodiscard]] Cost cost() const { return cost_; }

 private:
  void read(const Run& run, const PlanSpan& plan);

  std::uint64_t log_id_ = 0;
  std::size_t begin_ = SIZE_MAX;  // of the plan
  std::size_t event_ = SIZE_MAX;  // at which it was there
  PathGains gains_;               // of the plan, as far as its first path
  std::vector<Point> points_, none_;
  Cost cost_;
  bool shown_ = false;
};

}  // namespace replan
