#include "core/scene/numbers.hpp"
#include "core/scene/overlay.hpp"
#include "core/scene/solid_pen.hpp"

namespace replan {
namespace {

/// From so many design pixels a cell on the corners can be told apart; in smaller cells stands a dot.
constexpr double kCornersFrom = 12;

class OpenListMarks final : public CellMark {
 public:
  explicit OpenListMarks(SceneContext& context)
      : context_(context),
        corners_(context.zoom / context.view.scale >= kCornersFrom),
        // Off the digits where there are some, and off the neighbours' corners elsewhere.
        inset_(NumberLayout(context).waiting == NumbersShown::none ? context.pixels(1) : 0) {}

  bool turn_to(NodeId first) override {
    page_ = context_.state.page(EventKind::queue, first);
    return page_ != nullptr;
  }
  void add(Cell cell, NodeId node) override {
    if (page_[node % SearchState::kPage] == 0) return;
    context_.scene.show(Sign::queue);
    if (corners_)
      mark_cell(context_, cell, OutlineShape::corners, context_.palette.accent, 1, context_.pixels(1.6),
                inset_);
    else
      add_dot(cell);
  }

 private:
  /// In the middle, a third of the cell wide, but to be seen.
  void add_dot(Cell cell) {
    const double side = std::min(1.0, std::max(0.36, context_.world(2)));
    const double inset = (1 - side) / 2;
    context_.add(Outline{cell.x + inset, cell.y + inset, side, side, OutlineShape::filled,
                         context_.palette.accent, 0, 0});
  }

  SceneContext& context_;
  bool corners_;
  float inset_;
  const std::uint64_t* page_ = nullptr;
};

/// Where a pixel covers several cells, the front of a search is too thin to be met by the cell that is looked at.
std::unique_ptr<CellMark> open_list_marks(SceneContext& context) {
  return context.zoom >= 1 ? std::make_unique<OpenListMarks>(context) : nullptr;
}

void open_list_in_space(SolidPen& pen) {
  if (pen.slice_alone()) return;
  OpenCells& open = pen.context().memory.open;
  open.follow(pen.context().run, pen.deadline());
  if (open.behind()) pen.go_on();
  if (pen.state().queue_size() > 0) pen.show(Sign::queue);
  open.each(
      [&](NodeId node) { return pen.cube(pen.context().centre(node), kWaitingHalf, pen.palette().accent); });
}

}  // namespace

OverlayKind overlay_queue() {
  return {.info = {.label = "open list",
                   .help = "The cells that wait in the open list: corners, and dots where cells are small.",
                   .key = '6',
                   .at_first = true},
          .layer = Layer::frames,
          .each = open_list_marks,
          .draw_in_space = open_list_in_space};
}

}  // namespace replan
