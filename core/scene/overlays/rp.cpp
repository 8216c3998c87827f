#include "core/scene/overlay.hpp"

namespace replan {
namespace {

/// Rays to the remote parents, and the chain of parents of the cells that are pointed at.
class RemoteParents final : public CellMark {
 public:
  explicit RemoteParents(SceneContext& context)
      : context_(context),
        // Others write an rp too, and nothing reads it.
        any_angle_(context.run.info().any_angle),
        strength_(any_angle_ ? context.grown(26, 40) : 0),
        colour_(faded(context.palette.accent, strength_ * 0.28)) {}

  [[nodiscard]] bool wants_cells() const override { return strength_ > 0; }
  void add(Cell, NodeId node) override {
    const SearchState& state = context_.state;
    const NodeId parent = state.rp(node);
    if (state.known_blocked(node) || parent == kNoNode || parent == node || parent == state.lp(node)) return;
    context_.add(Arrow{context_.centre(node), context_.centre(parent), colour_, context_.pixels(1),
                       context_.pixels(5)});
    context_.scene.show(Sign::rp);
  }
  void finish() override {
    for (const auto& cell : {context_.view.pinned, context_.view.hovered})
      if (cell && context_.run.lattice().contains(*cell)) add_chain(context_.run.lattice().node(*cell));
  }

 private:
  /// From a cell to the goal: the remote parents, straight; local ones where there are no others.
  void add_chain(NodeId node) {
    const std::size_t most = 10000;  // `remote_parents=printed` can lead in a circle
    for (std::size_t i = 0; i < most; ++i) {
      const bool straight = any_angle_ && context_.state.rp(node) != kNoNode;
      const NodeId parent = straight ? context_.state.rp(node) : context_.state.lp(node);
      if (parent == kNoNode || parent == node) return;
      // In small cells the heads would hide the line.
      const auto head = static_cast<float>(context_.pixels(6) * context_.grown(5, 7));
      context_.add(Arrow{context_.centre(node), context_.centre(parent), context_.palette.accent,
                         context_.line_width(1.6), head});
      context_.scene.show(straight ? Sign::rp : Sign::lp);
      node = parent;
    }
  }

  SceneContext& context_;
  bool any_angle_;
  double strength_;
  Colour colour_;
};

std::unique_ptr<CellMark> remote_parents(SceneContext& context) {
  return std::make_unique<RemoteParents>(context);
}

}  // namespace

OverlayKind overlay_rp() {
  return {.info = {.label = "rp",
                   .help = "Remote parents: the cell in sight that the path goes to straight.",
                   .key = '9',
                   .at_first = true},
          .layer = Layer::arrows,
          .each = remote_parents};
}

}  // namespace replan
