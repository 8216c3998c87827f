// A tool: what the mouse does on the canvas while it is chosen. Each has a file in ui/tools that defines its ToolKind,
// and a line in tools.def; menus, keys, the tool strip, the palette and the page of keys follow.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "core/lattice/seen_box.hpp"
#include "core/session/session.hpp"
#include "core/world/brush.hpp"
#include "ui/canvas/editing.hpp"
#include "ui/chord.hpp"
#include "ui/theme.hpp"

namespace replan::ui {

class CellPen;
struct Frame;
struct ViewState;

/// What the mouse does in one frame.
struct Pointer {
  Sheet sheet;  ///< what the canvas shows
  Cell cell;    ///< under the cursor; may lie outside the world
  bool over;    ///< the cursor is over the canvas, and the canvas has the mouse
  bool inside;  ///< and it is over the world
  bool left_pressed, right_pressed;
  bool left_down, right_down;
  Point place;   ///< of the cursor in columns and rows
  double pixel;  ///< how many cells a pixel of the design is
  double reach;  ///< how many cells away a start or goal can still be grabbed
};

/// One press of a button, until it is let go.
struct Press {
  bool right = false;  ///< of the right button, which erases
  bool moved = false;
  Sheet sheet = {};                         ///< on which it began
  Cell first = {}, before = {}, last = {};  ///< where it began, and where it was and is in this frame
  bool outside = false;                     ///< it began beside the world, and `first` is there
  StrokeKind kind = StrokeKind::none;
  std::uint64_t stroke = 0;  ///< what it does is undone as one
  [[nodiscard]] bool adds() const { return kind == StrokeKind::paints; }
};

/// What a tool works on, in one frame.
struct ToolContext {
  const Session& session;
  const Run& run;
  ViewState& view;
  std::vector<Command>& commands;
  const Pointer& pointer;
  Press& press;
};

/// Cells that would be written, in columns and rows of what the canvas shows.
struct CellPreview {
  std::vector<CellSpan> cells = {};
  bool adds = true;     ///< obstacles
  bool filled = false;  ///< or outlined alone
};

/// What a press has begun: it goes on until the button is let go.
class Drag {
 public:
  virtual ~Drag() = default;
  /// Once a frame, the first time in that of the press.
  virtual void move(ToolContext&) {}
  virtual void end(ToolContext&) {}
  /// What would be written if the button were let go now.
  [[nodiscard]] virtual CellPreview preview(const Press&, const ViewState&) const { return {}; }
  /// Something that stands in the world is held: it goes where the mouse goes.
  [[nodiscard]] virtual bool holds() const { return false; }
  /// Obstacles are drawn or erased: the status bar says so.
  [[nodiscard]] virtual bool draws() const { return false; }
  /// Press::last may lie outside the world.
  [[nodiscard]] virtual bool leaves_world() const { return false; }
};

class Tool {
 public:
  virtual ~Tool() = default;

  /// The left button goes down. What begins with that; nullptr: it is done.
  virtual std::unique_ptr<Drag> press(ToolContext& context) = 0;
  /// The right button does: it asks for the menu of the cell.
  virtual std::unique_ptr<Drag> press_right(ToolContext& context);
  /// A click on the start, the goal or the robot, which a drag would have moved.
  virtual void click(ToolContext&) {}
  /// Whether such a press may begin beside the world: its Drag then has to leave it (Drag::leaves_world).
  [[nodiscard]] virtual bool begins_outside(bool /*right*/) const { return false; }
  /// Whether a press takes hold of the start, the goal or the robot where they stand.
  [[nodiscard]] virtual bool grabs() const { return true; }

  /// The cells that a press at the cursor would write.
  [[nodiscard]] virtual CellPreview preview(const ViewState&, const Sheet&, Cell) const { return {}; }
  /// Draws over the canvas what there is besides; `hovered` is nothing while something is held.
  virtual void draw(const CellPen&, const ViewState&, std::optional<Cell> /*hovered*/) const {}

  /// What it lets one choose, under the side panel; beside what is selected, which has choices of its own.
  [[nodiscard]] virtual bool has_options(const ViewState&) const { return false; }
  virtual void draw_options(Frame&) {}

  /// It was chosen, maybe once more; another one is.
  virtual void choose(ViewState&) {}
  virtual void leave(ViewState&) { drop(); }
  /// Something is half drawn, or measured; lets go of it.
  [[nodiscard]] virtual bool holds() const { return false; }
  virtual void drop() {}
};

/// Tools of a group stand together in the tool strip, with the brush below those that draw.
enum class ToolGroup : std::uint8_t { look, draw, ends, script, measure };

struct ToolKind {
  const char* label;
  const char* icon;
  Chord chord;
  const char* teach;
  ToolGroup group;
  std::unique_ptr<Tool> (*make)();
  ImU32 Theme::*colour = nullptr;  ///< of its icon and of what it would write; nullptr: as all others
  ImGuiMouseCursor cursor = ImGuiMouseCursor_Arrow;
  bool at_first = false;     ///< chosen when the program begins
  bool leads = false;        ///< a click makes its pane lead
  std::string_view id = {};  ///< as listed
};

/// All tools in the order of tools.def.
std::span<const ToolKind> tool_kinds();

}  // namespace replan::ui
