#include "core/scene/overlay.hpp"

namespace replan {
namespace {

/// What the robot does not know is hatched one way, what it wrongly believes the other way. Their grounds are in
/// core/scene/raster.cpp.
class UnknownHatches final : public CellMark {
 public:
  UnknownHatches(SceneContext& context, double strength)
      : context_(context),
        colour_(faded(context.palette.background, strength * 0.8)),
        width_(context.pixels(1.2)) {}

  void add(Cell cell, NodeId node) override {
    const bool truth = context_.state.truly_blocked(node);
    if (truth == context_.state.known_blocked(node)) return;
    const int x = cell.x, y = cell.y;
    for (const double at : {0.25, 0.75}) {
      // Two strokes a cell, which go on in the next one.
      const double reach = at < 0.5 ? 2 * at : 2 * (1 - at);
      const double a = at < 0.5 ? 0 : 1 - reach, b = a + reach;
      if (truth)
        context_.add(Line{{x + a, y + b}, {x + b, y + a}, colour_, width_});
      else
        context_.add(Line{{x + a, y + 1 - b}, {x + b, y + 1 - a}, colour_, width_});
    }
  }

 private:
  SceneContext& context_;
  Colour colour_;
  float width_;
};

std::unique_ptr<CellMark> unknown_hatches(SceneContext& context) {
  const double strength = context.grown(5, 9);
  if (strength <= 0) return nullptr;
  return std::make_unique<UnknownHatches>(context, strength);
}

}  // namespace

OverlayKind overlay_unknown() {
  return {.info = {.label = "unknown",
                   .help = "Obstacles that the robot does not know yet, and those that are gone.",
                   .at_first = true},
          .layer = Layer::hatches,
          .each = unknown_hatches};
}

}  // namespace replan
