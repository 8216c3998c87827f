// What floats over the canvas: the planner and its figures, the last repair, the legend, and how things
// stand.
#pragma once

#include "core/scene/scene.hpp"
#include "core/session/fresh_plan.hpp"
#include "ui/canvas/canvas.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

/// With `choosable` the planner's name has the sign of a menu. Returns the size of the chip in the upper left
/// corner, that name.
ImVec2 draw_chips(const Look& look, ImDrawList& list, const Run& run, const Scene& scene, SceneMemory& memory,
                  FreshPlans& plans, const ViewState& state, ImVec2 min, ImVec2 max, bool choosable);

/// All that the canvas can show, with the mark that the legend gives it.
std::vector<LegendEntry> all_signs(const Look& look);

/// A sentence about the run at its cursor that a user should read now; empty if all is well.
struct StateMessage {
  std::string text;
  bool bad = false;  ///< something is wrong, rather than under way
};
StateMessage state_message(const Run& run, SceneMemory& memory);

/// 1391 as "1 391".
std::string grouped(std::int64_t number);
/// "3 cells", "1 cell".
std::string count_text(std::int64_t count, const char* one, const char* many);

}  // namespace replan::ui
