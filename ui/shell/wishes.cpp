// What the shell does with what actions wish for and what its dialogs come to.
#include "ui/documents/files.hpp"
#include "ui/shell/gallery.hpp"
#include "ui/shell/shell.hpp"

namespace replan::ui {

void Shell::take_wish(Session& session, Wish wish) {
  switch (wish) {
    case Wish::palette:
      if (WorldLibrary* library = documents_.library()) library->refresh();
      return palette_.show();
    case Wish::fit:
      return fit();
    case Wish::generate:
      return world_dialogs_.show_generate(session, documents_.work());
    case Wish::resize:
      return world_dialogs_.show_resize(session, documents_.work());
    case Wish::batch:
      return batch_.show(session, documents_.batch_folder(session), documents_.work());
    case Wish::lesson:
      return open_lesson(session, panels_.wished);
    case Wish::about:
      return dialogs_.show_about(panels_.about);
    case Wish::keys:
      return dialogs_.show_keys(session.run().info().step);
    case Wish::record_canvas:
    case Wish::record_window:
      return ask_for_capture(session, true, wish == Wish::record_window);
    case Wish::picture_canvas:
    case Wish::picture_window:
      return ask_for_capture(session, false, wish == Wish::picture_window);
    case Wish::export_trace:
      return ask_for_trace(session);
    case Wish::stop_export:
      export_.cancel();
      return tell("The trace was not written", false);
    case Wish::stop_film:
      capture_ = CaptureRequest{.kind = CaptureRequest::Kind::give_up, .path = {}};
      return;
    case Wish::go_to_pasted:
      return documents_.after_saving(session, [this](Session& its) { go_to_pasted(its); });
    case Wish::open_link:
      return open_link(session, panels_.wished);
    case Wish::copy_link:
      return ask_for_link(session);
    case Wish::stop_going:
      arrival_.cancel();
      static_cast<void>(session.apply(Cancel{}));
      return tell("Stopped on the way; a step or Play goes on from here", false);
    default:
      return documents_.take_wish(session, wish);
  }
}

bool Shell::show_dialog(std::string_view name, const Session& session) {
  return show_from_gallery(name, {session, dialogs_, world_dialogs_, documents_, view_, panels_, batch_});
}

void Shell::open_lesson(Session& session, const std::string& id) {
  const Result<Lesson> lesson = read_lesson(id);
  if (!lesson) return tell(lesson.error(), true);
  documents_.after_saving(session, [this, lesson = lesson.value()](Session& its) {
    documents_.replace(its, {lesson.scenario, ""});
    lesson_.begin(lesson);
  });
}

/// Tells the lesson what was given in this frame. Its world is there to be tried out: only what is done to it after the
/// lesson, or what somebody has saved, is worth keeping.
void Shell::follow_lesson(const Session& session) {
  if (lesson_.open() && !lesson_.is_about(session.scenario())) lesson_.close();
  for (const char* name : panels_.performed) lesson_.note(name);
  if (lesson_.open() && session.file().empty()) documents_.disregard_edits(session);
  if (lesson_.look(session)) panels_.animated = true;
}

void Shell::welcome() {
  const std::vector<Lesson>& lessons = lessons_of(panels_);
  if (!dialogs_.open() && !lessons.empty()) perform_next(ActionId::first_steps);
}

/// A film that is being recorded ends; anything else is asked for by its name.
void Shell::ask_for_capture(const Session& session, bool film, bool window) {
  asked_ = {film ? CaptureRequest::Kind::film : CaptureRequest::Kind::picture, window, {}, {}};
  if (film && panels_.recording.on) {
    capture_ = {CaptureRequest::Kind::stop, window, {}, {}};
    return;
  }
  FileDialogSpec spec = documents_.place_for(capture_name(film ? dialogs_.film_extension().c_str() : ".png"));
  if (film)
    dialogs_.ask_film(session, window, window ? whole_window() : panels_.canvas, std::move(spec),
                      documents_.work());
  else
    dialogs_.ask_picture(window, std::move(spec), documents_.work());
}

void Shell::take_decision(Session& session, const DialogDecision& decision) {
  switch (decision.kind) {
    case DialogDecision::Kind::capture:
      capture_ = asked_;
      capture_->path = decision.path;
      capture_->film = decision.film;
      return message_.clear();  // or it would be in the picture
    case DialogDecision::Kind::copy_link:
      return take_copied_link(decision.path);
    case DialogDecision::Kind::export_trace:
      return export_trace(session, decision);
    case DialogDecision::Kind::open_experiment:
      return batch_.take_experiment(decision.path);
    case DialogDecision::Kind::batch_folder:
      return batch_.take_folder(decision.path);
    case DialogDecision::Kind::save_experiment:
      return batch_.save_experiment(decision.path);
    default:
      return documents_.take_decision(session, decision);
  }
}

}  // namespace replan::ui
