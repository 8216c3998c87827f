#include "core/debug/path_gains.hpp"

#include "core/debug/scalar_values.hpp"

namespace replan {
std::vector<PathGain> path_gains(const LogView& view, std::size_t begin, std::size_t end) {
  std::vector<PathGain> gains;
  if (!view.info.sampling) return gains;
  const SearchState at_begin = view.log.state_at(begin);
  const auto follow = [&](Scalar which) { return ScalarValues(view.log, at_begin, which, begin); };
  // A planner tells the cost first, and then by which sample.
  ScalarValues best = follow(Scalar::best), sample = follow(Scalar::gain_sample),
               first = follow(Scalar::plan_sample);
  while (best.changes_before(end)) {
    PathGain gain{.event = best.take()};
    const std::size_t until = best.next_or(end);
    sample.take_before(until);
    first.take_before(until);
    gain.sample = static_cast<std::int64_t>(sample.value() - first.value());
    gain.cost = best.value() == 0 ? Cost::infinity() : Cost{static_cast<std::int64_t>(best.value())};
    gains.push_back(gain);
  }
  return gains;
}

}  // namespace replan
