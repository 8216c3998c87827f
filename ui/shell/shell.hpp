// The whole window: lays out the panels, hands keys to actions, and applies what they queued once all is
// drawn.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/session/autosave.hpp"
#include "ui/canvas/canvas.hpp"
#include "ui/documents/file_watch.hpp"
#include "ui/documents/recent_files.hpp"
#include "ui/documents/world_library.hpp"
#include "ui/gl/imgui_renderer.hpp"
#include "ui/shell/actions.hpp"
#include "ui/shell/command_palette.hpp"
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/world_dialogs.hpp"
#include "ui/shell/frame.hpp"
#include "ui/shell/trace_export.hpp"

namespace replan::ui {

/// What a window has around it, and a picture has not.
struct Surroundings {
  std::string state_folder;   ///< for recent files and autosaves; empty: nothing is kept
  std::string worlds_folder;  ///< the library
  WorkPlace work;             ///< how long work is done
};

class Shell {
 public:
  /// The renderer's context must be current in draw() and in the destructor.
  explicit Shell(ImGuiRenderer& renderer) : renderer_(renderer), dialogs_(renderer) {}

  /// For a window, once: from now on files are remembered and watched, and unsaved work is kept. Offers the
  /// work that an earlier program left behind.
  void settle_in(const Session& session, Surroundings surroundings);
  /// A clean end: what was not saved is not wanted.
  void leave();

  /// Draws one frame over the whole display, then applies what was asked for. The owner calls
  /// session.update().
  void draw(const Look& look, Session& session, double seconds);
  /// Whether the next frame is due at once, without any input: something plays, searches or fades.
  [[nodiscard]] bool wants_frames(const Session& session) const;

  [[nodiscard]] ViewState& view() { return view_; }
  [[nodiscard]] const ViewState& view() const { return view_; }
  [[nodiscard]] PanelState& panels() { return panels_; }
  [[nodiscard]] const PanelState& panels() const { return panels_; }

  /// Takes over what a scenario says of its view: overlays, theme, camera. The whole world is shown if it
  /// names none.
  void show(const ViewSetup& view);
  /// What the window is about: "maze.json", with a mark if there are unsaved edits.
  [[nodiscard]] static std::string title(const Session& session);
  /// The session's own words if they need characters that the fonts do not hold at first: for
  /// Stage::set_language().
  [[nodiscard]] static std::string words(const Session& session, const std::string& also = {});
  /// Names of files and worlds that menus and dialogs show, for words().
  [[nodiscard]] std::string names_on_show() const;
  /// Opens a file; asks first if there are unsaved edits.
  void open(Session& session, const std::string& path);
  /// Takes what was dropped onto the window: opens a file, looks into a folder, or says why not.
  void drop(Session& session, const std::vector<std::string>& paths);
  /// The user wants to close the window. True if it may close now; else the user is asked.
  bool may_close(const Session& session);
  /// The user has decided to quit.
  [[nodiscard]] bool quitting() const { return quitting_; }
  /// What the user wants filmed or pictured, once; its path is as typed_path() makes it.
  std::optional<CaptureRequest> take_capture() { return std::exchange(capture_, std::nullopt); }
  /// Does what the action does, in the next frame; nothing if it is not available then.
  void perform_next(ActionId id) { next_actions_.push_back(id); }
  /// A sentence over the canvas for a while.
  void tell(std::string sentence, bool bad);

