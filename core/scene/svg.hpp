// A scene as a vector drawing.
#pragma once

#include <string>

#include "core/scene/scene.hpp"

namespace replan {

/// The scene as an SVG document, one user unit per pixel. `palette` tells which texels are free ground and
/// need no rectangle. Runs of equal texels become one rectangle.
std::string scene_svg(const Scene& scene, const Palette& palette);

}  // namespace replan
