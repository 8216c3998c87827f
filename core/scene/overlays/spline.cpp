#include "core/scene/overlay.hpp"
#include "core/scene/solid_pen.hpp"
#include "core/scene/spline_marks.hpp"

namespace replan {
namespace {

void draw_spline(SceneContext& context) {
  const Spline* spline = spline_at_cursor(context.run);
  if (spline == nullptr) return;
  const Palette& palette = context.palette;
  context.scene.show(Sign::control);
  Polyline control{{}, palette.dim, context.pixels(1.2), 0, context.pixels(3)};
  for (const Point& corner : spline->control) control.points.push_back(context.seen(corner));
  add_through_layers(context, std::move(control));
  for (const PullIn& pull : spline->pulled_in) {
    context.scene.show(Sign::pulled_in);
    const Point at = context.seen(pull.at), obstacle = context.centre(context.seen(pull.cell));
    add_through_layers(context, {{at, obstacle}, palette.warning, context.pixels(1.2), 0});
    context.add(Ring{at, context.world(5), context.seen_at(at, palette.warning), context.pixels(2)});
  }
}

void spline_in_space(SolidPen& pen) {
  const Spline* spline = spline_at_cursor(pen.context().run);
  if (spline == nullptr) return;
  pen.show(Sign::control);
  pen.polyline(spline->control, faded(pen.palette().dim, 0.8), 1.2f);
  for (const PullIn& pull : spline->pulled_in) {
    pen.show(Sign::pulled_in);
    pen.line(pull.at, centre_of(pull.cell), pen.palette().warning, 2);
  }
}

}  // namespace

const Spline* spline_at_cursor(const Run& run) {
  const Decision* decision = run.decision_at(run.timeline().cursor());
  if (decision == nullptr || !decision->plan->path->spline) return nullptr;
  return &*decision->plan->path->spline;
}

const PullIn* pull_in_at(const Run& run, const View& view, Cell cell) {
  const Spline* spline = view.overlays.has(Overlay::spline) ? spline_at_cursor(run) : nullptr;
  if (spline == nullptr) return nullptr;
  for (const PullIn& pull : spline->pulled_in)
    if (cell_of(pull.at) == cell || pull.cell == cell) return &pull;
  return nullptr;
}

OverlayKind overlay_spline() {
  return {
      .info = {.label = "spline",
               .help =
                   "Of a path that is a curve: the control polygon that it is drawn from, and where it was "
                   "pulled in since it would have hit an obstacle.",
               .at_first = true},
      .layer = Layer::routes,
      .draw = draw_spline,
      .draw_in_space = spline_in_space};
}

}  // namespace replan
