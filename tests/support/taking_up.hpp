// A mission that is stopped somewhere and taken up by another one goes on as if it had never stopped.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/random.hpp"
#include "core/sim/mission.hpp"
#include "core/trace/search_state.hpp"

namespace replan::test {

inline std::vector<Event> driven_on(Mission& mission, Recorder& recorder) {
  for (int slices = 0; mission.advance(64) && slices < 300'000; ++slices) {
  }
  return recorder.take();
}

/// Stops somewhere in a mission whose whole log is that one, and goes on with another mission from there. What went
/// wrong, or nothing.
inline std::string taken_up(Random& random, const Scenario& scenario, const std::vector<Event>& whole) {
  Recorder first, second;
  const PlannerChoice& choice = scenario.planners.front();
  const auto mission = make_mission(scenario, choice, &first);
  for (int slices = random.between(1, 60); slices > 0 && mission->advance(64); --slices) {
  }
  const std::vector<Event> before = first.take();
  if (before.size() > whole.size() || !std::equal(before.begin(), before.end(), whole.begin()))
    return "the second time it is another log";
  SearchState state = initial_state(scenario, choice);
  for (const Event& event : before) state.apply(event);
  const auto again = make_mission(scenario, choice, &second);
  again->restore(mission->checkpoint(), state);
  second.line(first.current_line());
  const std::vector<Event> rest = driven_on(*again, second);
  return std::equal(rest.begin(), rest.end(), whole.begin() + static_cast<std::ptrdiff_t>(before.size()),
                    whole.end())
             ? ""
             : "it goes on otherwise from event " + std::to_string(before.size());
}

}  // namespace replan::test
