// The window's dialogs: one at a time, over everything else.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/plan/step_words.hpp"
#include "core/session/autosave.hpp"
#include "ui/shell/dialogs/file_dialog.hpp"
#include "ui/shell/dialogs/film_form.hpp"
#include "ui/shell/dialogs/world_picker.hpp"
#include "ui/shell/frame.hpp"

namespace replan::ui {

enum class DialogKind : std::uint8_t {
  none,
  file,
  worlds,
  opening,
  new_world,
  question,
  recover,
  keys,
  link,
  about
};

/// What the user decided.
struct DialogDecision {
  enum class Kind : std::uint8_t {
    none,
    open,
    open_world,  ///< of the library: its file is not the user's own
    save,
    save_elsewhere,
    new_world,
    capture,
    export_trace,
    open_experiment,
    save_experiment,
    batch_folder,
    save_first,
    discard,
    overwrite,
    reload,
    keep_mine,
    recover,
    forget,
    copy_link,  ///< its path is the whole link
    cancel
  } kind = Kind::none;
  std::string path = {};    ///< for whatever is opened or written
  MapReading reading = {};  ///< for open
  int width = 0;            ///< for new_world
  int height = 0;
  int layers = 1;
  FilmChoice film = {};   ///< for capture of a film
  std::size_t index = 0;  ///< for recover and forget: which of those on offer
  bool map = false;       ///< for export_trace: its map too
};

/// What the page of keys calls an action of that label, with the words of the leading planner for its steps.
std::string words_on_keys_page(const std::string& label, const StepWords& step);

/// What there is to write of a run.
struct TraceFacts {
  std::size_t events = 0;
  std::size_t steps = 0, bytes = 0;  ///< of a trace for Posthoc, about
};

/// A question with two or three answers.
struct Question {
  struct Choice {
    std::string label;
    DialogDecision::Kind decision = DialogDecision::Kind::cancel;
  };
  std::string title, words;
  Choice primary;                     ///< also by Enter
  Choice quiet = {"Cancel"};          ///< also by Escape; without a label by that alone
  std::optional<Choice> danger = {};  ///< what loses something; apart from the others
};

/// What the system that the program runs on does with files, where that is not as on a desktop.
struct SystemFiles {
  /// Its own way to choose a file to be opened, which then comes as if it were dropped; empty: the program's dialog.
  std::function<void(const std::vector<FileFilter>& filters)> pick;
  /// What films are written as.
  std::vector<FileFilter> films = {{"Film (.gif)", {".gif"}},
                                   {"Film (.webp)", {".webp"}},
                                   {"Film (.mp4)", {".mp4"}},
                                   {"Numbered pictures in a folder", {"/"}}};
};

class Dialogs {
 public:
  explicit Dialogs(ImGuiRenderer& renderer) : renderer_(renderer) {}

  void set_system(SystemFiles system) { system_ = std::move(system); }
  /// The extension of a film whose user has not chosen another.
  [[nodiscard]] const std::string& film_extension() const { return system_.films.front().extensions.front(); }

  // Each is shown at the next draw.
  void show(DialogKind kind);
  void ask(Question question);
  /// What is decided on is `decision`; none: to open, or to save.
  void choose_file(FileDialogSpec spec, const WorkPlace& place,
                   DialogDecision::Kind decision = DialogDecision::Kind::none);
  void choose_world(WorldLibrary& library);
  void offer(std::vector<AutosaveNote> notes);
  /// The page of keys; the planner that leads calls its steps so.
  void show_keys(const StepWords& step);
  void show_about(std::vector<AboutLine> lines);
  // Each asks where it goes; `spec` says where to begin.
  void ask_picture(bool window, FileDialogSpec spec, const WorkPlace& place);
  /// And what it shows of the session, which has to outlive the dialog; `area` is what there is to be filmed.
  /// choose_part() proposes what it is of.
  void choose_part(FilmPart part) { film_.choose(part); }
  void ask_film(const Session& session, bool window, const PixelArea& area, FileDialogSpec spec,
                const WorkPlace& place);
  /// Asks where a trace goes.
  void ask_trace(const TraceFacts& facts, FileDialogSpec spec, const WorkPlace& place);
  /// Shows a link to the moment, once take_link() has brought it; `address` stands before it, and can be edited.
  void show_link(std::string address);
  void take_link(Result<std::string> link) { link_ = std::move(link); }
  /// As it stands in that dialog, or stood there last.
  [[nodiscard]] const std::string& link_address() const { return link_address_; }
  [[nodiscard]] bool shows_link() const { return kind_ == DialogKind::link; }
  /// Tells that a file is being read, once that takes longer than a moment.
  void wait_for(std::string name);

  void close();
  /// Shows a sentence in the dialog that led here: what went wrong, and what now. False if there is none.
  bool complain(const std::string& sentence);
  [[nodiscard]] bool open() const { return kind_ != DialogKind::none; }
  /// Whether something moves in the open dialog.
  [[nodiscard]] bool animated() const {
    return kind_ == DialogKind::opening || (shows_link() && !link_) || unsettled_ > 0;
  }
  /// Where the last file dialog stood; empty if there was none.
  [[nodiscard]] const std::string& folder() const { return folder_; }
  /// What stands in the open dialog besides the program's own words, for the fonts.
  [[nodiscard]] std::string words() const;

  /// Draws the open dialog, if any, and returns what was decided in this frame.
  DialogDecision draw(const Look& look);

 private:
  void begin(DialogKind kind);
  DialogDecision content(const Look& look);
  DialogDecision file_dialog(const Look& look, float height);
  DialogDecision world_dialog(const Look& look, float height);
  void trace_options(const Look& look, const std::string& name);
  DialogDecision new_world_dialog(const Look& look);
  DialogDecision question_dialog(const Look& look);
  DialogDecision recover_dialog(const Look& look);
  DialogDecision opening_dialog(const Look& look);
  DialogDecision keys_dialog(const Look& look);
  DialogDecision about_dialog(const Look& look);
  DialogDecision link_dialog(const Look& look);
  void draw_link_address(const Look& look);

  ImGuiRenderer& renderer_;
  SystemFiles system_;
  DialogKind kind_ = DialogKind::none;
  int lists_ = 0;                                   // that were open over the dialog in the last frame
  int unsettled_ = 0;                               // frames that a list needs to show, without any input
  bool fresh_ = false;                              // to be opened by this draw
  std::unique_ptr<FileDialog> file_, closed_file_;  // a closed one holds textures that are still to be drawn
  std::unique_ptr<WorldPicker> worlds_, closed_worlds_;
  Question question_;
  std::vector<AutosaveNote> notes_;
  std::vector<AboutLine> about_;
  std::string name_;   // of what is being opened
  double since_ = -1;  // when it was first drawn, in ImGui's seconds; below 0: not yet
  std::string folder_;
  double width_ = 48, height_ = 32, layers_ = 1;  // of the new world
  DialogDecision::Kind file_decision_ = DialogDecision::Kind::none;
  FilmForm film_;
  TraceFacts trace_facts_;
  bool trace_map_ = true;  // what was chosen last
  StepWords step_ = kExpansionWords;
  std::string link_address_;
  std::optional<Result<std::string>> link_;  // nothing while it is being made
  float page_height_ = 2000;                 // of the keys, as drawn last
};

}  // namespace replan::ui
