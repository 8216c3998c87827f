// What of the command line draws: with_window.cpp, or without_window.cpp in a program that was built without a
// window (REPLAN_GUI=OFF).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/commands.hpp"

namespace replan::cli {

/// An action of the window, as `replan list actions` shows it.
struct ListedAction {
  std::string name, keys, label, help;
};

bool has_window();
/// Opens the window, with a file if one is given, until it is closed. `in_step`: it works without threads.
Result<void> open_window(const std::optional<std::string>& file, bool in_step);
/// The commands that draw.
std::vector<Command> add_drawing(CLI::App& program);
/// The actions of the window.
std::vector<ListedAction> listed_actions();

}  // namespace replan::cli
