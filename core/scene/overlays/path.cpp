#include "core/scene/overlay.hpp"
#include "core/scene/routes.hpp"
#include "core/scene/solid_pen.hpp"

namespace replan {
namespace {

void path_in_space(SolidPen& pen) {
  const PathLine path = path_line(pen.context());
  if (path.points.size() < 2) return;
  pen.show(Sign::path);
  pen.polyline(path.points, faded(pen.palette().path, path.searching ? 0.4 : 1), 3.5f);
  pen.path(path.points);
}

}  // namespace

/// Its shapes on a slice are in core/scene/routes.cpp.
OverlayKind overlay_path() {
  return {.info = {.label = "path", .help = "The path of the latest plan.", .at_first = true},
          .layer = Layer::routes,
          .draw_in_space = path_in_space};
}

}  // namespace replan
