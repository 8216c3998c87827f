// The key of the numbers in the cells: one cell, enlarged, with the name of each number where it stands.
#pragma once

#include <imgui.h>

#include "core/plan/registry.hpp"
#include "core/scene/pixel_box.hpp"
#include "core/scene/scene.hpp"
#include "ui/look.hpp"

namespace replan::ui {

/// Draws it while numbers show, in the corner of the room, a part of the canvas at `origin`, where it hides least of the
/// world.
void draw_number_key(const Look& look, ImDrawList& list, const PlannerInfo& planner, const Scene& scene,
                     ImVec2 origin, const PixelBox& room);

}  // namespace replan::ui
