#include <algorithm>

#include "core/scene/overlay.hpp"
#include "core/scene/solid_pen.hpp"

namespace replan {
namespace {

/// How strongly the last replan, the one before that ... still shows.
constexpr double kStrength[] = {1, 0.45, 0.25, 0.12};
/// Half of the side of a cell's small cube in space: one that waits in the open list as well shows around it.
constexpr double kTouchedHalf = 0.13;

void draw_repairs(SceneContext& context) {
  const RunDigest& digest = context.memory.digest;
  const std::size_t count = digest.plans_before(context.cursor);
  for (std::size_t age = std::min(std::size(kStrength), count > 0 ? count - 1 : 0); age-- > 0;) {
    const PlanSpan& plan = digest.plans()[count - 1 - age];
    for (const Touch& touch : digest.touches_before(plan, context.cursor)) {
      const Cell cell = context.lattice.position(touch.node);
      if (!context.in_sight(cell)) continue;
      context.scene.show(Sign::repair);
      mark_cell(context, cell, OutlineShape::square, context.palette.warning, kStrength[age],
                context.pixels(1.4), context.pixels(1));
    }
  }
}

/// Those of the last replan alone: in space older ones would hide them.
void repair_in_space(SolidPen& pen) {
  const RunDigest& digest = pen.context().memory.digest;
  const std::size_t count = digest.plans_before(pen.context().cursor);
  if (count < 2 || pen.slice_alone()) return;
  for (const Touch& touch : digest.touches_before(digest.plans()[count - 1], pen.context().cursor)) {
    pen.show(Sign::repair);
    if (!pen.cube(pen.context().centre(touch.node), kTouchedHalf, pen.palette().warning)) return;
  }
}

}  // namespace

void show_last_repair(OverlaySet& overlays) {
  overlays.set(Overlay::repair, true);
}

OverlayKind overlay_repair() {
  return {.info = {.label = "last repair",
                   .help = "The cells that the last replans touched; older ones fade.",
                   .at_first = true},
          .layer = Layer::frames,
          .draw = draw_repairs,
          .draw_in_space = repair_in_space};
}

}  // namespace replan
