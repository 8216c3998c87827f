// The side panel: tabs, and below them which planner of several they are about.
#include <algorithm>
#include <array>

#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// Several planners run side by side: whose values shall the tabs show?
void choose_pane(Frame& frame) {
  const Look& look = frame.look;
  const auto runs = frame.session.runs();
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = (ImGui::GetContentRegionAvail().x) / static_cast<float>(runs.size());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(origin, {origin.x + width * static_cast<float>(runs.size()), origin.y + look.px.control},
                     look.theme.raised, look.px.radius);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const ImVec2 min(origin.x + width * static_cast<float>(i), origin.y),
        max(min.x + width, origin.y + look.px.control);
    ImGui::SetCursorScreenPos(min);
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::InvisibleButton("pane", {width, look.px.control})) frame.commands.push_back(Lead{i});
    const bool chosen = i == frame.session.lead(), hovered = ImGui::IsItemHovered();
    hint(look, {"Pane", "",
                "Whose values the tabs show and whose timeline is below the canvas; the others follow it."});
    ImGui::PopID();
    if (chosen) list.AddRectFilled(min, max, look.theme.selected, look.px.radius);
    const std::string name = elide(look.fonts.ui, runs[i]->info().name, width - look.px.l);
    draw_text_centred(list, look.fonts.ui, min, max, chosen || hovered ? look.theme.text : look.theme.dim,
                      name);
  }
  ImGui::SetCursorScreenPos({origin.x, origin.y + look.px.control + look.px.m});
}

struct SideTab {
  const char* name;
  ActionId action;  // that shows it
};
// By the numbers kPlannerTab and so on.
constexpr std::array<SideTab, 7> kTabs = {{{"Planner", ActionId::show_planner},
                                           {"Cell", ActionId::show_cell},
                                           {"Open list", ActionId::show_open_list},
                                           {"Code", ActionId::show_code},
                                           {"Figures", ActionId::show_figures},
                                           {"Debug", ActionId::show_debug},
                                           {"Log", ActionId::show_log}}};

void choose_tab(Frame& frame) {
  std::array<Tab, kTabs.size()> all{};
  std::transform(kTabs.begin(), kTabs.end(), all.begin(), [](const SideTab& tab) {
    return Tab{tab.name, action(tab.action).hint()};
  });
  tabs(frame.look, "tabs", all, frame.view.tab);
}

}  // namespace

void draw_side(Frame& frame) {
  const Look& look = frame.look;
  // A row of the last frame that stood for a cell; the one under the mouse now says so again.
  std::optional<Cell>& pointed = frame.panels.debugger.pointed;
  if (pointed && frame.view.view.hovered == pointed) frame.view.view.hovered.reset();
  pointed.reset();
  frame.view.tab = std::clamp(frame.view.tab, 0, static_cast<int>(kTabs.size()) - 1);
  choose_tab(frame);
  edge(look, Edge::left);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px.l, look.px.m));
  // A child of its own per tab, so that each keeps its scroll position.
  ImGui::BeginChild(kTabs[static_cast<std::size_t>(frame.view.tab)].name, {0, 0}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  const bool per_pane = frame.view.tab != kFiguresTab && frame.view.tab != kLogTab;
  if (per_pane && frame.session.runs().size() > 1) choose_pane(frame);
  switch (frame.view.tab) {
    case kPlannerTab:
      draw_planner_panel(frame);
      break;
    case kCellTab:
      draw_cell_panel(frame);
      break;
    case kOpenListTab:
      draw_open_list_panel(frame);
      break;
    case kDebugTab:
      draw_debug_panel(frame);
      break;
    case kCodeTab:
      draw_code_panel(frame);
      break;
    case kFiguresTab:
      draw_figures_panel(frame);
      break;
    default:
      draw_log_panel(frame);
      break;
  }
  ImGui::EndChild();
}

}  // namespace replan::ui
