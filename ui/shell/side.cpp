// The side panel: tabs, and below them which planner of several they are about.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "ui/icons.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

constexpr const char* kMoreTabs = "more tabs";

/// Several planners run side by side: whose values shall the tabs show?
void choose_pane(Frame& frame, std::size_t shown) {
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
    tab_stop(look);
    const bool chosen = i == shown, hovered = ImGui::IsItemHovered();
    hint(look,
         {std::string(runs[i]->info().name).c_str(), "",
          "Lets this planner lead: the tabs and the timeline show its values, and the other panes follow."});
    ImGui::PopID();
    if (chosen) list.AddRectFilled(min, max, look.theme.selected, look.px.radius);
    const std::string name = elide(look.fonts.ui, runs[i]->info().name, width - look.px.l);
    draw_text_centred(list, look.fonts.ui, min, max, chosen || hovered ? look.theme.text : look.theme.dim,
                      name);
  }
  ImGui::SetCursorScreenPos({origin.x, origin.y + look.px.control + look.px.m});
}

/// Behind the last tab of the bar: those that have no place in it.
void more_tabs(Frame& frame, std::span<const std::size_t> numbers, ImVec2 corner) {
  const Look& look = frame.look;
  ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {1, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px.m, look.px(10)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px.s, look.px.menu_gap));
  const bool open = ImGui::BeginPopup(kMoreTabs, ImGuiWindowFlags_NoMove);
  for (const std::size_t number : open ? numbers : std::span<const std::size_t>()) {
    const Action& shows = action(tab_action(tab_kinds()[number].id));
    if (menu_item(look, shows.label.c_str(), {.icon = shows.icon, .keys = shows.keys.c_str()}))
      perform(frame, tab_action(tab_kinds()[number].id));
    hint(look, shows.hint());
  }
  if (open) ImGui::EndPopup();
  ImGui::PopStyleVar(2);
}

/// From the end on, until the rest stands in one line; never the chosen one.
void leave_out(Frame& frame, std::vector<Tab>& all, std::vector<std::size_t>& numbers,
               std::vector<std::size_t>& others, int& chosen) {
  const Look& look = frame.look;
  const float room = ImGui::GetContentRegionAvail().x - look.px.l;
  const auto wide = [&](const char* name) { return text_width(look.fonts.ui, name) + 2 * look.px(6); };
  const auto whole = [&] {
    float sum = wide(icon::ellipsis);
    for (const Tab& each : all) sum += wide(each.name);
    return sum;
  };
  while (all.size() > 1 && whole() > room) {
    const std::size_t last = all.size() - 1;
    const std::size_t gone = chosen == static_cast<int>(last) ? last - 1 : last;
    others.push_back(numbers[gone]);
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(gone));
    numbers.erase(numbers.begin() + static_cast<std::ptrdiff_t>(gone));
    if (static_cast<int>(gone) < chosen) --chosen;
  }
  std::sort(others.begin(), others.end());
}

/// The number of the tab that shows; a click chooses another one.
std::size_t choose_tab(Frame& frame) {
  const auto kinds = tab_kinds();
  const std::size_t shown = tab_number(frame.view.tab);
  std::vector<Tab> all;
  std::vector<std::size_t> numbers, others;
  int chosen = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (i != shown && kinds[i].in_bar != nullptr && !kinds[i].in_bar(frame.session)) {
      others.push_back(i);
      continue;
    }
    if (i == shown) chosen = static_cast<int>(all.size());
    all.push_back({kinds[i].name, action(tab_action(kinds[i].id)).hint()});
    numbers.push_back(i);
  }
  if (frame.panels.short_of_room) leave_out(frame, all, numbers, others, chosen);
  if (!others.empty())
    all.push_back({icon::ellipsis, {"More tabs", "", "Those that the bar has no room for."}});
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float right = origin.x + ImGui::GetContentRegionAvail().x;
  const bool changed = tabs(frame.look, "tabs", all, chosen);
  const auto place = static_cast<std::size_t>(chosen);
  if (changed && place == numbers.size()) ImGui::OpenPopup(kMoreTabs);
  more_tabs(frame, others, {right, ImGui::GetCursorScreenPos().y});
  if (changed && place < numbers.size()) frame.view.tab = kinds[numbers[place]].id;
  return tab_number(frame.view.tab);
}

}  // namespace

void draw_side(Frame& frame) {
  const Look& look = frame.look;
  // A row of the last frame that stood for a cell; the one under the mouse now says so again.
  std::optional<Cell>& pointed = frame.panels.pointed;
  if (pointed && frame.view.view.hovered == pointed) frame.view.view.hovered.reset();
  pointed.reset();
  frame.view.view.pointed_motion.reset();
  frame.view.view.brushed.reset();
  frame.view.view.family.reset();
  const std::size_t tab = choose_tab(frame);
  edge(look, Edge::left);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px.l, look.px.m));
  // A child of its own per tab, so that each keeps its scroll position.
  ImGui::BeginChild(tab_kinds()[tab].name, {0, 0}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  if (tab_kinds()[tab].per_pane && frame.session.runs().size() > 1)
    choose_pane(frame, frame.panels.tabs[tab].pane(frame));
  frame.panels.tabs[tab].draw(frame);
  ImGui::EndChild();
}

}  // namespace replan::ui
