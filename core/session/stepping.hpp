// Where steps through a run stop, in either direction.
#pragma once

#include <cstddef>

#include "core/session/run.hpp"

namespace replan {

/// What one step goes over.
enum class StepUnit : std::uint8_t {
  line,       ///< one pseudo-code line
  expansion,  ///< one iteration of the main loop, or one thing that happens between searches
  move,       ///< one step of the robot
  replan,     ///< to where the next plan stands
  mission,    ///< to where the robot arrives
};

/// The first stop after `from`; the end of the log if there is none yet.
std::size_t next_stop(const Run& run, std::size_t from, StepUnit unit);
/// The last stop before `from`; 0 if there is none.
std::size_t previous_stop(const Run& run, std::size_t from, StepUnit unit);

/// Whether a repair is worth a look at a position: cells of the robot's map have changed, an rhs has been written for
/// that, and no vertex has been taken yet. What is blocked now is seen, and rhs that has jumped where g has not.
bool is_before_repair(const Run& run, std::size_t position);

}  // namespace replan
