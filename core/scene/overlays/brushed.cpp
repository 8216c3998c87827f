#include "core/debug/cell_set.hpp"
#include "core/scene/overlay.hpp"
#include "core/scene/solid_pen.hpp"

namespace replan {
namespace {

/// Up to so many cells each is drawn by itself where cells are smaller than pixels, so that none is missed.
constexpr std::size_t kFewBrushed = 20'000;
/// Half of the side of a cell's small cube in space.
constexpr double kBrushedHalf = 0.16;

/// Those of this run; nullptr if there are none.
const CellSet* brushed_of(const Run& run, const View& view) {
  const CellSet* brushed = view.brushed.get();
  return brushed != nullptr && brushed->log_id() == run.log_id() && brushed->size() > 0 ? brushed : nullptr;
}

/// Cells large enough to be met: each is tinted, and has a rim where there is room for one.
class BrushedMarks final : public CellMark {
 public:
  BrushedMarks(SceneContext& context, const CellSet& brushed) : context_(context), brushed_(brushed) {}

  void add(Cell cell, NodeId node) override {
    if (!brushed_.has(node)) return;
    context_.scene.show(Sign::brushed);
    const auto x = static_cast<double>(cell.x), y = static_cast<double>(cell.y);
    context_.add(Outline{x, y, 1, 1, OutlineShape::filled, faded(context_.palette.mover, fill_), 0, 0});
    if (rim_ > 0)
      context_.add(Outline{x, y, 1, 1, OutlineShape::square, faded(context_.palette.mover, rim_),
                           context_.pixels(1.6), context_.pixels(1)});
  }

 private:
  SceneContext& context_;
  const CellSet& brushed_;
  double rim_ = context_.grown(6, 11);
  double fill_ = 0.75 - 0.4 * rim_;
};

/// Where cells are smaller than pixels: few of them as dots that can be seen.
void draw_few(SceneContext& context, const CellSet& brushed) {
  const double side = std::max(1.0, context.world(3));
  brushed.each([&](NodeId node) {
    const Cell cell = context.lattice.position(node);
    if (!context.in_sight(cell)) return;
    context.scene.show(Sign::brushed);
    context.add(Outline{cell.x + (1 - side) / 2, cell.y + (1 - side) / 2, side, side, OutlineShape::filled,
                        context.palette.mover, 0, 0});
  });
}

/// And of many what the pixels meet.
class BrushedTint final : public CellMark {
 public:
  BrushedTint(SceneContext& context, const CellSet& brushed) : context_(context), brushed_(brushed) {}
  void add(Cell cell, NodeId node) override {
    if (!brushed_.has(node)) return;
    context_.scene.show(Sign::brushed);
    mark_cell(context_, cell, OutlineShape::square, context_.palette.mover, 1, 0, 0);
  }

 private:
  SceneContext& context_;
  const CellSet& brushed_;
};

std::unique_ptr<CellMark> brushed_marks(SceneContext& context) {
  const CellSet* brushed = brushed_of(context.run, context.view);
  if (brushed == nullptr) return nullptr;
  if (context.zoom / context.view.scale >= 4) return std::make_unique<BrushedMarks>(context, *brushed);
  if (brushed->size() > kFewBrushed) return std::make_unique<BrushedTint>(context, *brushed);
  draw_few(context, *brushed);
  return nullptr;
}

void brushed_in_space(SolidPen& pen) {
  const CellSet* brushed = brushed_of(pen.context().run, pen.context().view);
  if (brushed == nullptr || pen.slice_alone()) return;
  pen.show(Sign::brushed);
  bool room = true;
  brushed->each([&](NodeId node) {
    room = room && pen.cube(pen.context().centre(node), kBrushedHalf, pen.palette().mover);
  });
}

}  // namespace

void show_brushed(OverlaySet& overlays) {
  overlays.set(Overlay::brushed, true);
}

OverlayKind overlay_brushed() {
  return {.info = {.label = "brushed",
                   .help = "The cells of the points that were chosen by a rectangle in the scatter plot."},
          .layer = Layer::frames,
          .each = brushed_marks,
          .draw_in_space = brushed_in_space};
}

}  // namespace replan
