#include "core/session/history.hpp"

#include <algorithm>
#include <utility>

namespace replan {

void History::begin(std::size_t scripted, std::size_t unsaved) {
  done_.clear();
  undone_.clear();
  saved_at_ = 0;
  taken_up_ = unsaved;
  scripted_ = scripted;
}

bool History::add(const std::string& label, std::uint64_t stroke, DocumentChange change, std::size_t scripted,
                  RunPositions now) {
  Edit edit;
  edit.label = label;
  edit.stroke = stroke;
  edit.serial = ++serials_;
  edit.change = std::move(change);
  edit.scripted_before = std::exchange(scripted_, scripted);
  edit.scripted_after = scripted;
  edit.left = std::move(now);
  undone_.clear();
  if (goes_on(stroke) && !done_.back().change.replaces_map() && !edit.change.replaces_map()) {
    Edit& whole = done_.back();
    append(whole.change, std::move(edit.change));
    whole.serial = edit.serial;
    whole.scripted_after = edit.scripted_after;
    return false;
  }
  done_.push_back(std::move(edit));
  return true;
}

RunPositions History::undo(Scenario& scenario, RunPositions now) {
  Edit edit = std::move(done_.back());
  done_.pop_back();
  edit.undone = std::move(now);
  take_back(edit.change, scenario);
  scripted_ = edit.scripted_before;
  undone_.push_back(std::move(edit));
  return undone_.back().left;
}

RunPositions History::redo(Scenario& scenario, RunPositions now) {
  Edit edit = std::move(undone_.back());
  undone_.pop_back();
  edit.left = std::move(now);
  make_again(edit.change, scenario);
  scripted_ = edit.scripted_after;
  done_.push_back(std::move(edit));
  return done_.back().undone;
}

std::vector<std::string> History::labels() const {
  std::vector<std::string> labels;
  for (const Edit& edit : done_) labels.push_back(edit.label);
  for (auto edit = undone_.rbegin(); edit != undone_.rend(); ++edit) labels.push_back(edit->label);
  return labels;
}

std::uint64_t History::document_state() const {
  const auto last = std::find_if(done_.rbegin(), done_.rend(), [](const Edit& edit) { return edit.is_lost; });
  return last == done_.rend() ? 0 : last->serial;
}

std::size_t History::unsaved() const {
  if (!modified()) return 0;
  // What was saved and then taken back differs from the file just as what was done since.
  const auto after = [this](const Edit& edit) { return edit.is_lost && edit.serial > saved_at_; };
  const auto before = [this](const Edit& edit) { return edit.is_lost && edit.serial <= saved_at_; };
  const auto done = std::count_if(done_.begin(), done_.end(), after);
  const auto taken_back = saved_at_ == 0 ? 0 : std::count_if(undone_.begin(), undone_.end(), before);
  return std::max<std::size_t>(1, taken_up_ + static_cast<std::size_t>(done + taken_back));
}

void History::saved() {
  saved_at_ = document_state();
  taken_up_ = 0;
}

}  // namespace replan
