#include "core/scene/overlay.hpp"

namespace replan {
namespace {

/// A shade around the obstacles, as wide as the robot.
class SizeShade final : public CellMark {
 public:
  explicit SizeShade(SceneContext& context)
      : context_(context), zone_(context.memory.zone), colour_(faded(context.palette.obstacle, 0.4)) {
    zone_.follow(context.run, context.memory.digest);
  }

  void add(Cell cell, NodeId node) override {
    if (zone_.cells()[node] == 0 || context_.state.known_blocked(node)) return;
    context_.scene.show(Sign::too_near);
    mark_cell(context_, cell, OutlineShape::filled, colour_, 1, 0, 0);
  }

 private:
  SceneContext& context_;
  SizeZone& zone_;
  Colour colour_;
};

std::unique_ptr<CellMark> size_shade(SceneContext& context) {
  if (context.run.scenario().robot.radius <= 0) return nullptr;
  return std::make_unique<SizeShade>(context);
}

}  // namespace

OverlayKind overlay_size() {
  return {
      .info = {.label = "too near",
               .help =
                   "Free cells that are nearer to an obstacle than the radius of a robot that has one: its "
                   "centre keeps out of them.",
               .at_first = true},
      .layer = Layer::lines,
      .each = size_shade};
}

}  // namespace replan
