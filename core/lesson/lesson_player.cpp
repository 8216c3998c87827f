#include "core/lesson/lesson_player.hpp"

#include <algorithm>

#include "core/debug/probe.hpp"
#include "core/session/stepping.hpp"

namespace replan {

void LessonPlayer::note(std::string_view name) {
  std::erase(missing_, name);
}

/// The learner may have given the world another size: then no cell is what conditions take it for.
bool LessonPlayer::knows_world(const Run& run) const {
  return run.lattice() == lesson_.scenario.map.box();
}

/// Whether the step's condition, if it has one, holds there.
bool LessonPlayer::holds(const Run& run, std::size_t position) const {
  if (!step().until) return true;
  return knows_world(run) && Probe(run.log_view(), *step().until, position).value().truth;
}

bool LessonPlayer::look(const Session& session) {
  if (done_ || !missing_.empty() || !holds(session.run(), session.run().timeline().cursor())) return false;
  done_ = true;
  return true;
}

void LessonPlayer::begin(std::size_t number) {
  number_ = number;
  missing_ = step().given;
  done_ = false;
}

void LessonPlayer::go_on() {
  if (!at_last()) begin(number_ + 1);
}

void LessonPlayer::go_back() {
  if (number_ > 0) begin(number_ - 1);
}

/// Where the learner comes to by steps, if the condition that holds at `position` still does there: from the middle of
/// an expansion the next step would lead less far than the lesson says.
std::size_t LessonPlayer::stop_at(const Run& run, std::size_t position) const {
  const std::size_t stop = next_stop(run, position - 1, StepUnit::expansion);
  return holds(run, stop) ? stop : position;
}

Result<std::vector<Deed>> LessonPlayer::deeds(const Session& session) const {
  if (!step().deeds.empty()) return step().deeds;
  const Run& run = session.run();
  for (const std::size_t from : {run.timeline().cursor(), std::size_t{0}})
    if (knows_world(run))
      if (const auto stop = Probe(run.log_view(), *step().until, from).forwards(run.timeline().size()))
        return std::vector<Deed>{Command(Seek{stop_at(run, *stop)})};
  return Error{"The run as it is now never comes to that. Begin the lesson again to see it."};
}

}  // namespace replan
