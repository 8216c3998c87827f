// That nothing is lost and nothing freezes: files are read off the drawing thread,
// unsaved work is put aside, and the files behind the document are watched.
#include <ctime>
#include <filesystem>

#include "core/base/file.hpp"
#include "ui/documents/documents.hpp"
#include "ui/documents/files.hpp"
#include "ui/documents/questions.hpp"
#include "ui/shell/format.hpp"

namespace replan::ui {
namespace {

using Clock = std::chrono::steady_clock;

/// How often the document's files are looked at.
constexpr auto kWatchInterval = std::chrono::seconds(2);

/// The planners and the robot of the present world: what a bare map gets.
Scenario without_world(const Scenario& scenario) {
  Scenario bare;
  bare.planners = scenario.planners;
  bare.robot = scenario.robot;
  return bare;
}

/// The file of a scenario's map, as read_scenario() looks for it; empty if it holds its map itself.
std::string map_file_of(const std::string& path, const Scenario& scenario) {
  if (scenario.map_file.empty() || path.empty()) return "";
  return (std::filesystem::path(file_folder(path)) / scenario.map_file).string();
}

}  // namespace

void Documents::settle_in(const Session& session, Surroundings surroundings) {
  surroundings_ = std::move(surroundings);
  const WorkPlace& work = surroundings_.work;
  window_.dialogs.set_system(surroundings_.files);
  loader_ = std::make_unique<Background<Loaded>>(work);
  library_ = std::make_unique<WorldLibrary>(surroundings_.worlds_folder, work);
  watch_.watch({stamped(session.file()), stamped(map_file_of(session.file(), session.scenario()))});
  const std::string& state = surroundings_.state_folder;
  if (state.empty()) return;
  recent_ = RecentFiles(state + "/recent.json");
  autosave_ = std::make_unique<Autosaver>(state + "/autosave", work);
  remember(session.file());
  orphans_ = find_orphans(state + "/autosave");
  offer_orphans();
}

void Documents::offer_orphans() {
  window_.dialogs.close();
  std::vector<AutosaveNote> notes;
  for (const Orphan& orphan : orphans_) notes.push_back(orphan.note);
  if (!notes.empty()) window_.dialogs.offer(std::move(notes));
}

void Documents::remember(const std::string& path) {
  if (!path.empty())
    if (const Result<void> done = recent_.add(path); !done) window_.panels.notices.push_back(done.error());
  window_.panels.recent.assign(recent_.paths().begin(), recent_.paths().end());
}

/// Begins to read a document; take_loaded() takes it over.
void Documents::load(Session& session, Loading what) {
  const std::string name = what.from == Loading::From::link ? "the link" : file_name(what.path);
  // Reading a file cannot be cut up: in step the window stands still for it, after a frame that says so.
  loader_->start(
      [what = std::move(what), current = without_world(session.scenario())](const StopToken& stop) {
        if (what.from == Loading::From::link) return load_link(what);
        // The stamp is taken first: what is written while the file is read is then seen as a change.
        Loaded loaded{what, Error{""}, {stamped(what.path)}};
        if (what.from == Loading::From::autosave) {
          loaded.document = read_autosave(what.path);
          return loaded;
        }
        Result<Scenario> scenario = open_document(what.path, current, what.reading, stop);
        if (!scenario) {
          loaded.document = Error{scenario.error()};
          return loaded;
        }
        loaded.files.push_back(stamped(map_file_of(what.path, *scenario)));
        loaded.document =
            ReplaceScenario{*std::move(scenario), what.from == Loading::From::file ? what.path : ""};
        return loaded;
      });
  window_.dialogs.wait_for(name);
  if (surroundings_.work.in_step) take_loaded(session);
}

Documents::Loaded Documents::load_link(const Loading& what) {
  Result<Link> link = parse_link(what.path);
  if (!link) return {what, Error{link.error()}, {}};
  return {what, ReplaceScenario{std::move(link->scenario), ""}, {}, link->view, std::move(link->notes)};
}

void Documents::take_link(Session& session, Loaded loaded) {
  replace(session, std::move(loaded.document.value()));
  note(loaded.notes);
  window_.follow_link(session, loaded.view);
}

void Documents::take_loaded(Session& session) {
  std::optional<Loaded> loaded = loader_->take();
  if (!loaded) return;
  const Loading& what = loaded->what;
  if (!loaded->document) {
    std::error_code failed;
    const bool named = what.from != Loading::From::link;
    if (named && !std::filesystem::exists(what.path, failed) && recent_.drop(what.path).ok()) remember("");
    complain(loaded->document.error());
    return;
  }
  window_.dialogs.close();
  if (what.from == Loading::From::link) return take_link(session, *std::move(loaded));
  if (what.from == Loading::From::autosave)
    return take_recovered(session, what, std::move(loaded->document.value()));
  const std::vector<std::string> notes = loaded->document->scenario.map_found.notes_for_planning();
  replace(session, std::move(loaded->document.value()));
  note(notes);
  if (what.from == Loading::From::library) return;
  watch_.watch(std::move(loaded->files));
  reading_ = what.reading;
  remember(what.path);
}

void Documents::take_recovered(Session& session, const Loading& what, ReplaceScenario document) {
  const AutosaveNote note = orphans_[what.orphan].note;
  replace(session, std::move(document));
  autosave_->adopt(std::move(orphans_[what.orphan]), session);
  orphans_.clear();
  unsaved_since_ = note.edited_at;
  // Who has written the file since then, if not the program that ended?
  const FileStamp now = stamp_of(note.file);
  disk_differs_ = now.there && now.modified / 1'000'000'000 > note.edited_at;
  if (!note.file.empty()) watch_.watch({stamped(note.file)});
  window_.message.tell(
      "Recovered: " + count_text(static_cast<std::int64_t>(note.edits), "edit", "edits") + " not saved yet",
      false);
}

void Documents::keep(Session& session) {
  const bool in_stroke = ImGui::IsAnyMouseDown();
  const double now = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
  autosave_->tick(session, now, in_stroke);
  if (const std::string failure = autosave_->take_failure(); !failure.empty()) complain(failure);
  if (!session.modified())
    unsaved_since_ = 0;
  else if (unsaved_since_ == 0)
    unsaved_since_ = static_cast<std::int64_t>(std::time(nullptr));
  if (!in_stroke && !window_.dialogs.open()) look_at_disk(session);
}

void Documents::look_at_disk(const Session& session) {
  if (Clock::now() - looked_at_disk_ < kWatchInterval) return;
  looked_at_disk_ = Clock::now();
  const std::optional<std::string> changed = watch_.changed();
  if (!changed) return;
  window_.dialogs.ask(changed_question(file_name(*changed), document_name(session),
                                       *changed != session.file(), session.unsaved_edits()));
}

}  // namespace replan::ui
