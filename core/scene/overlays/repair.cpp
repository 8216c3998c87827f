#include <algorithm>

#include "core/scene/overlay.hpp"
#include "core/scene/solid_pen.hpp"

namespace replan {
namespace {

/// How strongly the last replan, the one before that ... still shows.
constexpr double kStrength[] = {1, 0.45, 0.25, 0.12};
/// Half of the side of a cell's small cube in space: one that waits in the open list as well shows around it.
constexpr double kTouchedHalf = 0.13;
/// How strongly what is no longer there is drawn.
constexpr double kLostStrength = 0.55;

/// Of a tree or a population a cell tells nothing: it is where a sample lay.
bool keeps_no_cells(const Run& run) {
  return run.info().values.grows() || run.info().values.breeds();
}

Sign lost_sign(const Run& run) {
  return run.info().values.breeds() ? Sign::path_lost : Sign::cut_off;
}

/// What the last replan cut off of a tree, or lost of a population.
void draw_lost(SceneContext& context) {
  const KeptInReplan* kept = context.memory.kept_by_replan(context.run, context.cursor);
  if (kept == nullptr) return;
  const Colour colour = faded(context.palette.bad, kLostStrength);
  for (const Lost& lost : kept->lost_before(context.cursor)) {
    if (lost.way.empty()) continue;
    context.scene.show(lost_sign(context.run));
    std::vector<Point> way = lost.way;
    for (Point& point : way) point = context.seen(point);
    add_through_layers(context, {std::move(way), colour, context.pixels(1), 0, context.pixels(3)});
  }
}

void lost_in_space(SolidPen& pen) {
  const std::size_t cursor = pen.context().cursor;
  const KeptInReplan* kept = pen.context().memory.kept_by_replan(pen.context().run, cursor);
  if (kept == nullptr) return;
  for (const Lost& lost : kept->lost_before(cursor)) {
    if (lost.way.empty()) continue;
    pen.show(lost_sign(pen.context().run));
    pen.polyline(lost.way, faded(pen.palette().bad, kLostStrength), 1);
  }
}

void draw_repairs(SceneContext& context) {
  if (keeps_no_cells(context.run)) return draw_lost(context);
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
  if (keeps_no_cells(pen.context().run)) return lost_in_space(pen);
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
  return {
      .info =
          {.label = "last repair",
           .help =
               "The cells that the last replans touched; older ones fade. Of a tree of samples what the last "
               "replan cut off, of a population the paths that it lost.",
           .at_first = true},
      .layer = Layer::frames,
      .draw = draw_repairs,
      .draw_in_space = repair_in_space};
}

}  // namespace replan
