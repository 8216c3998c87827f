// What the panels of the window share: what they read, what they remember, and where their wishes go.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "core/debug/kept.hpp"
#include "core/debug/sample_in_hand.hpp"
#include "core/debug/touched.hpp"
#include "core/experiment/batch_job.hpp"
#include "core/lesson/lesson.hpp"
#include "core/plan/pages.hpp"
#include "core/session/session.hpp"
#include "ui/canvas/canvas.hpp"
#include "ui/look.hpp"
#include "ui/shell/clipboard.hpp"
#include "ui/shell/message.hpp"
#include "ui/shell/recording.hpp"
#include "ui/tabs/tab_box.hpp"

namespace replan::ui {

/// What an action asks of the shell itself; done after drawing.
enum class Wish : std::uint8_t {
  none,
  new_world,
  open,
  worlds,
  recent,  ///< PanelState::wished
  forget_recent,
  save,
  save_as,
  quit,
  fit,
  keys,
  record_canvas,
  record_window,
  picture_canvas,
  picture_window,
  export_trace,
  stop_export,
  stop_film,
  go_to_pasted,  ///< PanelState::pasted
  open_link,     ///< PanelState::wished
  copy_link,
  stop_going,
  generate,
  resize,
  batch,
  palette,
  open_world,  ///< of the library: PanelState::wished
  save_figures,
  lesson,  ///< PanelState::wished
  about
};

/// The menus of the bar, and their submenus.
enum class Menu : std::uint8_t {
  file,
  edit,
  world,
  planner,
  run,
  debug,
  view,
  slice,
  move,
  panes,
  pin,
  tabs,
  size,
  colours,
  overlays,
  record,
  help
};

/// A thing that the program is made of, and its version.
struct AboutLine {
  std::string name, version;
};

/// Where "Why?", or its answer, stands, and what that was worked out for.
struct WhyPlace {
  struct Key {
    Cell cell;
    std::uint64_t log_id = 0;
    Camera camera;
    int width = 0, height = 0;
    bool open = false, measured = false;
    friend bool operator==(const Key&, const Key&) = default;
  };
  std::optional<Key> key;
  ImVec2 at;
};

/// What the panels share between frames; no part of the document.
struct PanelState {
  float side_width = 372;      ///< of the design; the user drags it
  float side_share = 0.34f;    ///< of the window's height, where the side stands under the world
  bool stacked = false;        ///< it does: the window is tall and narrow
  bool short_of_room = false;  ///< what has no place in one line, or one column, stands behind dots
  std::size_t panes = 0;       ///< how many the canvas shows; 0: as many as there is room for
  StepUnit unit = StepUnit::expansion;
  std::map<std::string, double> drafts;  ///< settings while their slider is dragged
  std::map<std::string, Result<PlannerPage>, std::less<>> pages;
  bool animated = false;  ///< something on it moves by itself
  double zoom = 0;        ///< device pixels per cell on the canvas, as fitted or chosen
  TabBox tabs;
  TouchedList touched;           ///< by the last replan
  KeptInReplan kept;             ///< by it, of a tree or a population
  NearestVertex nearest_vertex;  ///< to the cell that the side is about, of a tree of samples
  bool menu_open = false;        ///< that of ViewState::menu
  float why_height = 0;          ///< what that took in the last frame, in pixels
  bool why_open = false;         ///< beside the pinned cell it is told why its value is what it is
  WhyPlace why;
  std::optional<Cell> pointed;  ///< the cell of the row under the mouse, which the canvas shows as hovered
  /// The event that the run is on its way to, and how much of that is made, 0 to 1.
  struct Going {
    std::size_t event = 0;
    double share = 0;
  };
  std::optional<Going> going;
  std::string link_address = "replan.html";  ///< of the page that links lead to
  double exporting = -1;  ///< how much of a trace has been written, 0 to 1; below 0: none is being written
  std::optional<BatchProgress> batch;  ///< of the one that is at work
  ClipboardWork clipboard;
  std::shared_ptr<const CaseMoment> pasted;  ///< a moment as text, for its wish
  RecordingState recording;                  ///< told by the owner of the pixels
  PixelArea canvas;                          ///< where the canvas was drawn last
  double frame_ms = 0;                       ///< CPU time of a frame, smoothed; 0: not measured
  float tool_height = 0;                     ///< what the tool's choices took in the last frame, in pixels
  std::string said;                          ///< a sentence for the user, to be shown over the canvas
  Tone tone = Tone::done;
  std::vector<std::string> recent;             ///< files that were opened last, the latest first
  std::string wished;                          ///< the file, or the lesson, that a wish is about
  std::optional<std::vector<Lesson>> lessons;  ///< once they were asked for
  std::vector<const char*> performed;          ///< actions of this frame, by their names
  std::vector<AboutLine> about;                ///< told by the owner of the pixels
  std::optional<Menu> open_menu;               ///< to be opened, without the mouse
  bool caption = false;              ///< what the world is about is told over the canvas, if it says so
  std::vector<std::string> notices;  ///< for the Log: what the platform had to say (missing fonts)
};

/// What a panel gets. The session is read only; changes go to `commands`.
struct Frame {
  const Look& look;
  const Session& session;
  ViewState& view;
  PanelState& panels;
  std::vector<Command>& commands;
  Wish& wish;

