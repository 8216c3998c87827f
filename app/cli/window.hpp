// What of the command line draws: with_window.cpp, or without_window.cpp in a program that was built without a
// window (REPLAN_GUI=OFF).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/commands.hpp"
#include "app/study_files.hpp"
#include "core/world/scenario.hpp"

namespace replan::cli {

/// An action of the window, as `replan list actions` shows it.
struct ListedAction {
  std::string name, keys, label, help;
};

bool has_window();
/// Opens the window, with a file if one is given, until it is closed. `in_step`: it works without threads.
Result<void> open_window(const std::optional<std::string>& file, bool in_step);
/// Opens it with a world that is in no file.
Result<void> open_window(Scenario world);
/// The commands that draw.
std::vector<Command> add_drawing(CLI::App& program);
/// What draws the pictures of studies; empty: nothing does.
app::DrawPicture study_pen();
/// The actions of the window.
std::vector<ListedAction> listed_actions();

}  // namespace replan::cli
