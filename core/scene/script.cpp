#include "core/scene/script.hpp"

namespace replan {

bool is_to_come(const Run& run, std::size_t surprise) {
  const std::size_t cursor = run.timeline().cursor();
  const Decision* decision = run.decision_at(cursor);
  if (decision == nullptr) return true;
  if (surprise < decision->fired.size() && decision->fired[surprise]) return false;
  // It may have happened since, with the repair still under way.
  const auto milestones = run.milestones();
  for (std::size_t i = milestones.size(); i-- > 0 && milestones[i].event >= decision->event;)
    if (milestones[i].kind == EventKind::surprise && milestones[i].event < cursor &&
        milestones[i].payload == surprise)
      return false;
  return true;
}

std::vector<Point> way_points(const MovingObstacle& mover) {
  std::vector<Point> points;
  for (const Cell corner : mover.way)
    points.push_back(
        {corner.x + mover.width / 2.0, corner.y + mover.height / 2.0, corner.z + mover.depth / 2.0});
  return points;
}

void show_script(OverlaySet& overlays) {
  overlays.set(Overlay::script, true);
}

}  // namespace replan
