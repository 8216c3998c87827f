// Blocks that drop ahead of a robot: surprises of an experiment that a seed draws.
#pragma once

#include "core/experiment/experiment.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// The blocks for that map, start, goal, robot's size and seed. Each stands on a shortest way from start to goal that A*
/// finds with its usual settings, and drops when the robot comes within RandomBlocks::ahead of its middle. They leave start
/// and goal free, and a way from one to the other that leads past all of them; a block for which 20 places do not is left
/// out, and so are all where there is no way to begin with.
Surprises dropped_blocks(const Scenario& world, const RandomBlocks& blocks);

}  // namespace replan
