// Colour maps for fields: perceptual and colour-blind safe.
#pragma once

#include <array>

#include <imgui.h>

namespace replan::ui {

/// 256 opaque colours; index 0 is the lowest value.
using Colormap = std::array<ImU32, 256>;

/// Viridis (S. van der Walt, N. Smith 2015, CC0), within 1/255 of the published table.
const Colormap& viridis();

/// The colour at t in [0, 1]; outside is clamped.
ImU32 sample(const Colormap& map, float t);

}  // namespace replan::ui
