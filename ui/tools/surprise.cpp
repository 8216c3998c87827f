// The tool for surprises: drops them now, lets them wait, and selects those that do.
#include "core/scene/script.hpp"
#include "ui/canvas/hand.hpp"

namespace replan::ui {

std::optional<std::size_t> surprise_at(const Run& run, Cell cell) {
  const Surprises& all = run.scenario().surprises;
  for (std::size_t i = all.size(); i-- > 0;) {
    if (!is_to_come(run, i)) continue;
    for (const CellChange& change : all[i].cells)
      if (change.cell == cell) return i;
  }
  return std::nullopt;
}

/// A click on one that waits selects it, or lets go of it.
void Hand::drop_surprise(const Session& session, const Run& run, ViewState& state,
                         std::vector<Command>& commands) {
  if (const auto there = surprise_at(run, first_); there && !moved_) {
    const bool again = state.editing.surprise == there;
    state.editing.surprise = again ? std::nullopt : there;
    return;
  }
  DropSurprise drop{{}, stroke_};
  write(run, preview(state, std::nullopt), drop.cells);
  if (drop.cells.empty()) return;
  const Editing& editing = state.editing;
  Surprise later;
  switch (editing.surprise_time) {
    case SurpriseTime::now:
      commands.emplace_back(std::move(drop));
      return;
    case SurpriseTime::step:
      later.at.move = editing.surprise_step;
      break;
    case SurpriseTime::near:
      later.at.near = Cell{(first_.x + last_.x) / 2, (first_.y + last_.y) / 2};
      later.at.within = editing.surprise_within;
      break;
  }
  later.cells = std::move(drop.cells);
  state.editing.mover.reset();
  state.editing.surprise = session.scenario().surprises.size();
  commands.emplace_back(ScheduleSurprise{std::move(later)});
}

}  // namespace replan::ui
