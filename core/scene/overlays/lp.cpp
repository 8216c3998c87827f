#include <algorithm>
#include <cmath>

#include "core/scene/overlay.hpp"
#include "core/scene/solid_pen.hpp"

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

/// In space of layers of no more cells.
constexpr int kMostArrowsInSpace = 20'000;

void parent_in_space(SolidPen& pen, NodeId node) {
  const NodeId parent = pen.state().lp(node);
  if (parent == kNoNode || parent == node || pen.state().known_blocked(node)) return;
  const Point at = pen.context().centre(node), to = pen.context().centre(parent), from = pen.on_sheet(at);
  const auto part = [&](double t) {
    return Point{from.x + t * (to.x - at.x), from.y + t * (to.y - at.y), from.z + t * (to.z - at.z)};
  };
  pen.show(Sign::lp);
  pen.line(part(-0.2), part(0.2), pen.palette().arrow, 1);
  pen.line(part(0.2), part(0.32), pen.palette().arrow, 2.6f);
}

/// In the slice alone: everywhere they would hide each other.
void parents_in_space(SolidPen& pen) {
  const Sheet& slice = pen.slice();
  if (static_cast<std::int64_t>(slice.box.width()) * slice.box.height() > kMostArrowsInSpace) return;
  for (int row = 0; row < slice.box.height(); ++row)
    for (int column = 0; column < slice.box.width(); ++column)
      parent_in_space(pen, slice.box.node({column, row, slice.layer}));
}

}  // namespace

OverlayKind overlay_lp() {
  return {.info = {.label = "lp",
                   .help = "Local parents: the neighbour that each cell's rhs comes from.",
                   .key = '8',
                   .at_first = true},
          .layer = Layer::arrows,
          .each = local_parents,
          .draw_in_space = parents_in_space};
}

}  // namespace replan
