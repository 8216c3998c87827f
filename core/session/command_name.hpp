// Commands by their names.
#pragma once

#include <span>
#include <string_view>

#include "core/session/commands.hpp"

namespace replan {

/// The name of a command as commands.def has it: "PaintCells".
std::string_view command_name(const Command& command);
/// All of them, in the order of the list.
std::span<const std::string_view> command_names();

}  // namespace replan
