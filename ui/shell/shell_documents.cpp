// What the shell does with wishes and decisions: opening, saving, asking, and saying how it went.
#include <algorithm>

#include "core/base/file.hpp"
#include "ui/shell/documents.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/shell.hpp"

namespace replan::ui {
namespace {

constexpr auto kMessageTime = std::chrono::seconds(6), kErrorTime = std::chrono::seconds(15);

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
    case Wish::quit:
      begin(session, {Pending::Kind::quit, {}});
      break;
    case Wish::save:
      if (saves_in_place(session.file()))
        save(session, session.file());
      else
        dialogs_.show(DialogKind::save, session.file().empty() ? ""
                                                               : file_folder(session.file()) + "/" +
                                                                     file_stem(session.file()) + ".json");
      break;
    case Wish::save_as:
      dialogs_.show(DialogKind::save, session.file());
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
  dialogs_.show(film ? DialogKind::film : DialogKind::picture, capture_name(film ? ".gif" : ".png"));
}

void Shell::take_decision(Session& session, const Decision& decision) {
  switch (decision.kind) {
    case Decision::Kind::none:
      break;
    case Decision::Kind::cancel:
      dialogs_.close();
      pending_ = {};
      break;
    case Decision::Kind::open:
      if (load(session, typed_path(decision.path))) dialogs_.close();
      break;
    case Decision::Kind::save:
      if (!save(session, typed_path(decision.path))) break;
      dialogs_.close();
      go_on(session);
      break;
    case Decision::Kind::new_world:
      replace(session, empty_world(decision.width, decision.height, session.scenario()), "");
      break;
    case Decision::Kind::capture:
      capture_ = asked_;
      capture_->path = typed_path(decision.path);
      capture_->fps = decision.fps;
      message_ = {};  // or it would be in the picture
      break;
    case Decision::Kind::discard:
      go_on(session);
      break;
    case Decision::Kind::save_first:
      if (!saves_in_place(session.file()))
        dialogs_.show(DialogKind::save);
      else if (save(session, session.file()))
        go_on(session);
      break;
  }
}

void Shell::begin(Session& session, Pending pending) {
  pending_ = std::move(pending);
  if (!session.modified()) {
    go_on(session);
    return;
  }
  dialogs_.show(DialogKind::unsaved, document_name(session));
}

void Shell::go_on(Session& session) {
  const Pending pending = std::exchange(pending_, {});
  switch (pending.kind) {
    case Pending::Kind::none:
      break;
    case Pending::Kind::open_dialog:
      dialogs_.show(DialogKind::open);
      break;
    case Pending::Kind::open_file:
      load(session, pending.path);
      break;
    case Pending::Kind::new_world:
      dialogs_.show(DialogKind::new_world);
      break;
    case Pending::Kind::quit:
      quitting_ = true;
      break;
  }
}

bool Shell::load(Session& session, const std::string& path) {
  Result<Scenario> scenario = open_document(path, session.scenario());
  if (!scenario) {
    complain(scenario.error());
    return false;
  }
  replace(session, *std::move(scenario), path);
  return true;
}

bool Shell::save(Session& session, const std::string& path) {
  const Result<void> done = save_document(session, view_, path);
  if (!done) {
    complain(done.error());
    return false;
  }
  session.saved(path);
  tell("Saved " + file_name(path), false);
  return true;
}

void Shell::replace(Session& session, Scenario scenario, const std::string& file) {
  show(scenario.view);
  if (const Result<void> done = session.apply(ReplaceScenario{std::move(scenario), file}); !done)
    tell(done.error(), true);
}

std::string Shell::words(const Session& session) {
  std::string words = session.scenario().name + session.scenario().caption + session.file();
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

bool Shell::may_close(const Session& session) {
  if (quitting_ || !session.modified()) return true;
  pending_ = {Pending::Kind::quit, {}};
  dialogs_.show(DialogKind::unsaved, document_name(session));
  return false;
}

/// In the dialog that the user is looking at, else over the canvas and in the Log.
void Shell::complain(const std::string& sentence) {
  if (dialogs_.open()) {
    dialogs_.complain(as_sentence(sentence));
    return;
  }
  panels_.notices.push_back(sentence);
  tell(sentence, true);
}

void Shell::tell(std::string sentence, bool bad) {
  if (sentence.empty()) return;
  const auto time = bad ? std::chrono::duration_cast<std::chrono::seconds>(kErrorTime) : kMessageTime;
  message_ = {as_sentence(std::move(sentence)), bad, std::chrono::steady_clock::now() + time};
}

}  // namespace replan::ui
