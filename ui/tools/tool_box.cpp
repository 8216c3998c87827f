#include "ui/tools/tool_box.hpp"

#include <algorithm>

#include "ui/canvas/view_state.hpp"

namespace replan::ui {

#define REPLAN_TOOL(ID) ToolKind ID##_tool();
#define REPLAN_ACTION(ID, ...)
#include "ui/tools/tools.def"
#undef REPLAN_ACTION
#undef REPLAN_TOOL

std::span<const ToolKind> tool_kinds() {
  static const std::vector<ToolKind> kKinds = {
#define REPLAN_TOOL(ID) named(ID##_tool(), #ID),
#define REPLAN_ACTION(ID, ...)
#include "ui/tools/tools.def"
#undef REPLAN_ACTION
#undef REPLAN_TOOL
  };
  return kKinds;
}

ToolBox::ToolBox() {
  for (const ToolKind& kind : tool_kinds()) {
    if (kind.at_first) chosen_ = tools_.size();
    tools_.push_back(kind.make());
  }
}

void choose_tool(ViewState& view, std::string_view id) {
  const auto kinds = tool_kinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [id](const ToolKind& kind) { return kind.id == id; });
  if (found == kinds.end()) return;
  ToolBox& tools = view.tools;
  const auto wanted = static_cast<std::size_t>(found - kinds.begin());
  if (wanted != tools.chosen_) tools.chosen().leave(view);
  tools.chosen_ = wanted;
  tools.chosen().choose(view);
}

void put_tool_away(ViewState& view) {
  for (const ToolKind& kind : tool_kinds())
    if (kind.at_first) choose_tool(view, kind.id);
}

bool let_go(ViewState& view) {
  Editing& editing = view.editing;
  if (Tool& tool = view.tools.chosen(); tool.holds()) return tool.drop(), true;
  if (editing.mover || editing.surprise) return editing.mover.reset(), editing.surprise.reset(), true;
  if (editing.region) return editing.region.reset(), true;
  return false;
}

bool holds_something(const ViewState& view) {
  const Editing& editing = view.editing;
  return view.tools.chosen().holds() || editing.mover || editing.surprise || editing.region;
}

}  // namespace replan::ui
