// What the editing actions do to what is selected.
#include "core/robots/drive_sense.hpp"
#include "ui/shell/actions.hpp"

namespace replan::ui {

void ActionContext::let_go() {
  if (ui::let_go(view)) return;
  const bool looked_at = looks_at_arc();
  view.view.motion.reset();
  if (!looked_at) view.view.pinned.reset();
}

/// Another planner's pane may lead by now, whose robot has no arcs.
bool ActionContext::looks_at_arc() const {
  const Run& lead = session.run();
  return view.view.motion && drives(lead.scenario(), lead.choice());
}

void ActionContext::delete_selected() {
  Editing& editing = view.editing;
  if (editing.mover) {
    push(RemoveMover{*editing.mover});
  } else if (editing.surprise) {
    push(RemoveSurprise{*editing.surprise});
  } else if (editing.region) {
    return clear_region();
  }
  editing.mover.reset();
  editing.surprise.reset();
}

void ActionContext::clear_region() {
  const CellBox& region = *view.editing.region;
  if (cell_count(region) > kLargeWorld) return push(PaintBoxes{{region}, false});
  std::vector<CellChange> cells;
  for (int z = region.low.z; z <= region.high.z; ++z)
    for (int y = region.low.y; y <= region.high.y; ++y)
      for (int x = region.low.x; x <= region.high.x; ++x)
        if (session.scenario().map.contains({x, y, z})) cells.push_back({{x, y, z}, false});
  push(PaintCells{std::move(cells), 0});
}

}  // namespace replan::ui
