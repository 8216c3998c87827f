#include <algorithm>

#include "core/scene/overlay.hpp"

namespace replan {
namespace {

class ConsistencySigns final : public CellMark {
 public:
  explicit ConsistencySigns(SceneContext& context)
      : context_(context),
        // A small sign in the middle, however large the cell: numbers and arrows need the rest.
        inset_(
            static_cast<float>(std::max(context.zoom * 0.3, (context.zoom - 12 * context.view.scale) / 2))) {}

  /// Planners without an rhs leave its pages untouched.
  bool turn_to(NodeId first) override {
    rhs_ = context_.state.page(EventKind::rhs, first);
    g_ = rhs_ != nullptr ? context_.state.page(EventKind::g, first) : nullptr;
    return rhs_ != nullptr;
  }
  void add(Cell cell, NodeId node) override {
    const std::size_t at = node % SearchState::kPage;
    const std::uint64_t g = g_ != nullptr ? g_[at] : static_cast<std::uint64_t>(Cost::kInfinityRaw);
    if (g == rhs_[at]) return;
    const bool over = g > rhs_[at];
    context_.scene.show(over ? Sign::over : Sign::under);
    mark_cell(context_, cell, over ? OutlineShape::up : OutlineShape::down,
              over ? context_.palette.accent : context_.palette.warning, 1, context_.pixels(1.4), inset_);
  }

 private:
  SceneContext& context_;
  float inset_;
  const std::uint64_t* rhs_ = nullptr;
  const std::uint64_t* g_ = nullptr;
};

std::unique_ptr<CellMark> consistency_signs(SceneContext& context) {
  return std::make_unique<ConsistencySigns>(context);
}

}  // namespace

OverlayKind overlay_consistency() {
  return {.info = {.label = "consistency",
                   .help = "Cells whose g and rhs differ: with g > rhs they can be settled, with g < rhs "
                           "they must be raised first.",
                   .key = '5'},
          .layer = Layer::frames,
          .each = consistency_signs};
}

}  // namespace replan
