#include "ui/canvas/planner_menu.hpp"

#include <string>
#include <utility>

#include "core/world/choices.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

namespace {

/// Entries with equal ones stand together: planners, those that sample or breed, pilots, exercises.
int group_of(const PlannerInfo& info) {
  return info.exercise ? 3 : find_pilot(info.id) != nullptr ? 2 : info.can_miss() ? 1 : 0;
}

}  // namespace

void planner_items(const Look& look, const Session& session, std::size_t pane,
                   std::vector<Command>& commands) {
  int group = 0;
  for (const PlannerInfo& info : choices()) {
    if (std::exchange(group, group_of(info)) != group_of(info)) ImGui::Separator();
    const bool chosen = session.runs()[pane]->choice().id == info.id;
    if (menu_item(look, std::string(info.name).c_str(), {.on = chosen}))
      commands.emplace_back(ChoosePlanner{pane, std::string(info.id)});
    hint(look, {"", "", std::string(info.summary).c_str()});
  }
}

}  // namespace replan::ui
