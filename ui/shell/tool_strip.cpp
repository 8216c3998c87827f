// The tools at the left edge, the size of the brush, and the way to the overlays.
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "ui/icons.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

constexpr float kBrushSlider = 200;  // design pixels

constexpr double kMostLayers = 64;
constexpr const char* kAllTools = "all tools of the row";

/// What the strip takes with space between its parts: each button's, and that between groups; and without it.
constexpr float kRoomyButton = 38, kRoomyRest = 146, kTightButton = 34, kTightRest = 24;

/// With the brush and the overlays.
float buttons_in_all() {
  return static_cast<float>(tool_kinds().size()) + 2;
}

/// Whether all are there in two columns.
bool fits_strip(const Look& look, float height) {
  return height >= look.px.tool * std::ceil(buttons_in_all() / 2);
}

/// Lets the buttons follow each other in one column, or in two.
class ToolGrid {
 public:
  explicit ToolGrid(bool two) : two_(two) {}
  void next() {
    if (two_ && count_++ % 2 == 1) ImGui::SameLine(0, 0);
  }

 private:
  bool two_;
  int count_ = 0;
};

void tool(Frame& frame, const ToolKind& kind) {
  const Action& each = action(tool_action(kind.id));
  if (tool_button(frame.look, each.name,
                  {.icon = each.icon,
                   .hint = each.hint(),
                   .selected = each.checked(context_of(frame)),
                   .colour = kind.colour != nullptr ? frame.look.theme.*kind.colour : 0}))
    perform(frame, each.id);
}

/// How deep tools draw, in a world with several layers.
void layers_slider(Frame& frame) {
  double layers = frame.view.layers;
  if (slider(
          frame.look,
          {.label = "Layers", .min = 1, .max = kMostLayers, .initial = 1, .decimals = 0, .logarithmic = true},
          layers,
          {"Layers", "",
           "How many layers the tools draw in at once, from the one that shows on: a rectangle becomes a "
           "box."}))
    frame.view.layers = static_cast<int>(layers);
}

/// Shows the brush as it is, opens a slider, and takes the wheel.
void brush_size(Frame& frame) {
  const Look& look = frame.look;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("brush", {look.px.tool, look.px.tool})) ImGui::OpenPopup("brush size");
  tab_stop(look);
  const bool hovered = ImGui::IsItemHovered();
  const std::string keys = action(ActionId::brush_smaller).keys + " " + action(ActionId::brush_larger).keys;
  hint(look,
       {"Brush size", keys.c_str(),
        "How wide the tools paint and erase, and how large a moving obstacle is. The wheel changes it."});
  if (hovered && ImGui::GetIO().MouseWheel != 0)
    context_of(frame).resize_brush(ImGui::GetIO().MouseWheel > 0 ? 1 : -1);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (hovered)
    list.AddRectFilled(origin, {origin.x + look.px.tool, origin.y + look.px.tool}, look.theme.hover,
                       look.px.radius_l);
  const std::string size = std::to_string(frame.view.brush);
  draw_text_centred(list, look.fonts.mono, origin, {origin.x + look.px.tool, origin.y + look.px(22)},
                    look.theme.dim, size);
  const float half = (look.px(3) + static_cast<float>(frame.view.brush) / 64.0f * look.px(7)) * 0.5f;
  const ImVec2 middle(origin.x + look.px.tool * 0.5f, origin.y + look.px(26));
  if (frame.view.editing.round)
    list.AddCircleFilled(middle, half + look.px(0.5f), look.theme.dim);
  else
    list.AddRectFilled({middle.x - half, middle.y - half}, {middle.x + half, middle.y + half}, look.theme.dim,
                       look.px(1));
  const float beside = origin.x + look.px.tool + look.px(14);
  const float last = ImGui::GetIO().DisplaySize.x - look.px(kBrushSlider) -
                     2 * ImGui::GetStyle().WindowPadding.x - look.px.s;
  // Below the tools where there is no room beside them.
  ImGui::SetNextWindowPos(beside <= last ? ImVec2(beside, origin.y)
                                         : ImVec2(last, origin.y + look.px.tool + look.px(10)));
  if (ImGui::BeginPopup("brush size")) {
    double value = frame.view.brush;
    const bool solid = frame.run().lattice().solid();
    ImGui::BeginChild("slider", {look.px(kBrushSlider), look.px(solid ? 110 : 60)});
    if (slider(look,
               {.label = "Brush",
                .min = 1,
                .max = 64,
                .initial = 1,
                .unit = "cells",
                .decimals = 0,
                .logarithmic = true},
               value))
      frame.view.brush = static_cast<int>(value);
    toggle(look, "Round", frame.view.editing.round);
    if (solid) layers_slider(frame);
    ImGui::EndChild();
    ImGui::EndPopup();
  }
}

