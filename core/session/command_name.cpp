#include "core/session/command_name.hpp"

namespace replan {
namespace {

constexpr std::string_view kCommandNames[] = {
#define REPLAN_COMMAND(NAME) #NAME,
#include "core/session/commands.def"
#undef REPLAN_COMMAND
};

}  // namespace

std::span<const std::string_view> command_names() {
  return kCommandNames;
}

std::string_view command_name(const Command& command) {
  // No command at all comes before the first of the list.
  return command.index() == 0 ? std::string_view() : kCommandNames[command.index() - 1];
}

}  // namespace replan
