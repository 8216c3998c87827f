#include <algorithm>
#include <cmath>

#include "core/scene/overlay.hpp"

namespace replan {
namespace {

void draw_grid(SceneContext& context) {
  const double strength = context.grown(5, 10);
  if (strength <= 0) return;
  const Colour colour = faded(context.palette.grid, strength);
  const float width = std::max(1.0f, std::floor(context.pixels(1)));
  for (int x = context.left; x <= context.right; ++x)
    context.add(Line{{static_cast<double>(x), static_cast<double>(context.top)},
                     {static_cast<double>(x), static_cast<double>(context.bottom)},
                     colour,
                     width});
  for (int y = context.top; y <= context.bottom; ++y)
    context.add(Line{{static_cast<double>(context.left), static_cast<double>(y)},
                     {static_cast<double>(context.right), static_cast<double>(y)},
                     colour,
                     width});
}

}  // namespace

OverlayKind overlay_grid() {
  return {.info = {.label = "grid", .help = "Lines between the cells.", .at_first = true},
          .layer = Layer::lines,
          .draw = draw_grid};
}

}  // namespace replan
