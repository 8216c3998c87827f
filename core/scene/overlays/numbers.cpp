#include "core/scene/numbers.hpp"

#include "core/scene/overlay.hpp"

namespace replan {
namespace {

/// The numbers themselves are in core/scene/numbers.cpp; here are lines between the cells, so that it is plain whose
/// they are.
void draw_number_lines(SceneContext& context) {
  if (NumberLayout(context).everywhere == NumbersShown::none) return;
  add_cell_lines(context, faded(context.palette.dim, 0.35));
}

}  // namespace

OverlayKind overlay_numbers() {
  return {.info = {.label = "numbers",
                   .help = "g, rhs, key and dist inside the cells, from a readable zoom on.",
                   .key = '7',
                   .readable_from = kNumbersFrom},
          .layer = Layer::lines,
          .draw = draw_number_lines};
}

}  // namespace replan
