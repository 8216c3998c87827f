// Folders, and where a program keeps what is not a document of its user's (XDG Base Directory Specification).
#pragma once

#include <string>

#include "core/base/result.hpp"

namespace replan {

/// $XDG_STATE_HOME/replan, else ~/.local/state/replan: recent files and autosaves. Empty if there is no home.
std::string state_folder();
/// Makes a folder and those above it. No error if it is there already.
Result<void> make_folder(const std::string& path);
/// Makes a folder and those above it; for the user alone. No error if it is there already.
Result<void> make_private_folder(const std::string& path);

}  // namespace replan