void overlays_button(Frame& frame) {
  const Look& look = frame.look;
  if (tool_button(look, "overlays",
                  {.icon = icon::eye,
                   .hint = {"Overlays", "",
                            "What is laid over the world: values as colours, arrows, the path, the queue."}}))
    ImGui::OpenPopup("overlays");
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float rim = 2 * ImGui::GetStyle().WindowPadding.x + ImGui::GetStyle().ScrollbarSize;
  const float room = screen.x - rim - 2 * look.px.s;
  const float left = std::min(ImGui::GetItemRectMax().x + look.px(10),
                              screen.x - overlay_switches_width(look, room) - rim - look.px.s);
  const float middle = ImGui::GetItemRectMax().y;
  // The lower its middle, the more of it stands above that: it never leaves the window.
  ImGui::SetNextWindowPos({left, middle}, ImGuiCond_Always, {0, middle / screen.y});
  ImGui::SetNextWindowSizeConstraints({0, 0}, screen);
  if (ImGui::BeginPopup("overlays")) {
    draw_overlay_switches(frame, room);
    ImGui::EndPopup();
  }
}

/// The tools that have a place of their own among `count`: the first ones, and the chosen one.
std::vector<const ToolKind*> tools_in_row(Frame& frame, std::size_t count) {
  std::vector<const ToolKind*> row;
  for (const ToolKind& kind : tool_kinds()) {
    const bool chosen = action(tool_action(kind.id)).checked(context_of(frame));
    if (row.size() < count)
      row.push_back(&kind);
    else if (chosen && !row.empty())
      row.back() = &kind;
  }
  return row;
}

/// Those and all others, with their names.
void all_tools(Frame& frame) {
  const Look& look = frame.look;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px.m, look.px(10)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px.s, look.px.menu_gap));
  const bool open = ImGui::BeginPopup(kAllTools, ImGuiWindowFlags_NoMove);
  for (const ToolKind& kind : open ? tool_kinds() : std::span<const ToolKind>()) {
    const Action& each = action(tool_action(kind.id));
    const MenuEntry entry{
        .icon = each.icon, .keys = each.keys.c_str(), .on = each.checked(context_of(frame))};
    if (menu_item(look, each.label.c_str(), entry)) perform(frame, each.id);
    hint(look, each.hint());
  }
  if (open) ImGui::EndPopup();
  ImGui::PopStyleVar(2);
}

}  // namespace

void draw_tool_row(Frame& frame) {
  const Look& look = frame.look;
  const bool across = ImGui::GetWindowWidth() > ImGui::GetWindowHeight();
  edge(look, across ? Edge::bottom : Edge::right);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float step = look.px.tool + (across ? look.px(2) : 0);
  const auto places = static_cast<std::size_t>(std::max((across ? room.x : room.y) / step, 4.0f));
  const auto next = [&] {
    if (across) ImGui::SameLine(0, look.px(2));
  };
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  for (const ToolKind* kind : tools_in_row(frame, places - 3)) {
    tool(frame, *kind);
    next();
  }
  brush_size(frame);
  next();
  overlays_button(frame);
  next();
  if (tool_button(look, "all tools",
                  {.icon = icon::ellipsis, .hint = {"All tools", "", "With their names and keys."}}))
    ImGui::OpenPopup(kAllTools);
  ImGui::PopStyleVar();
  all_tools(frame);
}

float tool_strip_width(const Look& look, float height) {
  if (!fits_strip(look, height)) return look.px.tools;
  const bool two = height < look.px(kTightButton * buttons_in_all() + kTightRest);
  return two ? look.px.tools + look.px.tool : look.px.tools;
}

void draw_tool_strip(Frame& frame) {
  const Look& look = frame.look;
  if (!fits_strip(look, ImGui::GetContentRegionAvail().y)) return draw_tool_row(frame);
  edge(look, Edge::right);
  // In a low window the tools stand closer, in a very low one in two columns.
  const bool tight = ImGui::GetContentRegionAvail().y < look.px(kRoomyButton * buttons_in_all() + kRoomyRest);
  const bool two = ImGui::GetWindowWidth() > look.px.tools;
  const auto part = [&] {
    if (two) return;
    if (tight)
      ImGui::Dummy({0, look.px(2)});
    else
      tool_separator(look);
  };
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, tight ? 0 : look.px.xs));
  ToolGrid grid(two);
  ToolGroup group = tool_kinds().front().group;
  for (const ToolKind& kind : tool_kinds()) {
    if (kind.group != group) {
      if (group == ToolGroup::draw) {
        grid.next();
        brush_size(frame);
      }
      part();
    }
    group = kind.group;
    grid.next();
    tool(frame, kind);
  }
  part();
  grid.next();
  overlays_button(frame);
  ImGui::PopStyleVar();
}

}  // namespace replan::ui
