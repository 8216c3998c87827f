// What floats over the canvas: the planner and its figures, the last repair, the legend, and how things
// stand.
#pragma once

#include "core/scene/scene.hpp"
#include "core/session/fresh_plan.hpp"
#include "ui/canvas.hpp"

namespace replan::ui {

void draw_chips(const Look& look, ImDrawList& list, const Run& run, const Scene& scene, SceneMemory& memory,
                FreshPlans& plans, const ViewState& state, ImVec2 min, ImVec2 max);

/// A sentence about the run at its cursor that a user should read now; empty if all is well.
struct StateMessage {
  std::string text;
  bool bad = false;  ///< something is wrong, rather than under way
};
StateMessage state_message(const Run& run, SceneMemory& memory);

/// 1391 as "1 391".
std::string grouped(std::int64_t number);

}  // namespace replan::ui
