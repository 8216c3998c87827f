// The card over the canvas after a replan: what made the robot plan again, and what the repair cost against
// a plan from scratch.
#pragma once

#include "core/scene/scene.hpp"
#include "core/session/fresh_plan.hpp"
#include "ui/look.hpp"

namespace replan::ui {

/// What a card tells. `fresh` comes later: it is worked out in the background.
struct ReplanReport {
  RepairFigures repair;
  std::optional<FreshPlan> fresh;
  bool times = true;  ///< off in pictures, which are to be the same each time
};

/// One sentence: "The robot saw 6 cells blocked and 2 free."
std::string cause_sentence(const ReplanCause& cause);

ImVec2 replan_card_size(const Look& look, const ReplanReport& report, bool brief);

/// Draws the card with its upper right corner at `pos`, or as one line if `brief`; under the mouse it is
/// whole. Returns its size as it takes part in the layout.
ImVec2 draw_replan_card(const Look& look, ImDrawList& list, ImVec2 pos, const ReplanReport& report,
                        bool brief);

}  // namespace replan::ui
