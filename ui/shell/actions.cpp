#include "ui/shell/actions.hpp"

#include <algorithm>
#include <numbers>

#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/lesson_card.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tabs/analysis.hpp"
#include "ui/tabs/code.hpp"
#include "ui/tabs/log.hpp"
#include "ui/tabs/open_list.hpp"
#include "ui/tabs/words.hpp"
#include "ui/tools/mover.hpp"

namespace replan::ui {
namespace {

constexpr int kLargestBrush = 64;

Action make_tool(ActionId id, const char* name, std::string_view tool, void (*effect)(ActionContext&),
                 ActionRules::Condition checked) {
  const auto kinds = tool_kinds();
  const ToolKind& kind =
      *std::find_if(kinds.begin(), kinds.end(), [tool](const ToolKind& each) { return each.id == tool; });
  return {.id = id,
          .name = name,
          .menu = Menu::edit,
          .group = kind.group <= ToolGroup::draw ? 1 : 2,
          .label = kind.label,
          .icon = kind.icon,
          .chord = kind.chord,
          .held = false,
          .teach = kind.teach,
          .effect = effect,
          .rules = {.checked = checked}};
}

Action make_tab(ActionId id, const char* name, std::string_view tab, void (*effect)(ActionContext&)) {
  const TabKind& kind = tab_kinds()[tab_number(tab)];
  return {.id = id,
          .name = name,
          .menu = Menu::tabs,
          .group = 0,
          .label = kind.label,
          .icon = kind.icon,
          .chord = kind.chord,
          .held = false,
          .teach = kind.teach,
          .effect = effect};
}

Action make_overlay(ActionId id, const char* name, Overlay overlay, void (*effect)(ActionContext&),
                    ActionRules::Condition checked) {
  const OverlayInfo& info = overlays()[static_cast<std::size_t>(overlay)];
  return {.id = id,
          .name = name,
          .menu = Menu::overlays,
          .group = info.is_field() ? 0 : 1,
          .label = std::string(info.label),
          .icon = "",
          .chord = plain(info.key),
          .held = false,
          .teach = std::string(info.help),
          .effect = effect,
          .rules = {.checked = checked}};
}

std::vector<Action> make_table() {
  std::vector<Action> table = {
#define REPLAN_WHEN(CONDITION) [](const ActionContext& c) { return static_cast<bool>(CONDITION); }
#define REPLAN_SAY(WORDS) [](const ActionContext& c) -> std::string { return WORDS; }
#define REPLAN_ACTION(ID, MENU, GROUP, LABEL, ICON, CHORD, HELD, TEACH, EFFECT, ...) \
  {ActionId::ID,                                                                     \
   #ID,                                                                              \
   Menu::MENU,                                                                       \
   GROUP,                                                                            \
   LABEL,                                                                            \
   ICON,                                                                             \
   CHORD,                                                                            \
   HELD,                                                                             \
   TEACH,                                                                            \
   [](ActionContext& c) { static_cast<void>(EFFECT); },                              \
   ActionRules{__VA_ARGS__}},
#define REPLAN_TOOL(ID)                                                                          \
  make_tool(                                                                                     \
      ActionId::tool_##ID, "tool_" #ID, #ID, [](ActionContext& c) { choose_tool(c.view, #ID); }, \
      [](const ActionContext& c) { return c.view.tools.chosen_id() == #ID; }),
#define REPLAN_TAB(ID) \
  make_tab(ActionId::show_##ID, "show_" #ID, #ID, [](ActionContext& c) { show_tab(c.view, c.panels, #ID); }),
#define REPLAN_OVERLAY(ID)                                     \
  make_overlay(                                                \
      ActionId::overlay_##ID, "overlay_" #ID, Overlay::ID,     \
      [](ActionContext& c) { c.toggle_overlay(Overlay::ID); }, \
      [](const ActionContext& c) { return c.view.view.overlays.has(Overlay::ID); }),
#include "ui/shell/actions.def"
#undef REPLAN_OVERLAY
#undef REPLAN_TAB
#undef REPLAN_TOOL
#undef REPLAN_ACTION
#undef REPLAN_SAY
#undef REPLAN_WHEN
  };
  for (Action& each : table) {
    if (kInPage) each.chord = chord_in_page(each.chord);
    each.keys = chord_text(each.chord);
  }
  return table;
}

bool modifiers_match(const Chord& chord, const ImGuiIO& io) {
  return chord.ctrl == io.KeyCtrl && chord.shift == io.KeyShift && chord.alt == io.KeyAlt && !io.KeySuper;
}

/// Whether one of the action's keys, with its modifiers, is what `is` asks for.
template <class Is>
bool any_chord(const Action& action, const ImGuiIO& io, const Is& is) {
  const auto matches = [&](const Chord& chord) {
    return chord.key != 0 && modifiers_match(chord, io) && is(chord.key);
  };
  const std::vector<Chord>& also = action.rules.also;
  return matches(action.chord) || std::any_of(also.begin(), also.end(), matches);
}

}  // namespace

std::span<const Action> actions() {
  static const std::vector<Action> kTable = make_table();
  return kTable;
}

const Action& action(ActionId id) {
  return actions()[static_cast<std::size_t>(id)];
}

const Action* find_action(std::string_view name) {
  const auto all = actions();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Action& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

ActionId tool_action(std::string_view tool) {
  return find_action("tool_" + std::string(tool))->id;
}

ActionId tab_action(std::string_view tab) {
  return find_action("show_" + std::string(tab))->id;
}

ActionId overlay_action(Overlay overlay) {
  static constexpr ActionId kActions[] = {
#define REPLAN_ACTION(ID, ...)
#define REPLAN_TOOL(ID)
#define REPLAN_TAB(ID)
#define REPLAN_OVERLAY(ID) ActionId::overlay_##ID,
#include "ui/shell/actions.def"
#undef REPLAN_OVERLAY
#undef REPLAN_TAB
#undef REPLAN_TOOL
#undef REPLAN_ACTION
  };
  return kActions[static_cast<std::size_t>(overlay)];
}

std::string Action::words(const ActionContext& context) const {
  std::string now = rules.words == nullptr ? "" : rules.words(context);
  return now.empty() ? label : now;
}

std::string Action::lesson(const ActionContext& context) const {
  std::string now = rules.lesson == nullptr ? "" : rules.lesson(context);
  return now.empty() ? teach : now;
}

void ActionContext::toggle_play(int direction) {
  if (session.playback().direction != 0) {
    push(Play{0});
    return;
  }
  const Run& run = session.run();
  const bool at_end = run.timeline().cursor() == run.timeline().size();
  const bool over =
      !run.decisions().empty() && run.decisions().back().state != MissionState::driving && !run.busy();
  if (direction > 0 && at_end && over) push(Seek{0});  // there is nothing after the end: play it again
  push(Play{direction});
}

void ActionContext::resize_brush(int by) {
  view.brush = std::clamp(view.brush + by, 1, kLargestBrush);
}

void ActionContext::move_pin(int dx, int dy) {
  const std::optional<Cell>& from = view.view.pinned ? view.view.pinned : view.view.hovered;
  if (!from) return;
  const SeenBox seen(session.scenario().map.box(), view.slices.of(session.lead()).along);
  const Cell at = seen.seen(*from), to = seen.world(Cell{at.x + dx, at.y + dy, at.z});
  if (session.scenario().map.contains(to)) view.view.pinned = to;
}

bool ActionContext::is_solid() const {
  return session.run().lattice().solid();
}

bool ActionContext::looks_along(Axis axis) const {
  return is_solid() && !orbits() && view.slices.of(session.lead()).along == axis;
}

bool ActionContext::orbits() const {
  return is_solid() && view.slices.orbits(session.lead());
}

void ActionContext::turn_slice(Axis axis) {
  view.slices.set_orbits(session.lead(), false);
  ui::turn_slice(view.slices, session.lead(), session.run().lattice(), axis, view.view.pinned);
}

void ActionContext::move_slice(int by) {
  ui::move_slice(view.slices, session.lead(), session.run().lattice(), by);
}

void ActionContext::toggle_overlay(Overlay overlay) {
  const bool on = !view.view.overlays.has(overlay);
  view.view.overlays.set(overlay, on);
  const OverlayInfo& info = overlays()[static_cast<std::size_t>(overlay)];
  if (!on || panels.zoom / view.view.scale >= info.readable_from) return;
  panels.said = "Zoom in to see all of them: they appear once cells are " + fixed(info.readable_from, 0) +
                " pixels wide.";
  panels.tone = Tone::hint;
}

bool ActionContext::is_busy() const {
  return session.editing_world() || std::any_of(session.runs().begin(), session.runs().end(),
                                                [](const auto& run) { return run->busy(); });
}

bool ActionContext::has_own_settings() const {
  const auto& planners = session.scenario().planners;
  return session.lead() < planners.size() && !planners[session.lead()].settings.values().empty();
}

bool ActionContext::records(bool window) const {
  return panels.recording.on && panels.recording.made < 0 && panels.recording.window == window;
}

bool ActionContext::may_record(bool window) const {
  return !panels.recording.finishing && panels.recording.made < 0 &&
         (!panels.recording.on || records(window));
}

std::vector<ActionId> pressed_actions(const ImGuiIO& io) {
  std::vector<ActionId> pressed;
  if (io.WantTextInput) return pressed;
  for (const Action& each : actions())
    if (any_chord(each, io, [&](int key) { return ImGui::IsKeyPressed(key, each.held); }))
      pressed.push_back(each.id);
  return pressed;
}

bool key_is_held(const ImGuiIO& io) {
  if (io.WantTextInput) return false;
  return std::any_of(actions().begin(), actions().end(), [&](const Action& each) {
    return each.held && any_chord(each, io, [&](int key) { return io.KeysDown[key]; });
  });
}

}  // namespace replan::ui
