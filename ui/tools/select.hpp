// The tool that changes nothing: it pins cells, and selects regions and what is to come.
#pragma once

#include "ui/canvas/editing.hpp"

namespace replan::ui {

struct ViewState;

/// Takes the tool and selects cells, and nothing else.
void select_with_tool(ViewState& view, const CellBox& region);

}  // namespace replan::ui
