// What the shell does with wishes and decisions about documents: opening, saving, asking, and saying how it
// went.
#include <algorithm>
#include <filesystem>

#include "core/base/file.hpp"
#include "core/world/map_file.hpp"
#include "ui/documents/files.hpp"
#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/shell.hpp"
#include "ui/tabs/figures.hpp"

namespace replan::ui {
namespace {

constexpr auto kMessageTime = std::chrono::seconds(6), kErrorTime = std::chrono::seconds(15);

std::vector<FileFilter> filters_to_open() {
  FileFilter worlds{"Worlds: scenarios and maps", {".json"}}, maps{"Maps", {}}, pictures{"Pictures", {}};
  for (const MapFormat& format : map_formats()) {
    if (format.solid) continue;
    worlds.extensions.emplace_back(format.extension);
    (format.picture ? pictures : maps).extensions.emplace_back(format.extension);
  }
  return {worlds, {"Scenarios (.json)", {".json"}}, maps, pictures, {"All files", {}}};
}

std::vector<FileFilter> filters_to_save() {
  std::vector<FileFilter> filters = {{"Scenario (.json)", {".json"}}};
  for (const MapFormat& format : map_formats()) {
    // .yml is the same as .yaml.
    if (format.write == nullptr || format.solid || format.extension == ".yml") continue;
    std::string name(format.name);
    if (name.front() >= 'a' && name.front() <= 'z')
      name.front() = static_cast<char>(name.front() - 'a' + 'A');
    filters.push_back({name + " (" + std::string(format.extension) + ")", {std::string(format.extension)}});
  }
  return filters;
}

}  // namespace

void Shell::take_wish(Session& session, Wish wish) {
  switch (wish) {
    case Wish::none:
      break;
    case Wish::new_world:
      begin(session, {Pending::Kind::new_world, {}});
      break;
    case Wish::open:
      begin(session, {Pending::Kind::open_dialog, {}});
      break;
    case Wish::worlds:
      begin(session, {Pending::Kind::worlds_dialog, {}});
      break;
    case Wish::recent:
      open(session, panels_.wished);
      break;
    case Wish::forget_recent:
      static_cast<void>(recent_.clear());
      panels_.recent.clear();
      break;
    case Wish::quit:
      begin(session, {Pending::Kind::quit, {}});
      break;
    case Wish::palette:
      if (library_) library_->refresh();
      palette_.show();
      break;
    case Wish::open_world:
      begin(session, {Pending::Kind::open_world, panels_.wished});
      break;
    case Wish::save_figures:
      choose_figures_file();
      break;
    case Wish::save:
      save_in_place(session);
      break;
    case Wish::save_as:
      choose_save(session);
      break;
    case Wish::fit:
      fit();
      break;
    case Wish::generate:
      world_dialogs_.show_generate(session);
      break;
    case Wish::resize:
      world_dialogs_.show_resize(session);
      break;
    case Wish::keys:
      dialogs_.show(DialogKind::keys);
      break;
    case Wish::record_canvas:
    case Wish::record_window:
      ask_for_capture(true, wish == Wish::record_window);
      break;
    case Wish::export_trace:
      ask_for_trace(session);
      break;
    case Wish::stop_export:
      export_.cancel();
      tell("The trace was not written", false);
      break;
    case Wish::go_to_pasted:
      begin(session, {Pending::Kind::pasted, {}});
      break;
    case Wish::picture_canvas:
    case Wish::picture_window:
      ask_for_capture(false, wish == Wish::picture_window);
      break;
  }
}

/// A film that is being recorded ends; anything else is asked for by its name.
void Shell::ask_for_capture(bool film, bool window) {
  asked_ = {film ? CaptureRequest::Kind::film : CaptureRequest::Kind::picture, window, {}, 0};
  if (film && panels_.recording.on) {
    capture_ = {CaptureRequest::Kind::stop, window, {}, 0};
    return;
  }
  dialogs_.ask_capture(film, capture_name(film ? ".gif" : ".png"));
}

void Shell::take_decision(Session& session, const Decision& decision) {
  switch (decision.kind) {
    case Decision::Kind::none:
      break;
    case Decision::Kind::cancel:
      loader_->cancel();
      dialogs_.close();
      saving_figures_ = false;
      orphans_.clear();  // their locks with them: the next program offers them again
      pending_ = {};
      break;
    case Decision::Kind::open:
      load(session, {Loading::From::file, decision.path, decision.reading});
      break;
    case Decision::Kind::open_world:
      load(session, {Loading::From::library, decision.path, {}});
      break;
    case Decision::Kind::save:
      if (saving_figures_) {
        save_figures(session, decision.path);
        break;
      }
      if (!save(session, decision.path)) break;
      dialogs_.close();
      go_on(session);
      break;
    case Decision::Kind::new_world:
      replace(session, {empty_world(decision.width, decision.height, session.scenario()), ""});
      break;
    case Decision::Kind::capture:
      capture_ = asked_;
      capture_->path = typed_path(decision.path);
      capture_->fps = decision.fps;
      message_ = {};  // or it would be in the picture
      break;
    case Decision::Kind::export_trace:
      export_trace(session, decision);
      break;
    case Decision::Kind::discard:
      go_on(session);
      break;
    case Decision::Kind::save_first:
      save_in_place(session);
      break;
    case Decision::Kind::save_elsewhere:
      choose_save(session);
      break;
    case Decision::Kind::overwrite:
      if (save(session, session.file())) go_on(session);
      break;
    case Decision::Kind::reload:
      load(session, {Loading::From::file, session.file(), reading_});
      break;
    case Decision::Kind::keep_mine:
      disk_differs_ = disk_differs_ || watch_.changed() == session.file();
      watch_.accept();
      break;
    case Decision::Kind::recover:
      load(session, {Loading::From::autosave, orphans_[decision.index].path, {}, decision.index});
      break;
    case Decision::Kind::forget:
      discard(std::move(orphans_[decision.index]));
      orphans_.erase(orphans_.begin() + static_cast<std::ptrdiff_t>(decision.index));
      offer_orphans();
      break;
  }
}

Question Shell::unsaved_question(const Session& session) const {
  const std::size_t count = session.unsaved_edits();
  std::string words =
      document_name(session) + " has " + count_text(static_cast<std::int64_t>(count), "edit", "edits");
  if (unsaved_since_ != 0) words += " since " + date_text(unsaved_since_);
  words += count == 1 ? " that is not in a file yet. Without saving it is lost."
                      : " that are not in a file yet. Without saving they are lost.";
  return {.title = "Save the changes?",
          .words = words,
          .primary = {"Save", Decision::Kind::save_first},
          .danger = Question::Choice{"Discard", Decision::Kind::discard}};
}

void Shell::begin(Session& session, Pending pending) {
  pending_ = std::move(pending);
  if (session.modified())
    dialogs_.ask(unsaved_question(session));
  else
    go_on(session);
}

void Shell::go_on(Session& session) {
  const Pending pending = std::exchange(pending_, {});
  switch (pending.kind) {
    case Pending::Kind::none:
      break;
    case Pending::Kind::open_dialog:
      choose_open(session, pending.path);
      break;
    case Pending::Kind::open_file:
      load(session, {Loading::From::file, pending.path, {}});
      break;
    case Pending::Kind::worlds_dialog:
      if (library_) dialogs_.choose_world(*library_);
      break;
    case Pending::Kind::open_world:
      load(session, {Loading::From::library, pending.path, {}});
      break;
    case Pending::Kind::new_world:
      dialogs_.show(DialogKind::new_world);
      break;
    case Pending::Kind::pasted:
      go_to_pasted(session);
      break;
    case Pending::Kind::quit:
      quitting_ = true;
      break;
  }
}

std::vector<Place> Shell::places() const {
  std::vector<Place> places;
  if (const std::string home = typed_path("~"); home != "~") places.push_back({icon::home, "Home", home});
  places.push_back(
      {icon::terminal, "Current folder", typed_from("/", std::filesystem::current_path().string())});
  if (library_) places.push_back({icon::map, "Worlds", library_->folder()});
  for (const std::string& folder : recent_.folders()) {
    const bool known =
        std::any_of(places.begin(), places.end(), [&](const Place& p) { return p.path == folder; });
    if (!known && places.size() < 10) places.push_back({icon::clock, file_name(folder), folder});
  }
  return places;
}

void Shell::choose_open(const Session& session, const std::string& path) {
  const std::string file = session.file().empty() ? "" : file_folder(session.file());
  dialogs_.choose_file({.title = "Open",
                        .action = "Open",
                        .filters = filters_to_open(),
                        .path = !path.empty()                ? path
                                : !dialogs_.folder().empty() ? dialogs_.folder()
                                                             : file,
                        .places = places(),
                        .losses = {}},
                       surroundings_.work);
}

void Shell::choose_save(const Session& session) {
  saving_figures_ = false;
  std::string name = session.file();
  if (name.empty()) {
    const std::vector<std::string> folders = recent_.folders();
    const std::string folder = !dialogs_.folder().empty() ? dialogs_.folder()
                               : folders.empty()          ? "."
                                                          : folders.front();
    name = folder + "/" + (session.scenario().name.empty() ? "world" : session.scenario().name) + ".json";
  } else if (!saves_in_place(name)) {
    name = file_folder(name) + "/" + file_stem(name) + ".json";
  }
  dialogs_.choose_file(
      {.saving = true,
       .title = "Save as",
       .action = "Save",
       .filters = filters_to_save(),
       .path = name,
       .places = places(),
       .losses = [scenario = session.snapshot()](
                     const std::string& extension) { return lost_in(extension, *scenario); }},
      surroundings_.work);
}

void Shell::choose_figures_file() {
  std::vector<FileFilter> filters;
  for (const FiguresFormatInfo& format : figures_formats())
    filters.push_back({std::string(format.name) + " (" + format.extension + ")", {format.extension}});
  const std::vector<std::string> folders = recent_.folders();
  const std::string folder = !dialogs_.folder().empty() ? dialogs_.folder()
                             : folders.empty()          ? "."
                                                        : folders.front();
  saving_figures_ = true;
  dialogs_.choose_file({.saving = true,
                        .title = "Save the figures",
                        .action = "Save",
                        .filters = std::move(filters),
                        .path = folder + "/figures.csv",
                        .places = places(),
                        .losses = {}},
                       surroundings_.work);
}

/// In the format that the name ends in.
void Shell::save_figures(const Session& session, const std::string& path) {
  for (const FiguresFormatInfo& format : figures_formats()) {
    if (file_extension(path) != format.extension) continue;
    const auto done = write_file_atomically(path, figures_text(format.format, panels_.tabs.get<FiguresTab>().now(session)));
    if (!done) return complain(done.error());
    saving_figures_ = false;
    dialogs_.close();
    return tell("Saved " + file_name(path), false);
  }
  complain("the name of the figures' file must end in .csv, .json, .md or .tex");
}

/// To its own file if that can hold it and nobody else has written it meanwhile; else the user is asked.
void Shell::save_in_place(Session& session) {
  if (!saves_in_place(session.file())) {
    choose_save(session);
  } else if (disk_differs_ || watch_.changed() == session.file()) {
    dialogs_.ask({.title = "Write over the other version?",
                  .words = file_name(session.file()) +
                           " was written by another program since it was opened here. Saving puts your "
                           "version in its place.",
                  .primary = {"Save as…", Decision::Kind::save_elsewhere},
                  .danger = Question::Choice{"Overwrite", Decision::Kind::overwrite}});
  } else if (save(session, session.file())) {
    go_on(session);
  }
}

bool Shell::save(Session& session, const std::string& path) {
  const Result<void> done = save_document(session, view_, path);
  if (!done) {
    complain(done.error());
    return false;
  }
  session.saved(path);
  disk_differs_ = false;
  watch_.watch({stamped(path)});
  remember(path);
  tell("Saved " + file_name(path), false);
  return true;
}

void Shell::replace(Session& session, ReplaceScenario document) {
  show(document.scenario.view);
  watch_.watch({});
  disk_differs_ = false;
  reading_ = {};
  if (const Result<void> done = session.apply(std::move(document)); !done) tell(done.error(), true);
}

std::string Shell::names_on_show() const {
  std::string names = dialogs_.words();
  for (const std::string& path : panels_.recent) names += path;
  return names;
}

std::string Shell::words(const Session& session, const std::string& also) {
  const std::string words = session.scenario().name + session.scenario().caption + session.file() + also;
  // Bytes from 0xE3 on begin characters of East Asia and beyond; all below are in the fonts at any time.
  const auto is_wide = [](char c) { return static_cast<unsigned char>(c) >= 0xE3; };
  return std::any_of(words.begin(), words.end(), is_wide) ? words : "";
}

std::string Shell::title(const Session& session) {
  return document_name(session) + (session.modified() ? " — edited" : "");
}

void Shell::open(Session& session, const std::string& path) {
  begin(session, {Pending::Kind::open_file, path});
}

void Shell::drop(Session& session, const std::vector<std::string>& paths) {
  const Dropped dropped = sort_out(paths);
  if (!dropped.sentence.empty()) tell(dropped.sentence, dropped.path.empty());
  if (dropped.path.empty() || dialogs_.open()) return;
  begin(session, {dropped.folder ? Pending::Kind::open_dialog : Pending::Kind::open_file, dropped.path});
}

bool Shell::may_close(const Session& session) {
  if (quitting_ || !session.modified()) return true;
  pending_ = {Pending::Kind::quit, {}};
  dialogs_.ask(unsaved_question(session));
  return false;
}

/// In the dialog that the user is looking at, else over the canvas and in the Log.
void Shell::complain(const std::string& sentence) {
  if (dialogs_.complain(as_sentence(sentence))) return;
  dialogs_.close();
  panels_.notices.push_back(sentence);
  tell(sentence, true);
}

/// What the reader of a document has to say: all of it in the Log, the first of it over the canvas too.
void Shell::note(const std::vector<std::string>& notes) {
  panels_.notices.insert(panels_.notices.end(), notes.begin(), notes.end());
  if (!notes.empty()) tell(notes.front(), false);
}

void Shell::tell(std::string sentence, bool bad) {
  if (sentence.empty()) return;
  const auto time = bad ? std::chrono::duration_cast<std::chrono::seconds>(kErrorTime) : kMessageTime;
  message_ = {as_sentence(std::move(sentence)), bad, std::chrono::steady_clock::now() + time};
}

}  // namespace replan::ui
