#include "core/scene/overlay.hpp"

namespace replan {
namespace {

class OpenListMarks final : public CellMark {
 public:
  explicit OpenListMarks(SceneContext& context) : context_(context) {}

  bool turn_to(NodeId first) override {
    page_ = context_.state.page(EventKind::queue, first);
    return page_ != nullptr;
  }
  void add(Cell cell, NodeId node) override {
    if (page_[node % SearchState::kPage] == 0) return;
    context_.scene.show(Sign::queue);
    mark_cell(context_, cell, OutlineShape::corners, context_.palette.accent, 1, context_.pixels(1.6),
              context_.pixels(1));
  }

 private:
  SceneContext& context_;
  const std::uint64_t* page_ = nullptr;
};

std::unique_ptr<CellMark> open_list_marks(SceneContext& context) {
  return std::make_unique<OpenListMarks>(context);
}

}  // namespace

OverlayKind overlay_queue() {
  return {.info = {.label = "open list", .help = "The cells that wait in the open list.", .key = '6'},
          .layer = Layer::frames,
          .each = open_list_marks};
}

}  // namespace replan
