// The list of all that can drive a pane, in the title of the pane and in the Planner menu.
#pragma once

#include <cstddef>
#include <vector>

#include "core/session/session.hpp"
#include "ui/look.hpp"

namespace replan::ui {

/// Its lines in the menu that is open; a click chooses for that pane.
void planner_items(const Look& look, const Session& session, std::size_t pane,
                   std::vector<Command>& commands);

}  // namespace replan::ui
