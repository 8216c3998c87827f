#include <algorithm>
#include <cmath>

#include "core/scene/overlay.hpp"

namespace replan {
namespace {

class LocalParents final : public CellMark {
 public:
  LocalParents(SceneContext& context, double strength)
      : context_(context),
        colour_(faded(context.palette.arrow, strength)),
        length_(std::clamp(0.5, context.world(7), context.world(18))),
        signs_(context.has(Overlay::consistency)) {}

  void add(Cell, NodeId node) override {
    const SearchState& state = context_.state;
    const NodeId parent = state.lp(node);
    if (state.known_blocked(node) || parent == kNoNode || parent == node) return;
    if (signs_ && state.touched(EventKind::rhs, node) && state.g(node) != state.rhs(node)) return;
    add_arrow(node, parent);
    context_.scene.show(Sign::lp);
  }

 private:
  /// Towards the parent, in the middle of the cell.
  void add_arrow(NodeId node, NodeId parent) {
    const Point from = context_.centre(node), to = context_.centre(parent);
    const double dx = to.x - from.x, dy = to.y - from.y, distance = std::hypot(dx, dy);
    if (distance == 0) return;
    const double reach = length_ / 2 / distance;
    context_.add(Arrow{{from.x - dx * reach, from.y - dy * reach},
                       {from.x + dx * reach, from.y + dy * reach},
                       colour_,
                       context_.pixels(1),
                       context_.pixels(2.5)});
  }

  SceneContext& context_;
  Colour colour_;
  double length_;
  bool signs_;  // of consistency: they stand where the arrow would
};

std::unique_ptr<CellMark> local_parents(SceneContext& context) {
  const double strength = context.grown(9, 13);
  if (strength <= 0) return nullptr;
  return std::make_unique<LocalParents>(context, strength);
}

}  // namespace

OverlayKind overlay_lp() {
  return {.info = {.label = "lp",
                   .help = "Local parents: the neighbour that each cell's rhs comes from.",
                   .key = '8',
                   .at_first = true},
          .layer = Layer::arrows,
          .each = local_parents};
}

}  // namespace replan
