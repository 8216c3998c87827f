// A run carried out once more, for the stretches of its log that were dropped.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/sim/mission.hpp"
#include "core/trace/timeline.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// Works out stretches of a run's log again. It stays where the last stretch ended, so that walking forwards
/// through the log just goes on; walking backwards starts from key frames.
class Reexecution {
 public:
  /// `planner` is an index into scenario->planners, `iterations` how far the planner goes at a time.
  Reexecution(std::shared_ptr<const Scenario> scenario, std::size_t planner, std::int64_t iterations)
      : scenario_(std::move(scenario)), planner_(planner), iterations_(iterations) {}

  /// The events [from, to) of the log: a Timeline::Source.
  [[nodiscard]] std::vector<Event> events(std::size_t position, const KeyFrame& frame, std::size_t from,
                                          std::size_t to);

 private:
  void drop(std::size_t count);
  void take_up(std::size_t position, const KeyFrame& frame);
  [[nodiscard]] std::size_t end() const { return begin_ + ahead_.size() - used_; }

  std::shared_ptr<const Scenario> scenario_;
  std::size_t planner_;
  std::int64_t iterations_;
  Recorder recorder_;
  std::unique_ptr<Mission> mission_;
  std::vector<Event> ahead_;  // worked out; from used_ on not yet asked for
  std::size_t used_ = 0;
  std::size_t begin_ = 0;  // where in the log that begins
};

}  // namespace replan
