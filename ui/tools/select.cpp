#include "ui/tools/select.hpp"

#include "core/lattice/box_words.hpp"
#include "core/scene/arcs.hpp"
#include "ui/canvas/view_state.hpp"
#include "ui/icons.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tabs/drive.hpp"
#include "ui/tools/cells.hpp"
#include "ui/tools/surprise.hpp"

namespace replan::ui {
namespace {

/// Whether the click was on an arc: the Drive tab tells of it.
bool looks_at_arc(ToolContext& context) {
  constexpr double kNear = 5;  // pixels
  const auto arc =
      arc_at(context.run, context.view.view, context.pointer.place, kNear * context.pointer.pixel);
  if (!arc) return false;
  context.view.view.motion = *arc;
  show_drive(context.view);
  return true;
}

class SelectTool final : public Tool {
 public:
  std::unique_ptr<Drag> press(ToolContext& context) override;
  /// Takes up an arc that a driving robot tries. Where there is none it pins a cell, or unpins it, and selects what is to
  /// happen there.
  void click(ToolContext& context) override {
    if (looks_at_arc(context)) return;
    const Cell at = context.press.first;
    std::optional<Cell>& pinned = context.view.view.pinned;
    pinned = pinned == at ? std::nullopt : std::optional<Cell>(at);
    Editing& editing = context.view.editing;
    editing.region.reset();
    editing.mover.reset();
    editing.surprise = surprise_at(context.run, at);
  }
  [[nodiscard]] bool has_options(const ViewState& view) const override {
    return view.editing.region.has_value();
  }
  void draw_options(Frame& frame) override;
  [[nodiscard]] bool begins_outside(bool right) const override { return !right; }
  void leave(ViewState& view) override { view.editing.region.reset(); }
};

class RegionDrag final : public Drag {
 public:
  explicit RegionDrag(SelectTool& tool) : tool_(tool) {}
  void move(ToolContext& context) override {
    const Press& press = context.press;
    const auto region = in_world(context.run.lattice(), box_of(press.first, press.last));
    if (press.moved && region) select_region(context.view.editing, *region);
  }
  void end(ToolContext& context) override {
    if (!context.press.moved && !context.press.outside) tool_.click(context);
  }
  [[nodiscard]] bool leaves_world() const override { return true; }

 private:
  SelectTool& tool_;
};

std::unique_ptr<Drag> SelectTool::press(ToolContext&) {
  return std::make_unique<RegionDrag>(*this);
}

/// What can be done with the region.
void SelectTool::draw_options(Frame& frame) {
  const Look& look = frame.look;
  const CellBox& region = *frame.view.editing.region;
  section_title(look, part_text(region));
  const auto entry = [&](ActionId id, bool last) {
    const Action& each = action(id);
    if (small_button(look, each.name, {.icon = each.icon, .hint = each.hint()})) perform(frame, id);
    if (!last) ImGui::SameLine(0, look.px.xs);
  };
  entry(ActionId::copy, false);
  entry(ActionId::cut, false);
  entry(ActionId::paste, false);
  entry(ActionId::delete_selected, true);
}

}  // namespace

void select_with_tool(ViewState& view, const CellBox& region) {
  choose_tool(view, "select");
  select_region(view.editing, region);
}

ToolKind select_tool() {
  return {
      .label = "Select",
      .icon = icon::pointer,
      .chord = plain('V'),
      .teach =
          "Hover a cell to see its values; click to pin it; drag to select a region. The right button opens "
          "the cell's menu.",
      .group = ToolGroup::look,
      .make = make_part<Tool, SelectTool>,
      .at_first = true,
      .leads = true};
}

}  // namespace replan::ui
