// What a step of a lesson does for the learner, in words:
//
//   step UNIT [COUNT]   a line, expansion, move, replan or mission; backwards if COUNT is below 0
//   seek EVENTS         to where so many events have happened
//   paint CELL...       makes cells obstacles, and the robot is told; `erase` makes them free
//   surprise CELL...    makes cells obstacles, and the robot has to see them
//   goal CELL           moves the goal
//   panes COUNT         so many planners side by side; `lead PANE` lets one of them, from 1, lead the others
//   end                 runs the mission to its end
//   action ID           an action of the window, by its identifier in `replan list actions`
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "core/base/result.hpp"
#include "core/session/commands.hpp"

namespace replan {

/// An action of the window, by its identifier; only a window can do it.
struct ActionDeed {
  std::string action;
};
using Deed = std::variant<Command, ActionDeed>;

/// Reads one in `world`, whose cells it may name. The error names the mend.
Result<Deed> parse_deed(std::string_view words, const Box& world);
/// Reads a cell of the world: "3,1", or "3,1,2" in one of more layers.
Result<Cell> parse_lesson_cell(std::string_view words, const Box& world);

}  // namespace replan
