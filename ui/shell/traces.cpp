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

/// Opens the pasted scenario; go_on_to_moment() goes on to its moment.
void Shell::go_to_pasted(Session& session) {
  const std::shared_ptr<const CaseMoment> moment = std::exchange(panels_.pasted, nullptr);
  if (!moment) return;
  documents_.replace(session, {moment->scenario, ""});
  if (const Result<void> led = session.apply(Lead{moment->pane}); !led) return tell(led.error(), true);
  arrival_.begin(session, {.event = moment->event, .state = moment->state});
}

void Shell::follow_link(Session& session, const LinkView& view) {
  static_cast<void>(session.apply(Lead{view.lead}));  // the pane is one of the link's world
  if (view.lockstep) static_cast<void>(session.apply(SetLockstep{*view.lockstep}));
  panes_.take_over(session.run().lattice(), view_);
  show_link(view, view_);
  if (view.event) arrival_.begin(session, {Arrival::Moment::From::link, *view.event, {}, view.log});
}

/// Once a frame.
void Shell::go_on_to_moment(Session& session) {
  if (const auto outcome = arrival_.go_on(session)) tell(outcome->words, outcome->bad);
  panels_.going.reset();
  if (arrival_.busy()) panels_.going = PanelState::Going{arrival_.event(), arrival_.share(session)};
}

void Shell::ask_for_link(const Session& session) {
  dialogs_.show_link(panels_.link_address);
  link_copy_ = std::make_unique<LinkCopy>(session, link_view(session, view_), documents_.work());
}

/// Once a frame, while the link's dialog shows.
void Shell::go_on_with_link(const Session& session) {
  constexpr double kLinkMs = 8;
  if (!link_copy_) return;
  if (!dialogs_.shows_link()) {
    link_copy_.reset();
    return;
  }
  auto link = link_copy_->go_on(session, Deadline(kLinkMs));
  if (!link) return;
  dialogs_.take_link(*std::move(link));
  link_copy_.reset();
}

void Shell::take_copied_link(const std::string& link) {
  ImGui::SetClipboardText(link.c_str());
  tell("Copied the link: " + count_text(static_cast<std::int64_t>(link.size()), "character", "characters"),
       false);
}

Result<std::string> Shell::link(const Session& session) const {
  Result<std::string> link = link_here(session, view_);
  if (!link) return link;
  return panels_.link_address + *link;
}

}  // namespace replan::ui
