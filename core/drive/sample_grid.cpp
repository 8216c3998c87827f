#include "core/drive/sample_grid.hpp"

#include <algorithm>
#include <cmath>

namespace replan {
namespace {

/// Between `count` values that are spread evenly; as good as none where they are all the same.
double step_between(double low, double high, int count) {
  return count > 1 ? (high - low) / (count - 1) : 0;
}

/// How far a value lies from another, in steps.
double steps_from(double value, double other, double step) {
  constexpr double kSame = 1e-9;
  return std::abs(value - other) / std::max(step, kSame);
}

}  // namespace

SampleGrid::SampleGrid(const Explanation& why, const DriveSettings& settings)
    : rows(why.window.v_high > why.window.v_low ? settings.speeds : 1),
      columns(settings.turns),
      row_step(step_between(why.window.v_low, why.window.v_high, settings.speeds)),
      column_step(step_between(why.window.w_low, why.window.w_high, settings.turns)) {}

std::optional<std::size_t> SampleGrid::nearest(const Explanation& why, const Twist& motion) const {
  const Twist inside{std::clamp(motion.v, why.window.v_low, why.window.v_high),
                     std::clamp(motion.w, why.window.w_low, why.window.w_high)};
  constexpr double kMost = 0.5 + 1e-6;
  if (steps_from(motion.v, inside.v, row_step) > kMost || steps_from(motion.w, inside.w, column_step) > kMost)
    return std::nullopt;
  std::optional<std::size_t> best;
  double least = 0;
  for (std::size_t i = 0; i < sample(rows, 0); ++i) {
    const Twist& each = why.samples[i].motion;
    const double far =
        std::hypot(steps_from(each.v, motion.v, row_step), steps_from(each.w, motion.w, column_step));
    if (best && far >= least) continue;
    best = i;
    least = far;
  }
  return best;
}

}  // namespace replan
