// The document of a window, from the files' side: it is opened and saved, what is unsaved is kept, the files that were
// opened last are remembered, and those behind it are watched.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/link/link.hpp"
#include "core/session/autosave.hpp"
#include "ui/documents/file_watch.hpp"
#include "ui/documents/recent_files.hpp"
#include "ui/documents/world_library.hpp"
#include "ui/shell/dialogs.hpp"
#include "ui/shell/frame.hpp"
#include "ui/shell/message.hpp"

namespace replan::ui {

/// What a window has around it, and a picture has not.
struct Surroundings {
  std::string state_folder;   ///< for recent files and autosaves; empty: nothing is kept
  std::string worlds_folder;  ///< the library
  WorkPlace work;             ///< how long work is done
  SystemFiles files = {};     ///< what the system does with files itself
};

class Documents {
 public:
  /// What it shares with its window, which it lives in.
  struct Window {
    ViewState& view;
    PanelState& panels;
    Dialogs& dialogs;
    Message& message;
    /// Takes over what a scenario says of its view.
    std::function<void(const Scenario& world)> show;
    /// Shows an experiment, or results of one: such a file is no document.
    std::function<void(const Session& session, const std::string& path)> show_batch;
    /// Goes to the moment of a link whose world was just opened, and looks at what it says.
    std::function<void(Session& session, const LinkView& view)> follow_link;
  };
  using Deed = std::function<void(Session& session)>;

  explicit Documents(Window window) : window_(std::move(window)) {}

  /// For a window, once: from now on files are remembered and watched, and unsaved work is kept. Offers the work that
  /// an earlier program left behind.
  void settle_in(const Session& session, Surroundings surroundings);
  /// A clean end: what was not saved is not wanted.
  void leave() { autosave_->remove(); }

  /// Opens a file, or the world of a link at its moment; asks first if there are unsaved edits.
  void open(Session& session, const std::string& path);
  /// Takes what was dropped onto the window: opens a file, looks into a folder, or says why not.
  void drop(Session& session, const std::vector<std::string>& paths);
  /// The user wants to close the window. True if it may close now; else the user is asked.
  bool may_close(Session& session);
  /// The user has decided to quit.
  [[nodiscard]] bool quitting() const { return quitting_; }

  // What the window asks for and the user decides, as far as it is about documents.
  void take_wish(Session& session, Wish wish);
  void take_decision(Session& session, const DialogDecision& decision);
  /// Does it once unsaved edits are dealt with.
  void after_saving(Session& session, Deed deed);
  void quit(Session& session);
  [[nodiscard]] bool makes_file() const;
  /// The document as it is now is not worth keeping: nobody is asked about its edits.
  void disregard_edits(const Session& session) { disregarded_ = session.document_state(); }
  /// Another document, without a question.
  void replace(Session& session, ReplaceScenario document);

  // Once a frame.
  void take_loaded(Session& session);
  void keep(Session& session);

  /// Where something else that is written goes at first: of that name, in the folder, or in the last one.
  [[nodiscard]] FileDialogSpec place_for(const std::string& name, const std::string& folder = {}) const;
  /// Where the results of a batch in this world go at first: beside its file, else among what the program keeps. One that was
  /// stopped is gone on with; one that is done is left alone.
  [[nodiscard]] std::string batch_folder(const Session& session) const;
  [[nodiscard]] const WorkPlace& work() const { return surroundings_.work; }

  /// nullptr before it has settled in.
  [[nodiscard]] WorldLibrary* library() const { return library_.get(); }
  /// Names of files and worlds that menus and dialogs show, for uncommon_words().
  [[nodiscard]] std::string names_on_show() const;

 private:
  /// A document on its way from its file.
  struct Loading {
    enum class From : std::uint8_t { file, library, autosave, link } from = From::file;
    std::string path;  ///< or the link
    MapReading reading;
    std::size_t orphan = 0;  ///< for autosave: which of orphans_
  };
  struct Loaded {
    Loading what;
    Result<ReplaceScenario> document;
    std::vector<StampedFile> files;
    LinkView view = {};                   ///< for link
    std::vector<std::string> notes = {};  ///< likewise
  };

  [[nodiscard]] bool would_lose_edits(const Session& session) const;
  void ask_about_unsaved(const Session& session);
  void go_on(Session& session);
  void choose_open(const Session& session, const std::string& path);
  void choose_save(const Session& session);
  void choose_figures_file();
  void save_figures(const Session& session, const std::string& path);
  [[nodiscard]] std::string last_folder() const;
  [[nodiscard]] std::vector<Place> places() const;
  void save_in_place(Session& session);
  bool save(Session& session, const std::string& path);
  void save_and_go_on(Session& session, const std::string& path);
  void note(const std::vector<std::string>& notes);
  void complain(const std::string& sentence);
  void load(Session& session, Loading what);
  void load_next(Session& session, Loading what);
  [[nodiscard]] static Loaded load_link(const Loading& what);
  void take_link(Session& session, Loaded loaded);
  void take_recovered(Session& session, const Loading& what, ReplaceScenario document);
  void look_at_disk(const Session& session);
  void remember(const std::string& path);
  void offer_orphans();
  void give_up();

  Window window_;
  Surroundings surroundings_;
  std::unique_ptr<WorldLibrary> library_;
  Deed deed_;  // for when unsaved edits are dealt with
  /// What is done with the file that was chosen to be written.
  std::function<void(Session& session, const std::string& path)> write_;
  std::unique_ptr<Background<Loaded>> loader_ = std::make_unique<Background<Loaded>>();
  std::unique_ptr<Autosaver> autosave_ = std::make_unique<Autosaver>();
  std::vector<Orphan> orphans_;
  RecentFiles recent_;
  FileWatch watch_;
  MapReading reading_;         // how the document's file was read
  bool disk_differs_ = false;  // the user keeps another version than the file's
  std::chrono::steady_clock::time_point looked_at_disk_;
  std::int64_t unsaved_since_ = 0;            // seconds since 1970; 0: all is saved
  std::optional<std::uint64_t> disregarded_;  // Session::document_state() of what nobody wants to keep
  bool quitting_ = false;
};

}  // namespace replan::ui
