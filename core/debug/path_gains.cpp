#include "core/debug/path_gains.hpp"

#include <optional>

namespace replan {
namespace {

/// The values that a scalar takes in a stretch of the log, one after the other.
class ScalarValues {
 public:
  ScalarValues(const Timeline& log, const SearchState& at_begin, Scalar which, std::size_t begin)
      : log_(log), which_(which), value_(at_begin.scalar(which)) {
    find(begin);
  }
  /// That of the latest change that was taken.
  [[nodiscard]] std::uint64_t value() const { return value_; }
  [[nodiscard]] bool changes_before(std::size_t end) const { return next_ && *next_ < end; }
  /// Takes the next change; its event.
  std::size_t take() {
    const std::size_t event = *next_;
    value_ ^= log_.event(event).delta;
    find(event + 1);
    return event;
  }
  void take_before(std::size_t end) {
    while (changes_before(end)) take();
  }
  [[nodiscard]] std::size_t next_or(std::size_t end) const { return changes_before(end) ? *next_ : end; }

 private:
  void find(std::size_t from) {
    next_ = log_.next_event(static_cast<NodeId>(which_), {EventKind::scalar}, from);
  }

  const Timeline& log_;
  Scalar which_;
  std::uint64_t value_;
  std::optional<std::size_t> next_;
};

}  // namespace

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
