// What the shell does for batches: their files are chosen, and their runs opened.
#include <filesystem>

#include "core/base/file.hpp"
#include "core/experiment/held_results.hpp"
#include "ui/documents/choosing.hpp"
#include "ui/documents/file_list.hpp"
#include "ui/documents/files.hpp"
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
    case BatchDialog::Wish::choose_folder:
      return choose_batch_folder();
  }
}

/// Begins at the folder that is in the form, or at the nearest one above it that is there.
void Shell::choose_batch_folder() {
  FileDialogSpec spec = spec_for_batch_folder();
  const FileDialogSpec place = documents_.place_for("results");
  spec.path = typed_from("/", std::filesystem::absolute(typed_path(batch_.folder())).string());
  std::error_code failed;
  while (spec.path.size() > 1 && !std::filesystem::is_directory(spec.path, failed))
    spec.path = file_folder(spec.path);
  spec.places = place.places;
  dialogs_.choose_file(std::move(spec), documents_.work(), DialogDecision::Kind::batch_folder);
}

void Shell::show_batch(const Session& session, const std::string& path) {
  batch_.show(session, documents_.batch_folder(session), documents_.work());
  if (batch_paper(path) == BatchPaper::results)
    batch_.take_folder(file_folder(path));
  else
    batch_.take_experiment(path);
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