  /// The pane that this part of the window is about; nothing: the leading one.
  std::optional<std::size_t> asked = {};

  [[nodiscard]] std::size_t pane() const { return asked.value_or(session.lead()); }
  /// The run whose planner, cells, code and figures the side shows.
  [[nodiscard]] const Run& run() const { return *session.runs()[pane()]; }
  /// The cell that the Cell panel is about: the pinned one, else the one that is or was last under the cursor; inside
  /// the world.
  [[nodiscard]] std::optional<Cell> cell() const;
  /// The pane that it is about: a pinned cell is that of the leading one, any other of the one under the cursor.
  [[nodiscard]] std::size_t cell_pane() const;
};

/// All of the window's pixels.
PixelArea whole_window();

/// A fixed part of the window: no decoration, own ground and padding.
void area(const char* id, ImVec2 pos, ImVec2 size, ImU32 ground, ImVec2 padding,
          const std::function<void()>& draw, ImGuiWindowFlags flags = 0);

/// The page of a run's planner, read once: of a pilot with the code of what plans for it.
const Result<PlannerPage>& page_of(PanelState& panels, const Run& run);
/// Differs between runs with different pages.
std::string page_name(const Run& run);
/// The replan that the cursor is in or behind: its number, and the stretch of the log up to the cursor that
/// is its own. Nothing before the first one.
struct ReplanSpan {
  std::uint64_t number = 0;
  std::size_t begin = 0, end = 0;
  bool over = false;  ///< the cursor is behind it, and not in the midst of it
};
std::optional<ReplanSpan> last_replan(const Run& run);
/// What that replan touched, read on as the log grows, a part of a long one in each frame of a window; nullptr before the
/// first one.
const TouchedList* touched_by_last_replan(Frame& frame, const Run& run);
/// Pins the cell, and moves the view there if it is out of sight.
void show_cell(Frame& frame, Cell cell);
/// Where something first went wrong: a law broken, or the oracle of another mind. Of the leading pane if it
/// has one, else of the first pane that has.
struct FirstBreach {
  std::size_t pane = 0, position = 0;
  bool law = true;  ///< else the oracle
};
std::optional<FirstBreach> first_breach(const Session& session);
/// For rows of tables that stand for a cell: while the last item is under the mouse, the canvas shows the
/// cell as if the mouse were there.
void point_at(Frame& frame, Cell cell);

/// The page's line that the latest event at the cursor belongs to; 0 before the first.
int current_line(const Run& run);

}  // namespace replan::ui
