// What floats over a pane: the planner and its figures, the last repair, and how things stand.
#pragma once

#include "core/scene/scene.hpp"
#include "core/session/fresh_plan.hpp"
#include "ui/canvas/canvas.hpp"
#include "ui/canvas/replan_card.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

/// Where the chips lie, and what a click on the card asked for.
struct ChipsDrawn {
  ScreenArea title, message;
  CardAnswer card = CardAnswer::none;
};

/// What a pane shows of its world.
struct ShownSlice {
  Sheet sheet;
  bool bar = false;     ///< the bar below the title tells it
  bool orbits = false;  ///< the world shows from outside
};

/// With `choosable` the planner's name has the sign of a menu. `scene` is what lies under them.
ChipsDrawn draw_chips(const Look& look, ImDrawList& list, const Run& run, const Scene& scene,
                      SceneMemory& memory, FreshPlans& plans, const ViewState& state, const ShownSlice& slice,
                      ImVec2 min, ImVec2 max, bool choosable, CardFold& fold);
/// The height at the top of a pane that its title takes, with the space around it.
float pane_title_height(const Look& look);

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
