#include "ui/documents/documents.hpp"

#include <algorithm>

#include "core/base/file.hpp"
#include "core/experiment/held_results.hpp"
#include "ui/documents/files.hpp"
#include "ui/documents/questions.hpp"
#include "ui/shell/format.hpp"

namespace replan::ui {

void Documents::take_wish(Session& session, Wish wish) {
  switch (wish) {
    case Wish::new_world:
      return window_.dialogs.show(DialogKind::new_world);
    case Wish::open:
      return choose_open(session, {});
    case Wish::worlds:
      if (library_) window_.dialogs.choose_world(*library_);
      return;
    case Wish::recent:
      return open(session, window_.panels.wished);
    case Wish::forget_recent:
      static_cast<void>(recent_.clear());
      window_.panels.recent.clear();
      return;
    case Wish::quit:
      return quit(session);
    case Wish::open_world:
      return load_next(session, {Loading::From::library, window_.panels.wished, {}});
    case Wish::save_figures:
      return choose_figures_file();
    case Wish::save:
      return save_in_place(session);
    case Wish::save_as:
      return choose_save(session);
    default:
      return;
  }
}

void Documents::take_decision(Session& session, const DialogDecision& decision) {
  switch (decision.kind) {
    case DialogDecision::Kind::cancel:
      return give_up();
    case DialogDecision::Kind::open:
      return is_link(decision.path)
                 ? open(session, decision.path)
                 : load_next(session, {Loading::From::file, decision.path, decision.reading});
    case DialogDecision::Kind::open_world:
      return load_next(session, {Loading::From::library, decision.path, {}});
    case DialogDecision::Kind::save:
      return write_(session, decision.path);
    case DialogDecision::Kind::new_world:
      return after_saving(session, [this, decision](Session& its) {
        replace(its, {empty_world({decision.width, decision.height, decision.layers}, its.scenario()), ""});
      });
    case DialogDecision::Kind::discard:
      return go_on(session);
    case DialogDecision::Kind::save_first:
      return save_in_place(session);
    case DialogDecision::Kind::save_elsewhere:
      return choose_save(session);
    case DialogDecision::Kind::overwrite:
      if (save(session, session.file())) go_on(session);
      return;
    case DialogDecision::Kind::reload:
      return load(session, {Loading::From::file, session.file(), reading_});
    case DialogDecision::Kind::keep_mine:
      disk_differs_ = disk_differs_ || watch_.changed() == session.file();
      watch_.accept();
      return;
    case DialogDecision::Kind::recover:
      return load(session, {Loading::From::autosave, orphans_[decision.index].path, {}, decision.index});
    case DialogDecision::Kind::forget:
      discard(std::move(orphans_[decision.index]));
      orphans_.erase(orphans_.begin() + static_cast<std::ptrdiff_t>(decision.index));
      return offer_orphans();
    default:
      return;
  }
}

/// The user wants none of what was under way.
void Documents::give_up() {
  loader_->cancel();
  window_.dialogs.close();
  orphans_.clear();  // their locks with them: the next program offers them again
  deed_ = nullptr;
}

void Documents::ask_about_unsaved(const Session& session) {
  window_.dialogs.ask(unsaved_question(document_name(session), session.unsaved_edits(),
                                       unsaved_since_ != 0 ? date_text(unsaved_since_) : ""));
}

bool Documents::would_lose_edits(const Session& session) const {
  return session.modified() && session.document_state() != disregarded_;
}

void Documents::after_saving(Session& session, Deed deed) {
  deed_ = std::move(deed);
  if (would_lose_edits(session))
    ask_about_unsaved(session);
  else
    go_on(session);
}

void Documents::go_on(Session& session) {
  if (const Deed deed = std::exchange(deed_, nullptr)) deed(session);
}

/// To its own file if that can hold it and nobody else has written it meanwhile; else the user is asked.
void Documents::save_in_place(Session& session) {
  if (!saves_in_place(session)) {
    choose_save(session);
  } else if (disk_differs_ || watch_.changed() == session.file()) {
    window_.dialogs.ask(overwrite_question(file_name(session.file())));
  } else if (save(session, session.file())) {
    go_on(session);
  }
}

bool Documents::save(Session& session, const std::string& path) {
  const Result<void> done = save_document(session, window_.view, path);
  if (!done) {
    complain(done.error());
    return false;
  }
  session.saved(path);
  disk_differs_ = false;
  watch_.watch({stamped(path)});
  remember(path);
  window_.message.tell("Saved " + file_name(path), false);
  return true;
}

void Documents::save_and_go_on(Session& session, const std::string& path) {
  if (!save(session, path)) return;
  window_.dialogs.close();
  go_on(session);
}

void Documents::replace(Session& session, ReplaceScenario document) {
  window_.show(document.scenario);
  watch_.watch({});
  disk_differs_ = false;
  disregarded_.reset();
  reading_ = {};
  if (const Result<void> done = session.apply(std::move(document)); !done)
    window_.message.tell(done.error(), true);
}

std::string Documents::names_on_show() const {
  std::string names = window_.dialogs.words();
  for (const std::string& path : window_.panels.recent) names += path;
  return names;
}

void Documents::open(Session& session, const std::string& path) {
  load_next(session, {is_link(path) ? Loading::From::link : Loading::From::file, path, {}});
}

/// Unsaved edits are asked about once it is known what takes their place, and not before one may look.
void Documents::load_next(Session& session, Loading what) {
  if (what.from == Loading::From::file && batch_paper(what.path) != BatchPaper::none) {
    window_.dialogs.close();
    remember(what.path);
    return window_.show_batch(session, what.path);
  }
  after_saving(session, [this, what = std::move(what)](Session& its) { load(its, what); });
}

void Documents::drop(Session& session, const std::vector<std::string>& paths) {
  const Dropped dropped = sort_out(paths);
  if (!dropped.sentence.empty()) window_.message.tell(dropped.sentence, dropped.path.empty());
  if (dropped.path.empty() || window_.dialogs.open()) return;
  if (!dropped.folder) return open(session, dropped.path);
  choose_open(session, dropped.path);
}

bool Documents::may_close(Session& session) {
  if (quitting_ || (!would_lose_edits(session) && !makes_file())) return true;
  quit(session);
  return false;
}

/// A film of a part of the run, or a trace.
bool Documents::makes_file() const {
  return window_.panels.recording.made >= 0 || window_.panels.exporting >= 0;
}

/// Once all that would be lost is saved, done or given up.
void Documents::quit(Session& session) {
  after_saving(session, [this](Session&) {
    if (!makes_file()) {
      quitting_ = true;
      return;
    }
    deed_ = [this](Session&) { quitting_ = true; };
    window_.dialogs.ask(unfinished_question());
  });
}

/// In the dialog that the user is looking at, else over the canvas and in the Log.
void Documents::complain(const std::string& sentence) {
  if (window_.dialogs.complain(as_sentence(sentence))) return;
  window_.dialogs.close();
  window_.panels.notices.push_back(sentence);
  window_.message.tell(sentence, true);
}

/// What the reader of a document has to say: all of it in the Log, the first of it over the canvas too.
void Documents::note(const std::vector<std::string>& notes) {
  window_.panels.notices.insert(window_.panels.notices.end(), notes.begin(), notes.end());
  if (!notes.empty()) window_.message.tell(notes.front(), false);
}

}  // namespace replan::ui
