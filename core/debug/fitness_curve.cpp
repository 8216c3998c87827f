#include "core/debug/fitness_curve.hpp"

#include "core/debug/event_words.hpp"
#include "core/debug/scalar_values.hpp"

namespace replan {

std::vector<FitnessPoint> fitness_curve(const LogView& view, std::size_t begin, std::size_t end) {
  std::vector<FitnessPoint> curve;
  if (!view.info.evolving) return curve;
  const SearchState at_begin = view.log.state_at(begin);
  const auto follow = [&](Scalar which) { return ScalarValues(view.log, at_begin, which, begin); };
  // A planner tells the number of the generation last.
  ScalarValues generation = follow(Scalar::generation), fittest = follow(Scalar::leader_cost),
               mean = follow(Scalar::mean_cost), best = follow(Scalar::best);
  while (generation.changes_before(end)) {
    const std::size_t event = generation.take();
    for (ScalarValues* each : {&fittest, &mean, &best}) each->take_before(event);
    if (generation.value() == 0) continue;  // a first plan begins anew
    curve.push_back({.event = event,
                     .generation = static_cast<std::int64_t>(generation.value()),
                     .fittest = {static_cast<std::int64_t>(fittest.value())},
                     .mean = {static_cast<std::int64_t>(mean.value())},
                     .free = best.value() != 0});
  }
  return curve;
}

std::string fitness_csv(std::span<const FitnessPoint> curve) {
  std::string text = "generation,best,mean,free\n";
  for (const FitnessPoint& point : curve)
    text += std::to_string(point.generation) + ',' + cost_text(point.fittest, 6) + ',' +
            cost_text(point.mean, 6) + (point.free ? ",1\n" : ",0\n");
  return text;
}

}  // namespace replan
