// Colour maps for fields: perceptual and colour-blind safe.
#pragma once

#include <array>

#include <imgui.h>

#include "ui/theme.hpp"

namespace replan::ui {

/// 256 opaque colours; index 0 is the lowest value.
using Colormap = std::array<ImU32, 256>;

/// Viridis (S. van der Walt, N. Smith 2015, CC0), within 1/255 of the published table.
const Colormap& viridis();

/// The colours of a theme's fields: the part of viridis that stands apart from its free ground.
Colormap field_colours(const Theme& theme);
/// The same as they stand over free cells, blended with the ground: what a legend has to show.
Colormap field_colours_over_free(const Theme& theme);

/// The colour at t in [0, 1]; outside is clamped.
ImU32 sample(const Colormap& map, float t);

}  // namespace replan::ui
