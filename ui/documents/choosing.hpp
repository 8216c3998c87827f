// Which files can be opened and written: what the file dialog is asked for, but for where it begins.
#pragma once

#include <memory>

#include "core/world/scenario.hpp"
#include "ui/shell/dialogs/file_dialog.hpp"

namespace replan::ui {

FileDialogSpec spec_to_open();
/// Of that document: what a kind of file cannot hold of it is said beforehand.
FileDialogSpec spec_to_save(std::shared_ptr<const Scenario> scenario);
/// An experiment, for a batch.
FileDialogSpec spec_for_experiment(bool saving);
/// A folder for the results of a batch.
FileDialogSpec spec_for_batch_folder();
/// Of the Figures tab.
FileDialogSpec spec_to_save_figures();

}  // namespace replan::ui
