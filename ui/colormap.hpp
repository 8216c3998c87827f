// Colour maps for fields: perceptual and colour-blind safe.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <imgui.h>

#include "ui/theme.hpp"

namespace replan::ui {

/// 256 opaque colours; index 0 is the lowest value.
using Colormap = std::array<ImU32, 256>;

/// What fields are coloured by.
enum class FieldColours : std::uint8_t { viridis, cividis, grey };
struct FieldColoursInfo {
  FieldColours colours;
  std::string_view id;     ///< as in `--colours` and in the window's settings
  std::string_view label;  ///< as in the window
  std::string_view help;
};
std::span<const FieldColoursInfo> all_field_colours();
const FieldColoursInfo& info_of(FieldColours colours);
/// By its id; nothing if there is none.
std::optional<FieldColours> field_colours_named(std::string_view id);

/// A colour map as it was published: viridis (S. van der Walt, N. Smith 2015, CC0), cividis (J. Nunez, C. Anderton,
/// R. Renslow 2018, doi 10.1371/journal.pone.0199239), both within 2/255 of the table; or from black to white.
const Colormap& published(FieldColours colours);

/// The colours of a theme's fields: the part of a map that stands apart from its free ground and its obstacles.
Colormap field_colours(const Theme& theme, FieldColours colours = FieldColours::viridis);
/// The same as they stand over free cells, blended with the ground: what a legend has to show.
Colormap field_colours_over_free(const Theme& theme, FieldColours colours = FieldColours::viridis);

/// The colour at t in [0, 1]; outside is clamped.
ImU32 sample(const Colormap& map, float t);

}  // namespace replan::ui
