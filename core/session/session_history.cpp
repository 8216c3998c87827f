// The session's history: how edits are taken back and brought back.
#include <algorithm>

#include "core/session/session.hpp"

namespace replan {

Session::Moment Session::moment() const {
  Moment now;
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
void Session::return_to(Moment moment) {
  if (moment.lengths.size() != runs_.size()) return;  // there were more or fewer panes
  for (std::size_t i = 0; i < runs_.size(); ++i)
    if (runs_[i]->timeline().size() < moment.lengths[i]) runs_[i]->go(Target::length_of(moment.lengths[i]));
  returning_ = std::move(moment);
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

/// Takes back the last edit; it can be made again afterwards, and then leads to the moment `now`.
void Session::undo_edit(Scenario& scenario, Moment now) {
  Edit edit = std::move(undo_.back());
  undo_.pop_back();
  edit.undone = std::move(now);
  take_back(edit.change, scenario);
  scripted_ = edit.scripted_before;
  redo_.push_back(std::move(edit));
}

void Session::redo_edit(Scenario& scenario, Moment now) {
  Edit edit = std::move(redo_.back());
  redo_.pop_back();
  edit.left = std::move(now);
  make_again(edit.change, scenario);
  scripted_ = edit.scripted_after;
  undo_.push_back(std::move(edit));
}

Result<void> Session::run_command(const Undo&) {
  if (undo_.empty()) return Error{"there is nothing to undo"};
  say("undo: " + undo_.back().label);
  Scenario before = *scenario_;
  undo_edit(before, moment());
  replace(std::make_shared<const Scenario>(std::move(before)));
  return_to(redo_.back().left);
  return {};
}

Result<void> Session::run_command(const Redo&) {
  if (redo_.empty()) return Error{"there is nothing to redo"};
  say("redo: " + redo_.back().label);
  Scenario after = *scenario_;
  redo_edit(after, moment());
  replace(std::make_shared<const Scenario>(std::move(after)));
  return_to(undo_.back().undone);
  return {};
}

Result<void> Session::run_command(const GoToHistory& command) {
  if (command.position > undo_.size() + redo_.size()) return Error{"the history has no such edit"};
  if (command.position == undo_.size()) return {};
  const bool back = command.position < undo_.size();
  Scenario there = *scenario_;
  // On the way each edit leads to the moment at which it was left when it was there last.
  Moment now = moment();
  while (undo_.size() > command.position) {
    undo_edit(there, std::move(now));
    now = redo_.back().left;
  }
  while (undo_.size() < command.position) {
    redo_edit(there, std::move(now));
    now = undo_.back().undone;
  }
  say(undo_.empty() ? "back to the beginning" : (back ? "back to: " : "on to: ") + undo_.back().label);
  replace(std::make_shared<const Scenario>(std::move(there)));
  return_to(std::move(now));
  return {};
}

std::vector<std::string> Session::history() const {
  std::vector<std::string> labels;
  for (const Edit& edit : undo_) labels.push_back(edit.label);
  for (auto edit = redo_.rbegin(); edit != redo_.rend(); ++edit) labels.push_back(edit->label);
  return labels;
}

}  // namespace replan
