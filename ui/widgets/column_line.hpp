// A line of a chart that has more points than its pixels can show.
#pragma once

#include <span>
#include <vector>

#include <imgui.h>

namespace replan::ui {

/// The points of a line that goes to the right, of each column of pixels only the highest and the lowest, in their order:
/// it covers the same pixels, to one.
std::vector<ImVec2> column_line(std::span<const ImVec2> line);

/// Draws a line of any number of points, which ImGui's 16 bit indices have no room for at once.
void draw_long_line(ImDrawList& list, std::span<const ImVec2> line, ImU32 colour, float thick);

}  // namespace replan::ui
