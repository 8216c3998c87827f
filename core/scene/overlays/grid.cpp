#include "core/scene/overlay.hpp"

namespace replan {
namespace {

void draw_grid(SceneContext& context) {
  const double strength = context.grown(5, 10);
  if (strength <= 0) return;
  add_cell_lines(context, faded(context.palette.grid, strength));
}

}  // namespace

OverlayKind overlay_grid() {
  return {.info = {.label = "grid", .help = "Lines between the cells.", .at_first = true},
          .layer = Layer::lines,
          .draw = draw_grid};
}

}  // namespace replan
