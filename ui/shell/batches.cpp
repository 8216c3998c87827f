// What the shell does for batches: their files are chosen, and their runs opened.
#include "core/base/file.hpp"
#include "ui/documents/choosing.hpp"
#include "ui/shell/shell.hpp"

namespace replan::ui {

void Shell::draw_batch(const Look& look) {
  switch (batch_.draw(look)) {
    case BatchDialog::Wish::none:
      return;
    case BatchDialog::Wish::open_experiment:
      return choose_experiment(false);
    case BatchDialog::Wish::save_experiment:
      return choose_experiment(true);
  }
}

void Shell::choose_experiment(bool saving) {
  FileDialogSpec spec = spec_for_experiment(saving);
  const FileDialogSpec place = documents_.place_for("experiment.json");
  spec.path = saving ? place.path : file_folder(place.path);
  spec.places = place.places;
  dialogs_.choose_file(
      std::move(spec), documents_.work(),
      saving ? DialogDecision::Kind::save_experiment : DialogDecision::Kind::open_experiment);
}

/// The batch goes on whatever is on show. A run that was asked for takes the document's place, as an opened file does.
void Shell::go_on_with_batch(Session& session) {
  batch_.keep();
  panels_.batch = batch_.at_work();
  auto run = batch_.take_run();
  if (!run) return;
  documents_.after_saving(session, [this, run = std::move(*run)](Session& its) {
    documents_.replace(its, {run, ""});
    tell("Opened the run; Run > Batch… leads back to the table", false);
  });
}

}  // namespace replan::ui
