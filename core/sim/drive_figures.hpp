// What the way of a robot on wheels was like, beside its length.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/drive/motion.hpp"

namespace replan {

/// Sums over the whole way so far; all zero for a robot that goes from cell to cell.
struct DriveFigures {
  double way = 0;            ///< m, of its centre
  double time = 0;           ///< s under way: turning on the spot counted, waiting not
  double turned = 0;         ///< rad, all changes of its heading, to either side
  double bent = 0;           ///< rad, of those that it made while it drove forwards
  double top_speed = 0;      ///< m/s
  double off_plan = 0;       ///< m^2, its distance to the first plan's path summed along its way
  double most_off_plan = 0;  ///< m

  /// It has kept that motion for so many seconds, and is now so far from the first plan's path, in metres.
  void add(const Twist& motion, double seconds, double away) {
    const double driven = motion.v * seconds, angle = std::abs(motion.w) * seconds;
    way += driven;
    time += seconds;
    turned += angle;
    if (motion.v > 0) bent += angle;
    top_speed = std::max(top_speed, motion.v);
    off_plan += away * driven;
    most_off_plan = std::max(most_off_plan, away);
  }

  friend bool operator==(const DriveFigures&, const DriveFigures&) = default;

  // Means along the way; 0 where there was none.
  [[nodiscard]] double mean_speed() const { return time > 0 ? way / time : 0; }  ///< m/s
  [[nodiscard]] double mean_curvature() const { return along(bent); }            ///< 1/m, its absolute value
  [[nodiscard]] double mean_off_plan() const { return along(off_plan); }         ///< m

 private:
  [[nodiscard]] double along(double sum) const { return way > 0 ? sum / way : 0; }
};

}  // namespace replan
