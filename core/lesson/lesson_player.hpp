// A lesson under way: at which step the learner is, and whether it is done.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/lesson/lesson.hpp"
#include "core/session/session.hpp"

namespace replan {

/// Watches a session and what is given to it; changes nothing. What it says depends on no more than what it was told.
class LessonPlayer {
 public:
  explicit LessonPlayer(Lesson lesson) : lesson_(std::move(lesson)) {}

  [[nodiscard]] const Lesson& lesson() const { return lesson_; }
  [[nodiscard]] const LessonStep& step() const { return lesson_.steps[number_]; }
  /// Of the step, from 0.
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] bool at_last() const { return number_ + 1 == lesson_.steps.size(); }
  /// What the step asks for has been done since it began; it stays so.
  [[nodiscard]] bool done() const { return done_; }

  /// The learner has given a command or an action of that name.
  void note(std::string_view name);
  /// Looks whether the step is done now. True if that has just come about.
  bool look(const Session& session);
  /// To the next step or the one before, if there is one.
  void go_on();
  void go_back();

  /// What does the step for the learner; an error if the run as it is now never comes to what is asked for.
  [[nodiscard]] Result<std::vector<Deed>> deeds(const Session& session) const;

 private:
  void begin(std::size_t number);
  [[nodiscard]] bool knows_world(const Run& run) const;
  [[nodiscard]] bool holds(const Run& run, std::size_t position) const;
  [[nodiscard]] std::size_t stop_at(const Run& run, std::size_t position) const;

  Lesson lesson_;
  std::size_t number_ = 0;
  std::vector<std::string> missing_ = step().given;  // of the step's, not given yet
  bool done_ = false;
};

}  // namespace replan
