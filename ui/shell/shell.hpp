// The whole window: lays out the panels, hands keys to actions, and applies what they queued once all is
// drawn.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/batch/batch_dialog.hpp"
#include "ui/canvas/panes.hpp"
#include "ui/documents/documents.hpp"
#include "ui/gl/imgui_renderer.hpp"
#include "ui/shell/actions.hpp"
#include "ui/shell/arrival.hpp"
#include "ui/shell/command_palette.hpp"
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/world_dialogs.hpp"
#include "ui/shell/frame.hpp"
#include "ui/shell/frame_share.hpp"
#include "ui/shell/lesson_card.hpp"
#include "ui/shell/links.hpp"
#include "ui/shell/message.hpp"
#include "ui/shell/trace_export.hpp"

namespace replan::ui {

class Shell {
 public:
  /// The renderer's context must be current in draw() and in the destructor.
  explicit Shell(ImGuiRenderer& renderer);

  /// Draws one frame over the whole display, then applies what was asked for. The owner calls
  /// session.update().
  void draw(const Look& look, Session& session, double seconds);
  /// Whether the next frame is due at once, without any input: something plays, searches or fades.
  [[nodiscard]] bool wants_frames(const Session& session) const;

  /// In step: how many milliseconds the next session.update() may take, if drawing takes so many.
  [[nodiscard]] double work_share(const Session& session, double drawing_ms) const {
    return share_.of(session, drawing_ms);
  }

  [[nodiscard]] ViewState& view() { return view_; }
  [[nodiscard]] const ViewState& view() const { return view_; }
  [[nodiscard]] PanelState& panels() { return panels_; }
  [[nodiscard]] const PanelState& panels() const { return panels_; }
  [[nodiscard]] Documents& documents() { return documents_; }
  [[nodiscard]] const LessonCard& lesson() const { return lesson_; }
  [[nodiscard]] const BatchDialog& batch() const { return batch_; }

  /// Takes over what a scenario says of its view: overlays, theme, camera. The whole world is shown if it
  /// names none.
  void show(const Scenario& world);
  /// What the user wants filmed or pictured, once; its path is as typed_path() makes it.
  std::optional<CaptureRequest> take_capture() { return std::exchange(capture_, std::nullopt); }
  /// Does what the action does, in the next frame; nothing if it is not available then.
  void perform_next(ActionId id) { next_actions_.push_back(id); }
  /// Shows the dialog or menu of that name (gallery.hpp), for a picture; false if there is none.
  bool show_dialog(std::string_view name, const Session& session);
  /// Shows the batch dialog with an experiment's file, or with the folder of results that a file is of.
  void show_batch(const Session& session, const std::string& path);
  /// At the very first start: the first lesson, unless the user is asked something.
  void welcome();
  /// A sentence over the canvas for a while.
  void tell(std::string sentence, bool bad) { message_.tell(std::move(sentence), bad); }
  /// Opens the world of a link at its moment, as Documents::open() does a file.
  void open_link(Session& session, const std::string& link) { documents_.open(session, link); }
  /// Goes to the moment of a link whose world the session has been made with.
  void follow_link(Session& session, const LinkView& view);
  /// The link to what shows, the address of a page before it: all of it at once, however long the run.
  [[nodiscard]] Result<std::string> link(const Session& session) const;
  /// What stands over the canvas; empty: nothing.
  [[nodiscard]] const std::string& told() const { return message_.sentence(); }

 private:
  /// What was playing when a dialog came up.
  struct Paused {
    int direction = 0;
    std::uint64_t log = 0;  ///< Run::log_id()
  };

  void draw_parts(Frame& frame);
  // Those of a tall, narrow window (stacked.cpp).
  void draw_stacked(Frame& frame);
  float stacked_words(Frame& frame, ImVec2 corner, float width);
  void draw_level_splitter(Frame& frame, float top, float bottom, float foot);
  void draw_menu(Frame& frame, ImVec2 corner, float width);
  void draw_status(Frame& frame, ImVec2 corner, float width);
  void fit();
  void draw_canvas(Frame& frame, ImVec2 min, ImVec2 max);
  void draw_splitter(Frame& frame, float x, float top, float bottom);
  void take_keys(Frame& frame);
  void pause_behind_dialogs(Session& session);
  void pin_difference(Frame& frame);
  void take_commands(Session& session, std::vector<Command>& commands);
  void take_wish(Session& session, Wish wish);
  void open_lesson(Session& session, const std::string& id);
  void follow_lesson(const Session& session);
  void ask_for_capture(const Session& session, bool film, bool window);
  void ask_for_trace(const Session& session);
  void export_trace(const Session& session, const DialogDecision& decision);
  void draw_batch(const Look& look);
  void choose_experiment(bool saving);
  void choose_batch_folder();
  void go_on_with_batch(Session& session);
  void go_to_pasted(Session& session);
  void go_on_to_moment(Session& session);
  void ask_for_link(const Session& session);
  void go_on_with_link(const Session& session);
  void take_copied_link(const std::string& link);
  void take_decision(Session& session, const DialogDecision& decision);
  void draw_caption(Frame& frame, ImVec2 min, ImVec2 size);
  /// Whether a dialog has the hands and the eyes.
  [[nodiscard]] bool covered() const { return dialogs_.open() || world_dialogs_.open() || batch_.open(); }

  Panes panes_;
  ViewState view_;
  PanelState panels_;
  Message message_;
  Documents documents_;
  Dialogs dialogs_;  // after the library that it shows
  WorldDialogs world_dialogs_;
  BatchDialog batch_;
  CommandPalette palette_;
  std::optional<ActionId> let_go_;  // to be done once its key is let go
  std::optional<Paused> paused_;
  FrameShare share_;
  LessonCard lesson_;
  TraceExport export_;
  Arrival arrival_;
  std::unique_ptr<LinkCopy> link_copy_;
  CaptureRequest asked_;  // while its dialog is open
  std::optional<CaptureRequest> capture_;
  std::vector<ActionId> next_actions_;
  std::string pinned_difference_;  // its sentence
  bool held_ = false;              // a key that repeats is down
  std::uint64_t drawn_ = 0;        // the session's revision that the last frame showed
};

}  // namespace replan::ui
