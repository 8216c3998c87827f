// Where the robot sets out and where it goes, in a world that does not say.
#pragma once

#include <string>

#include "core/base/stop.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// Puts start and goal at the ends of the largest open region, at its upper left and its lower right (in space: in
/// the lowest layers, in the highest), with some free cells around them if the region has such places that far apart. A world
/// without a free cell keeps what it has. A stop leaves the ends anywhere.
void place_ends(Scenario& scenario, const StopToken& stop = {});

/// Why a start or goal that cannot be planned from is inside an obstacle, if that is since the map's file
/// calls its cell unknown, as a sentence for a user; else empty.
std::string unknown_end_sentence(const Scenario& scenario, bool start);

}  // namespace replan
