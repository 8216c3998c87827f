// What is to come in a run: surprises that have not happened yet, and the ways of moving obstacles.
#pragma once

#include <cstddef>
#include <vector>

#include "core/scene/scene.hpp"

namespace replan {

/// Whether a surprise of the run's scenario, by its number, has not happened yet at the timeline's cursor.
bool is_to_come(const Run& run, std::size_t surprise);
/// The corners of a moving obstacle's way, as the middle of the box passes through them.
std::vector<Point> way_points(const MovingObstacle& mover);
/// Shows all this: who works on it must see it.
void show_script(OverlaySet& overlays);

}  // namespace replan
