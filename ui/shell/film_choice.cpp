#include "ui/shell/film_choice.hpp"

#include "ui/shell/frame.hpp"

namespace replan::ui {
namespace {

/// From where to where, as moment_position() reads it.
FilmOptions options_of(const FilmChoice& choice, const Run& run) {
  FilmOptions options{.fps = choice.fps, .speed = choice.speed};
  if (choice.part != FilmPart::replan) return options;
  const std::optional<ReplanSpan> replan = last_replan(run);
  options.from = replan ? std::to_string(replan->begin) : "start";
  options.to = replan ? "replan:" + std::to_string(replan->number) : "plan";
  return options;
}

bool is_over(MissionState state) {
  return state != MissionState::planning && state != MissionState::driving;
}

}  // namespace

std::string part_words(FilmPart part, const Run& run) {
  if (part == FilmPart::whole) return "The whole run";
  if (part == FilmPart::live) return "What you do";
  const std::optional<ReplanSpan> replan = last_replan(run);
  return replan ? "Replan " + std::to_string(replan->number) : "The first plan";
}

Result<std::vector<FilmFrame>> film_frames(const FilmChoice& choice, const Run& run) {
  return plan_film(run, options_of(choice, run));
}

bool is_complete(FilmPart part, const Run& run) {
  if (run.busy()) return false;
  if (part == FilmPart::replan) return moment_position(run, options_of({.part = part}, run).to).ok();
  return !run.decisions().empty() && is_over(run.decisions().back().state);
}

}  // namespace replan::ui
