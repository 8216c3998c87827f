// What the shell does with moments and traces: a pasted moment is gone to, a run's log is exported.
#include "core/base/file.hpp"
#include "core/export/case_text.hpp"
#include "core/export/posthoc.hpp"
#include "ui/documents/files.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/shell.hpp"

namespace replan::ui {

void Shell::ask_for_trace(const Session& session) {
  const Timeline& log = session.run().timeline();
  const PosthocSize posthoc = posthoc_size(log);
  const std::string& file = session.file();
  const std::string name = file.empty() ? session.scenario().name : file_stem(file);
  const std::string folder = file.empty() ? "" : file_folder(file);
  dialogs_.ask_trace(
      {log.size(), posthoc.steps, posthoc.bytes},
      documents_.place_for((name.empty() ? "run" : name) + "." + session.run().choice().id + ".trace.yaml",
                           folder),
      documents_.work());
}

void Shell::export_trace(const Session& session, const DialogDecision& decision) {
  const Result<void> begun = export_.begin(session, decision.path, decision.map);
  if (!begun) tell(begun.error(), true);
}

/// Opens the pasted scenario; await_moment() goes on to its moment.
void Shell::go_to_pasted(Session& session) {
  const std::shared_ptr<const CaseMoment> moment = std::exchange(panels_.pasted, nullptr);
  if (!moment) return;
  documents_.replace(session, {moment->scenario, ""});
  if (const Result<void> led = session.apply(Lead{moment->pane}); !led) return tell(led.error(), true);
  awaited_ = Awaited{session.run().log_id(), moment->event, moment->state, false};
}

/// Once a frame. The run is sent on to its end, since nobody knows at which step of the robot the moment
/// lies; what it does beyond that shows on the timeline.
void Shell::await_moment(Session& session) {
  if (!awaited_) return;
  const Run& run = session.run();
  const std::size_t size = run.timeline().size();
  if (run.log_id() != awaited_->log) {
    awaited_.reset();  // edited or closed meanwhile
  } else if (awaited_->hash) {
    compare_moment();
  } else if (size > awaited_->event || (size == awaited_->event && !run.busy())) {
    arrive_at_moment(session);
  } else if (!run.busy() && !awaited_->sent) {
    awaited_->sent = session.apply(RunToEnd{}).ok();
  } else if (!run.busy()) {
    const std::size_t event = awaited_->event;
    awaited_.reset();
    tell("The run ends after " + grouped(size) + " events, before the copied event " + grouped(event) +
             ": the text was made by another version of the program, or changed",
         true);
  }
}

void Shell::arrive_at_moment(Session& session) {
  if (const Result<void> gone = session.apply(Seek{awaited_->event}); !gone) {
    awaited_.reset();
    return tell(gone.error(), true);
  }
  awaited_->hash.emplace(session.run().timeline().state());
  compare_moment();
}

/// Whether it is the moment that was copied shows once its state is read, which may take more than this frame.
void Shell::compare_moment() {
  constexpr double kCompareMs = 8;
  if (!awaited_->hash->advance(Deadline(kCompareMs))) return;
  const Awaited moment = *std::exchange(awaited_, std::nullopt);
  const bool same = moment.hash->value() == moment.state;
  tell(same ? "At event " + grouped(moment.event) + ", as it was copied"
            : "At event " + grouped(moment.event) +
                  ", but the state differs from the copied one: the text was made by "
                  "another version of the program, or changed",
       !same);
}

}  // namespace replan::ui
