#include "core/debug/fitness_curve.hpp"

#include "core/debug/event_words.hpp"

namespace replan {

void FitnessCurve::follow(const LogView& view, std::uint64_t log_id, std::size_t most) {
  if (log_id != log_id_) *this = {};
  log_id_ = log_id;
  complete_ = true;
  if (!view.info.evolving) return;
  const Timeline& log = view.log;
  if (!values_) {
    const SearchState state = log.state_at(0);
    const auto from = [&](Scalar which) { return ScalarValues(state, which, 0); };
    values_ = Values{from(Scalar::generation), from(Scalar::leader_cost), from(Scalar::mean_cost),
                     from(Scalar::best)};
  }
  auto& [generation, fittest, mean, best] = *values_;
  for (; most > 0 && generation.changes_before(log, log.size()); --most) {
    // A planner tells the number of the generation last.
    const std::size_t event = generation.take(log);
    for (ScalarValues* each : {&fittest, &mean, &best}) each->take_before(log, event);
    if (generation.value() == 0) {  // for another goal
      before_ = points_.empty() ? 0 : points_.back().generation;
      continue;
    }
    points_.push_back({.event = event,
                       .generation = before_ + static_cast<std::int64_t>(generation.value()),
                       .fittest = {static_cast<std::int64_t>(fittest.value())},
                       .mean = {static_cast<std::int64_t>(mean.value())},
                       .free = best.value() != 0});
  }
  complete_ = !generation.changes_before(log, log.size());
}

std::string fitness_csv(std::span<const FitnessPoint> curve) {
  std::string text = "generation,best,mean,free\n";
  for (const FitnessPoint& point : curve)
    text += std::to_string(point.generation) + ',' + cost_text(point.fittest, 6) + ',' +
            cost_text(point.mean, 6) + (point.free ? ",1\n" : ",0\n");
  return text;
}

}  // namespace replan