 private:
  /// What happens once unsaved edits are dealt with.
  struct Pending {
    enum class Kind : std::uint8_t {
      none,
      open_dialog,
      open_file,
      worlds_dialog,
      open_world,
      new_world,
      pasted,
      quit
    } kind = Kind::none;
    std::string path;  ///< of the file, or of the folder that the dialog begins with
  };
  /// A document on its way from its file.
  struct Loading {
    enum class From : std::uint8_t { file, library, autosave } from = From::file;
    std::string path;
    MapReading reading;
    std::size_t orphan = 0;  ///< for autosave: which of orphans_
  };
  struct Loaded {
    Loading what;
    Result<ReplaceScenario> document;
    std::vector<StampedFile> files;
  };
  /// A position that a run has yet to come to.
  struct Awaited {
    std::uint64_t log = 0;  ///< Run::log_id(); another one: somebody has gone another way
    std::size_t event = 0;
    std::uint64_t state = 0;  ///< SearchState::hash() there
    bool sent = false;        ///< the run was sent on towards it
  };
  struct Message {
    std::string text;
    bool bad = false;
    std::chrono::steady_clock::time_point until;
  };

  void draw_parts(Frame& frame);
  Canvas& canvas(std::size_t pane);
  void fit();
  void draw_canvas(Frame& frame, ImVec2 min, ImVec2 max);
  void draw_message(const Look& look, ImVec2 min, ImVec2 max);
  void draw_splitter(Frame& frame, float x, float top, float bottom);
  void take_keys(Frame& frame);
  void pin_difference(Frame& frame);
  void take_commands(Session& session, std::vector<Command>& commands);
  void take_wish(Session& session, Wish wish);
  void ask_for_capture(bool film, bool window);
  void ask_for_trace(const Session& session);
  void export_trace(const Session& session, const Decision& decision);
  void go_to_pasted(Session& session);
  void await_moment(Session& session);
  void take_decision(Session& session, const Decision& decision);
  void begin(Session& session, Pending pending);
  void go_on(Session& session);
  void choose_open(const Session& session, const std::string& path);
  void choose_save(const Session& session);
  void choose_figures_file();
  void save_figures(const Session& session, const std::string& path);
  [[nodiscard]] std::vector<Place> places() const;
  void save_in_place(Session& session);
  bool save(Session& session, const std::string& path);
  void note(const std::vector<std::string>& notes);
  void complain(const std::string& sentence);
  void replace(Session& session, ReplaceScenario document);
  [[nodiscard]] Question unsaved_question(const Session& session) const;

  void load(Session& session, Loading what);
  void take_loaded(Session& session);
  void keep(Session& session);
  void look_at_disk(const Session& session);
  void remember(const std::string& path);
  void offer_orphans();
  void draw_caption(Frame& frame, ImVec2 min, ImVec2 size);

  ImGuiRenderer& renderer_;
  std::vector<std::unique_ptr<Canvas>> canvases_;  // by pane
  ViewState view_;
  PanelState panels_;
  Surroundings surroundings_;
  std::unique_ptr<WorldLibrary> library_;
  Dialogs dialogs_;  // after the library that it shows
  WorldDialogs world_dialogs_;
  CommandPalette palette_;
  Pending pending_;
  std::unique_ptr<Background<Loaded>> loader_ = std::make_unique<Background<Loaded>>();
  std::unique_ptr<Autosaver> autosave_ = std::make_unique<Autosaver>();
  std::vector<Orphan> orphans_;
  RecentFiles recent_;
  FileWatch watch_;
  MapReading reading_;         // how the document's file was read
  bool disk_differs_ = false;  // the user keeps another version than the file's
  std::chrono::steady_clock::time_point looked_at_disk_;
  std::int64_t unsaved_since_ = 0;  // seconds since 1970; 0: all is saved
  Message message_;
  TraceExport export_;
  std::optional<Awaited> awaited_;
  CaptureRequest asked_;  // while its dialog is open
  std::optional<CaptureRequest> capture_;
  std::vector<ActionId> next_actions_;
  std::string pinned_difference_;  // its sentence
  bool quitting_ = false;
  bool saving_figures_ = false;  // the file dialog asks for the file of the figures
  bool held_ = false;            // a key that repeats is down
  std::uint64_t drawn_ = 0;      // the session's revision that the last frame showed
};

}  // namespace replan::ui
