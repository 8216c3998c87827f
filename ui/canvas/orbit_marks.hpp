// What stands over a view from outside: start, goal and robot, the cell under the mouse, and the compass.
#pragma once

#include <optional>

#include "core/scene/orbit.hpp"
#include "core/scene/solid_scene.hpp"
#include "ui/look.hpp"

namespace replan::ui {

/// Where on the screen a pane's picture lies.
struct PaneArea {
  ImVec2 min;
  Viewport view;
};

/// Start, goal and robot: strong where nothing hides them.
void draw_solid_marks(const Look& look, const Run& run, const SolidScene& scene, const OrbitLens& lens,
                      const PaneArea& area);
/// The edges of a cell, and beside it where it is and what stands there.
void draw_pointed_cell(const Look& look, const Run& run, Cell cell, const OrbitLens& lens,
                       const PaneArea& area);
/// Where the world's axes lead, in the lower left corner.
void draw_compass(const Look& look, const OrbitLens& lens, const PaneArea& area, ImVec2 mouse);

/// What of the compass lies under the mouse.
enum class CompassPart { x, y, z, middle };
std::optional<CompassPart> compass_part(const Look& look, const OrbitLens& lens, const PaneArea& area,
                                        ImVec2 mouse);

}  // namespace replan::ui
