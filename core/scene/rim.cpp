#include <algorithm>

#include "core/scene/context.hpp"

namespace replan {

/// What lies outside the world can no more be entered than an obstacle.
void build_rim(SceneContext& context) {
  const Colour colour = context.palette.obstacle;
  const auto columns = static_cast<double>(context.lattice.width()),
             rows = static_cast<double>(context.lattice.height());
  // However small the world is drawn, it has an edge.
  const double rim = std::max(std::min(1.0, context.world(14)), context.world(1.5));
  for (const Outline& side : {Outline{-rim, -rim, columns + 2 * rim, rim, OutlineShape::filled, colour, 0, 0},
                              Outline{-rim, rows, columns + 2 * rim, rim, OutlineShape::filled, colour, 0, 0},
                              Outline{-rim, 0, rim, rows, OutlineShape::filled, colour, 0, 0},
                              Outline{columns, 0, rim, rows, OutlineShape::filled, colour, 0, 0}})
    context.add(side);
}

}  // namespace replan
