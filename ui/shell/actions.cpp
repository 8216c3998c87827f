#include "ui/shell/actions.hpp"

#include <algorithm>
#include <cctype>

#include "ui/icons.hpp"
#include "ui/keys.hpp"

namespace replan::ui {
namespace {

constexpr int kLargestBrush = 64;

constexpr Chord plain(int key) {
  return {key, false, false, false};
}
constexpr Chord shift(int key) {
  return {key, false, true, false};
}
constexpr Chord ctrl(int key) {
  return {key, true, false, false};
}
/// F1 and so on.
constexpr Chord fn(int number) {
  return plain(key::kF1 + number - 1);
}
constexpr Chord ctrl_shift(int key) {
  return {key, true, true, false};
}
constexpr Chord alt(int key) {
  return {key, false, false, true};
}

std::string key_name(int key) {
  switch (key) {
    case key::kSpace:
      return "Space";
    case key::kEscape:
      return "Esc";
    case key::kEnter:
      return "Enter";
    case key::kTab:
      return "Tab";
    case key::kRight:
      return "→";
    case key::kLeft:
      return "←";
    case key::kUp:
      return "↑";
    case key::kDown:
      return "↓";
    case key::kPageUp:
      return "PgUp";
    case key::kPageDown:
      return "PgDn";
    case key::kHome:
      return "Home";
    case key::kEnd:
      return "End";
    case key::kDelete:
      return "Del";
    case key::kMenu:
      return "Menu";
    default:
      break;
  }
  if (key >= key::kF1 && key < key::kF1 + 12) return "F" + std::to_string(key - key::kF1 + 1);
  return std::string(1, static_cast<char>(key));
}

const OverlayInfo& overlay_info(Overlay overlay) {
  return overlays()[static_cast<std::size_t>(overlay)];
}

Action make(ActionId id, const char* name, Menu menu, int group, std::string label, const char* icon,
            Chord chord, bool held, std::string teach, void (*effect)(ActionContext&)) {
  return {id,    name, menu, group, std::move(label), icon, chord, chord_text(chord), held, std::move(teach),
          effect};
}

Action make_overlay(Overlay overlay, const char* name, Chord chord, void (*effect)(ActionContext&)) {
  const OverlayInfo& info = overlay_info(overlay);
  const auto id = overlay_action(overlay);
  return make(id, name, Menu::overlays, info.is_field() ? 0 : 1, std::string(info.label), "", chord, false,
              std::string(info.help), effect);
}

std::vector<Action> make_table() {
  std::vector<Action> table;
#define REPLAN_ACTION(ID, MENU, GROUP, LABEL, ICON, CHORD, HELD, TEACH, EFFECT)               \
  table.push_back(make(ActionId::ID, #ID, Menu::MENU, GROUP, LABEL, ICON, CHORD, HELD, TEACH, \
                       [](ActionContext& c) { static_cast<void>(EFFECT); }));
#define REPLAN_OVERLAY(OVERLAY, CHORD)                                       \
  table.push_back(make_overlay(Overlay::OVERLAY, "overlay_" #OVERLAY, CHORD, \
                               [](ActionContext& c) { c.toggle_overlay(Overlay::OVERLAY); }));
#include "ui/shell/actions.def"
#undef REPLAN_OVERLAY
#undef REPLAN_ACTION
  return table;
}

bool modifiers_match(const Chord& chord, const ImGuiIO& io) {
  return chord.ctrl == io.KeyCtrl && chord.shift == io.KeyShift && chord.alt == io.KeyAlt && !io.KeySuper;
}

}  // namespace

std::string chord_text(const Chord& chord) {
  if (chord.key == 0) return "";
  return std::string(chord.ctrl ? "Ctrl+" : "") + (chord.shift ? "Shift+" : "") + (chord.alt ? "Alt+" : "") +
         key_name(chord.key);
}

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

ActionId overlay_action(Overlay overlay) {
  switch (overlay) {
#define REPLAN_ACTION(ID, MENU, GROUP, LABEL, ICON, CHORD, HELD, TEACH, EFFECT)
#define REPLAN_OVERLAY(OVERLAY, CHORD) \
  case Overlay::OVERLAY:               \
    return ActionId::overlay_##OVERLAY;
#include "ui/shell/actions.def"
#undef REPLAN_OVERLAY
#undef REPLAN_ACTION
    case Overlay::count:
      break;
  }
  return ActionId::count;
}

void ActionContext::toggle_play(int direction) {
  if (session.playback().direction != 0) {
    push(Play{0});
    return;
  }
  const Run& run = session.run();
  const bool at_end = run.timeline().cursor() == run.timeline().size();
  const bool over = !run.marks().empty() && run.marks().back().state != MissionState::driving && !run.busy();
  if (direction > 0 && at_end && over) push(Seek{0});  // there is nothing after the end: play it again
  push(Play{direction});
}

void ActionContext::resize_brush(int by) {
  view.brush = std::clamp(view.brush + by, 1, kLargestBrush);
}

void ActionContext::move_pin(int dx, int dy) {
  const std::optional<Cell>& from = view.view.pinned ? view.view.pinned : view.view.hovered;
  if (!from) return;
  const Cell to{from->x + dx, from->y + dy};
  if (session.scenario().map.contains(to)) view.view.pinned = to;
}

void ActionContext::toggle_overlay(Overlay overlay) {
  view.view.overlays.set(overlay, !view.view.overlays.has(overlay));
}

void ActionContext::show_tab(int tab) {
  view.tab = tab;
  view.panels = true;
}

bool available(const Action& action, const ActionContext& context) {
  const Session& session = context.session;
  switch (action.id) {
    case ActionId::undo:
      return !session.undo_text().empty();
    case ActionId::redo:
      return !session.redo_text().empty();
    case ActionId::unpin:
      return context.view.view.pinned || context.view.editing.holds_something();
    case ActionId::finish_way:
      return !context.view.editing.way.empty();
    case ActionId::copy:
    case ActionId::cut:
      return context.view.editing.region.has_value();
    case ActionId::delete_selected:
      return context.view.editing.region || context.view.editing.mover || context.view.editing.surprise;
    case ActionId::pin_left:
    case ActionId::pin_right:
    case ActionId::pin_up:
    case ActionId::pin_down:
      return context.view.view.pinned || context.view.view.hovered;
    case ActionId::break_on_cell:
    case ActionId::watch_cell:
    case ActionId::change_back:
    case ActionId::change_forward:
    case ActionId::cell_menu:
      return context.cell().has_value();
    case ActionId::first_breach:
      return first_breach(session).has_value();
    case ActionId::first_difference:
      return session.runs().size() > 1;
    case ActionId::record_canvas:
      return !context.panels.recording.finishing &&
             !(context.panels.recording.on && context.panels.recording.window);
    case ActionId::record_window:
      return !context.panels.recording.finishing &&
             !(context.panels.recording.on && !context.panels.recording.window);
    case ActionId::next_pane:
    case ActionId::lockstep_expansions:
    case ActionId::lockstep_moves:
    case ActionId::lockstep_race:
      return session.runs().size() > 1;
    case ActionId::reset_settings:
      return session.lead() < session.scenario().planners.size() &&
             !session.scenario().planners[session.lead()].settings.values().empty();
    case ActionId::cancel:
      return std::any_of(session.runs().begin(), session.runs().end(),
                         [](const auto& run) { return run->busy(); });
    default:
      return true;
  }
}

const char* why_not(ActionId id) {
  switch (id) {
    case ActionId::undo:
      return "no edit was made";
    case ActionId::redo:
      return "no edit was taken back";
    case ActionId::unpin:
    case ActionId::delete_selected:
      return "nothing is selected";
    case ActionId::finish_way:
      return "no way is being drawn";
    case ActionId::copy:
    case ActionId::cut:
      return "no region is selected";
    case ActionId::pin_left:
    case ActionId::pin_right:
    case ActionId::pin_up:
    case ActionId::pin_down:
      return "no cell is pinned";
    case ActionId::next_pane:
    case ActionId::lockstep_expansions:
    case ActionId::lockstep_moves:
    case ActionId::lockstep_race:
      return "there is only one pane";
    case ActionId::reset_settings:
      return "all settings are at their defaults";
    case ActionId::cancel:
      return "nothing is being planned";
    default:
      return "";
  }
}

bool checked(const Action& action, const ActionContext& context) {
  const ViewState& view = context.view;
  switch (action.id) {
    case ActionId::tool_select:
      return view.tool == Tool::select;
    case ActionId::tool_paint:
      return view.tool == Tool::paint;
    case ActionId::tool_erase:
      return view.tool == Tool::erase;
    case ActionId::tool_rectangle:
      return view.tool == Tool::rectangle;
    case ActionId::tool_start:
      return view.tool == Tool::start;
    case ActionId::tool_goal:
      return view.tool == Tool::goal;
    case ActionId::tool_surprise:
      return view.tool == Tool::surprise;
    case ActionId::tool_line:
      return view.tool == Tool::line;
    case ActionId::tool_fill:
      return view.tool == Tool::fill;
    case ActionId::tool_mover:
      return view.tool == Tool::mover;
    case ActionId::tool_measure:
      return view.tool == Tool::measure;
    case ActionId::round_brush:
      return view.editing.round;
    case ActionId::one_pane:
      return context.session.runs().size() == 1;
    case ActionId::two_panes:
      return context.session.runs().size() == 2;
    case ActionId::four_panes:
      return context.session.runs().size() == 4;
    case ActionId::lockstep_expansions:
      return context.session.lockstep() == Lockstep::expansions;
    case ActionId::lockstep_moves:
      return context.session.lockstep() == Lockstep::moves;
    case ActionId::lockstep_race:
      return context.session.lockstep() == Lockstep::race;
    case ActionId::panels:
      return view.panels;
    case ActionId::legend:
      return view.legend;
    case ActionId::record_canvas:
      return context.panels.recording.on && !context.panels.recording.window;
    case ActionId::record_window:
      return context.panels.recording.on && context.panels.recording.window;
    case ActionId::caption:
      return context.panels.caption;
    case ActionId::check_laws:
      return context.session.checks().laws(context.session.lead()).on;
    case ActionId::check_oracle:
      return context.session.checks().oracle(context.session.lead()).on;
    default:
      break;
  }
  for (const OverlayInfo& info : overlays())
    if (overlay_action(info.overlay) == action.id) return view.view.overlays.has(info.overlay);
  return false;
}

std::vector<ActionId> pressed_actions(const ImGuiIO& io) {
  std::vector<ActionId> pressed;
  if (io.WantTextInput) return pressed;
  for (const Action& each : actions())
    if (each.chord.key != 0 && modifiers_match(each.chord, io) &&
        ImGui::IsKeyPressed(each.chord.key, each.held))
      pressed.push_back(each.id);
  return pressed;
}

bool key_is_held(const ImGuiIO& io) {
  if (io.WantTextInput) return false;
  return std::any_of(actions().begin(), actions().end(), [&](const Action& each) {
    return each.held && each.chord.key != 0 && modifiers_match(each.chord, io) && io.KeysDown[each.chord.key];
  });
}

}  // namespace replan::ui
