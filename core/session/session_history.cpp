// The session's history: how edits are taken back and brought back.
#include <algorithm>

#include "core/session/session.hpp"

namespace replan {

RunPositions Session::positions() const {
  RunPositions now;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const Timeline& log = runs_[i]->timeline();
    // On the way back to a moment the runs are not yet what they are going to be.
    now.lengths.push_back(returning_ ? returning_->lengths[i] : log.size());
    now.cursors.push_back(returning_ ? returning_->cursors[i] : log.cursor());
  }
  now.follow = returning_ ? returning_->follow : follow_;
  return now;
}

/// The runs are carried out again until they are as long as they were.
void Session::return_to(RunPositions positions) {
  if (positions.lengths.size() != runs_.size()) return;  // there were more or fewer panes
  for (std::size_t i = 0; i < runs_.size(); ++i)
    if (runs_[i]->timeline().size() < positions.lengths[i])
      runs_[i]->go(Target::length_of(positions.lengths[i]));
  returning_ = std::move(positions);
  stepping_.reset();
  catching_up_ = false;
  arrive();
}

/// Puts the cursors where they were as soon as the runs have come that far. True if one has moved.
bool Session::arrive() {
  if (!returning_) return false;
  bool there = true, moved = false, longer = false;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (runs_[i]->rebasing()) {
      there = false;
      continue;
    }
    Timeline& log = runs_[i]->timeline();
    const std::size_t cursor = std::min(returning_->cursors[i], log.size());
    if (log.cursor() != cursor) {
      log.seek(cursor);
      moved = true;
    }
    if (log.size() < returning_->lengths[i] && runs_[i]->busy()) there = false;
    // An edit that made no difference: the run has gone on since.
    if (log.size() > returning_->lengths[i]) longer = true;
  }
  follow_ = returning_->follow && !longer;
  if (there) returning_.reset();
  return moved;
}

Result<void> Session::run_command(const Undo&) {
  if (history_.position() == 0) return Error{"there is nothing to undo"};
  say("undo: " + history_.undo_text());
  Scenario before = *scenario_;
  RunPositions there = history_.undo(before, positions());
  replace(std::make_shared<const Scenario>(std::move(before)));
  return_to(std::move(there));
  return {};
}

Result<void> Session::run_command(const Redo&) {
  if (history_.position() == history_.size()) return Error{"there is nothing to redo"};
  say("redo: " + history_.redo_text());
  Scenario after = *scenario_;
  RunPositions there = history_.redo(after, positions());
  replace(std::make_shared<const Scenario>(std::move(after)));
  return_to(std::move(there));
  return {};
}

Result<void> Session::run_command(const GoToHistory& command) {
  if (command.position > history_.size()) return Error{"the history has no such edit"};
  if (command.position == history_.position()) return {};
  const bool back = command.position < history_.position();
  Scenario there = *scenario_;
  // On the way each edit leads to where the runs stood when it was left last.
  RunPositions now = positions();
  while (history_.position() > command.position) now = history_.undo(there, std::move(now));
  while (history_.position() < command.position) now = history_.redo(there, std::move(now));
  say(command.position == 0 ? "back to the beginning"
                            : (back ? "back to: " : "on to: ") + history_.undo_text());
  replace(std::make_shared<const Scenario>(std::move(there)));
  return_to(std::move(now));
  return {};
}

}  // namespace replan
