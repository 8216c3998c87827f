// The words of a link. Only for its reader and its writer.
#pragma once

#include <array>
#include <string_view>

namespace replan {

namespace link_key {
inline constexpr std::string_view version = "v", at = "at", log = "log", panes = "panes", lead = "lead",
                                  lockstep = "lockstep", theme = "theme", overlays = "overlays", tab = "tab",
                                  pin = "pin", camera = "camera", slice = "slice", orbit = "orbit",
                                  orbits = "orbits", solid = "solid", world = "world";
}  // namespace link_key

inline constexpr std::array kLinkKeys = {
    link_key::version, link_key::at,       link_key::log,    link_key::panes,
    link_key::lead,    link_key::lockstep, link_key::theme,  link_key::overlays,
    link_key::tab,     link_key::pin,      link_key::camera, link_key::slice,
    link_key::orbit,   link_key::orbits,   link_key::solid,  link_key::world};

/// In the order of Lockstep.
constexpr std::array<std::string_view, 3> lockstep_names() {
  return {"expansions", "moves", "race"};
}

}  // namespace replan
