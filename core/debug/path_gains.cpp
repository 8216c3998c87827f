#include "core/debug/path_gains.hpp"

namespace replan {

void PathGains::follow(const LogView& view, std::uint64_t log_id, std::size_t begin, std::size_t end,
                       std::size_t most) {
  if (log_id != log_id_ || begin != begin_ || end < end_) *this = {};
  log_id_ = log_id;
  begin_ = begin;
  end_ = end;
  complete_ = true;
  if (!view.info.sampling) return;
  if (!values_) {
    const SearchState state = view.log.state_at(begin);
    const auto from = [&](Scalar which) { return ScalarValues(state, which, begin); };
    values_ = Values{from(Scalar::best), from(Scalar::gain_sample), from(Scalar::plan_sample)};
  }
  settle(view.log);
  ScalarValues& best = values_->best;
  for (; most > 0 && best.changes_before(view.log, end); --most) {
    const std::size_t event = best.take(view.log);
    const Cost cost{static_cast<std::int64_t>(best.value())};
    gains_.push_back({.event = event, .cost = best.value() == 0 ? Cost::infinity() : cost});
    settle(view.log);
  }
  complete_ = !best.changes_before(view.log, end);
}

/// A planner tells the cost first, and then by which sample: the log may have grown by that since.
void PathGains::settle(const Timeline& log) {
  if (gains_.empty()) return;
  const std::size_t until = values_->best.next_or(log, end_);
  values_->sample.take_before(log, until);
  values_->first.take_before(log, until);
  gains_.back().sample = static_cast<std::int64_t>(values_->sample.value() - values_->first.value());
}

}  // namespace replan
