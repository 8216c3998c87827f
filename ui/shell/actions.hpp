// The table of all user actions (actions.def) and what is drawn from it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <imgui.h>

#include "core/scene/view.hpp"
#include "core/session/commands.hpp"
#include "core/study/figures_table.hpp"
#include "ui/canvas/canvas.hpp"
#include "ui/chord.hpp"
#include "ui/shell/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

enum class ActionId : std::uint16_t {
#define REPLAN_ACTION(ID, ...) ID,
#define REPLAN_TOOL(ID) tool_##ID,
#define REPLAN_TAB(ID) show_##ID,
#define REPLAN_OVERLAY(ID) overlay_##ID,
#include "ui/shell/actions.def"
#undef REPLAN_OVERLAY
#undef REPLAN_TAB
#undef REPLAN_TOOL
#undef REPLAN_ACTION
  count
};

/// What actions read and change. Effects on the session are queued; they happen after drawing.
struct ActionContext {
  const Session& session;
  ViewState& view;
  PanelState& panels;
  std::vector<Command>& commands;
  Wish& wish;

  void push(Command command) { commands.push_back(std::move(command)); }
  void step(StepUnit unit, int count) { push(Step{unit, count}); }
  /// What the leading pane's planner calls its steps.
  [[nodiscard]] const StepWords& step_words() const { return session.run().info().step; }
  void toggle_play(int direction);
  void resize_brush(int by);
  void let_go();
  [[nodiscard]] bool looks_at_arc() const;
  void delete_selected();
  void clear_region();
  // Through the clipboard, as text (ui/shell/clipboard.hpp); what takes longer than a frame goes on in the next ones.
  void copy_world();
  void copy_state();
  void copy_cells(MapFile world, const CellBox& region, std::string said);
  void go_on_copying();
  void go_on_copying_state();
  void copy_figures(FiguresFormat format);
  void copy_region();
  void cut_region();
  void paste();
  void go_on_pasting();
  void put_in_link(std::string link);
  void put_in_moment(Result<CaseMoment> moment);
  void put_in_cells(PastedText pasted);
  void move_pin(int dx, int dy);
  void toggle_overlay(Overlay overlay);
  // Of a world with several layers: what the pane that leads shows of it.
  [[nodiscard]] bool is_solid() const;
  [[nodiscard]] bool looks_along(Axis axis) const;
  [[nodiscard]] bool orbits() const;
  void turn_slice(Axis axis);
  void move_slice(int by);
  // The debugger's; those about a cell take the pinned one, else the one under the cursor.
  [[nodiscard]] std::optional<Cell> cell() const;
  void go_to_breakpoint(int direction);
  void break_on_cell();
  void watch_cell();
  void go_to_change(int direction);
  void open_cell_menu();
  void switch_checks(bool laws, bool oracle);
  void go_to_breach();
  void find_difference();
  // What actions ask before they can be done.
  [[nodiscard]] bool is_busy() const;
  [[nodiscard]] bool has_own_settings() const;
  /// A page is left by closing its tab.
  [[nodiscard]] bool may_quit() const { return !kInPage; }
  /// Whether a film of the window, or of the canvas, is being recorded, and whether one can be begun or ended.
  [[nodiscard]] bool records(bool window) const;
  [[nodiscard]] bool may_record(bool window) const;
};

/// What an action depends on; what is left out is never so, but for `available`.
struct ActionRules {
  using Condition = bool (*)(const ActionContext& context);
  Condition available = nullptr;  ///< it would do something now (undo: there is something to take back)
  const char* why_not = "";       ///< half a sentence ("nothing is selected"); empty if it explains itself
  Condition checked = nullptr;    ///< it is a switch that is on, or the chosen one of several
  Condition hidden = nullptr;     ///< the menu leaves it out
  /// What the menu calls it now; empty: its label.
  std::string (*words)(const ActionContext& context) = nullptr;
  /// What it teaches now; empty: what the table has.
  std::string (*lesson)(const ActionContext& context) = nullptr;
  void (*below)(Frame& frame) = nullptr;  ///< what the menu has below it
  bool unlisted = false;                  ///< the palette leaves it out
  std::vector<Chord> also = {};           ///< further keys
  bool on_release = false;  ///< done when the key is let go: while it is held it is for the mouse
};

struct Action {
  ActionId id;
  const char* name;  ///< its identifier: "step_forward"
  Menu menu;
  int group;
  std::string label;
  const char* icon;
  Chord chord;
  bool held;  ///< repeats while the key is held
  std::string teach;
  void (*effect)(ActionContext& context);
  ActionRules rules = {};
  std::string keys = {};  ///< chord_text(chord)

  [[nodiscard]] Hint hint() const { return {label.c_str(), keys.c_str(), teach.c_str()}; }
  [[nodiscard]] bool available(const ActionContext& context) const {
    return rules.available == nullptr || rules.available(context);
  }
  [[nodiscard]] bool checked(const ActionContext& context) const {
    return rules.checked != nullptr && rules.checked(context);
  }
  [[nodiscard]] bool hidden(const ActionContext& context) const {
    return rules.hidden != nullptr && rules.hidden(context);
  }
  /// What a menu calls it now.
  [[nodiscard]] std::string words(const ActionContext& context) const;
  /// What its tooltip says now.
  [[nodiscard]] std::string lesson(const ActionContext& context) const;
};

/// All actions in the order of the table.
std::span<const Action> actions();
const Action& action(ActionId id);
/// The action of that identifier ("keys"), or nullptr.
const Action* find_action(std::string_view name);
ActionId overlay_action(Overlay overlay);
ActionId tool_action(std::string_view tool);
/// That shows the tab.
ActionId tab_action(std::string_view tab);

/// Actions whose chord was pressed this frame; none while text is typed.
std::vector<ActionId> pressed_actions(const ImGuiIO& io);
/// Whether a key of a repeating action is down: frames are needed although no event comes.
bool key_is_held(const ImGuiIO& io);

}  // namespace replan::ui
