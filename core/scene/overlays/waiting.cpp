#include "core/scene/numbers.hpp"
#include "core/scene/overlay.hpp"

namespace replan {
namespace {

/// A ground of their own for the numbers of cells that wait, from where they can be read; the numbers themselves are in
/// core/scene/numbers.cpp.
class WaitingGrounds final : public CellMark {
 public:
  explicit WaitingGrounds(SceneContext& context)
      : context_(context), lookahead_(context.run.info().values.lookahead()), inset_(context.world(2)) {}

  bool turn_to(NodeId first) override {
    return context_.state.touched(lookahead_ ? EventKind::rhs : EventKind::queue, first);
  }

  void add(Cell cell, NodeId node) override {
    if (!waits(context_, node)) return;
    if (lookahead_) context_.scene.show(Sign::two_values);
    // What is blocked, as a repair finds it, is still to be seen.
    const double ground = context_.state.known_blocked(node) ? 0.5 : static_cast<double>(kWaitingGround);
    context_.add(Outline{cell.x + inset_, cell.y + inset_, 1 - 2 * inset_, 1 - 2 * inset_,
                         OutlineShape::filled, faded(context_.palette.background, ground), 0, 0});
  }

 private:
  SceneContext& context_;
  bool lookahead_;
  double inset_;
};

std::unique_ptr<CellMark> waiting_grounds(SceneContext& context) {
  if (NumberLayout(context).waiting == NumbersShown::none) return nullptr;
  return std::make_unique<WaitingGrounds>(context);
}

}  // namespace

OverlayKind overlay_waiting() {
  return {
      .info =
          {.label = "waits: g / rhs",
           .help =
               "Near enough to read: in cells that the search still has to deal with, g above rhs. A planner "
               "without an rhs has g there alone.",
           .at_first = true},
      .layer = Layer::frames,
      .each = waiting_grounds};
}

}  // namespace replan
