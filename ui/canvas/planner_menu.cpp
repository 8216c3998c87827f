#include "ui/canvas/planner_menu.hpp"

#include <string>
#include <utility>

#include "core/world/choices.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

void planner_items(const Look& look, const Session& session, std::size_t pane,
                   std::vector<Command>& commands) {
  bool exercises = false;
  for (const PlannerInfo& info : choices()) {
    if (info.exercise && !std::exchange(exercises, true)) ImGui::Separator();
    const bool chosen = session.runs()[pane]->choice().id == info.id;
    if (menu_item(look, std::string(info.name).c_str(), {.on = chosen}))
      commands.emplace_back(ChoosePlanner{pane, std::string(info.id)});
    hint(look, {"", "", std::string(info.summary).c_str()});
  }
}

}  // namespace replan::ui
