#include "core/debug/cell_set.hpp"
#include "core/debug/shown_family.hpp"
#include "core/scene/overlay.hpp"
#include "core/scene/solid_pen.hpp"

namespace replan {
namespace {

/// Of the fill of what hangs below: the field is to be seen through it.
constexpr double kBelowFill = 0.3;
/// Half of the side of a cell's small cube in space.
constexpr double kBelowHalf = 0.16;

/// That of this run; nullptr if it is another one's.
const ShownFamily* family_of(const Run& run, const View& view) {
  const ShownFamily* family = view.family.get();
  return family != nullptr && family->log_id == run.log_id() ? family : nullptr;
}

/// A faint fill of what hangs below, and over it, bold, what the point hangs on.
class FamilyMarks final : public CellMark {
 public:
  FamilyMarks(SceneContext& context, const ShownFamily& family) : context_(context), family_(family) {}

  [[nodiscard]] bool wants_cells() const override {
    return family_.below != nullptr && family_.below->size() > 0;
  }
  void add(Cell cell, NodeId node) override {
    if (!family_.below->has(node)) return;
    context_.scene.show(Sign::below);
    if (context_.zoom < context_.view.scale * 4)
      mark_cell(context_, cell, OutlineShape::square, context_.palette.accent, 0.8, 0, 0);
    else
      context_.add(Outline{static_cast<double>(cell.x), static_cast<double>(cell.y), 1, 1,
                           OutlineShape::filled, faded(context_.palette.accent, kBelowFill), 0, 0});
  }
  void finish() override {
    if (family_.way.size() < 2) return;
    context_.scene.show(Sign::ancestors);  // wider than the path, under which it may lie
    std::vector<Point> way;
    for (const Point& point : family_.way) way.push_back(context_.seen(point));
    add_through_layers(
        context_, {std::move(way), context_.palette.accent, context_.pixels(6), context_.palette.outline});
  }

 private:
  SceneContext& context_;
  const ShownFamily& family_;
};

std::unique_ptr<CellMark> family_marks(SceneContext& context) {
  const ShownFamily* family = family_of(context.run, context.view);
  return family != nullptr ? std::make_unique<FamilyMarks>(context, *family) : nullptr;
}

void family_in_space(SolidPen& pen) {
  const ShownFamily* family = family_of(pen.context().run, pen.context().view);
  if (family == nullptr) return;
  if (family->way.size() > 1) {
    pen.show(Sign::ancestors);
    pen.polyline(family->way, pen.palette().accent, 3.5f);
  }
  if (pen.slice_alone() || family->below == nullptr || family->below->size() == 0) return;
  pen.show(Sign::below);
  bool room = true;
  family->below->each([&](NodeId node) {
    room = room && pen.cube(pen.context().centre(node), kBelowHalf, pen.palette().accent);
  });
}

}  // namespace

void show_family(OverlaySet& overlays) {
  overlays.set(Overlay::family, true);
}

OverlayKind overlay_family() {
  return {.info = {.label = "family",
                   .help = "What the cell that the tab Analysis is about hangs on in the search, bold, and "
                           "the cells that hang on it."},
          .layer = Layer::frames,
          .each = family_marks,
          .draw_in_space = family_in_space};
}

}  // namespace replan
