#include <algorithm>
#include <cstdio>

#include "core/scene/overlay.hpp"

namespace replan {
namespace {

std::string number(Cost cost) {
  if (cost.is_infinite()) return "∞";
  const double value = cost.to_double();
  char text[32];
  std::snprintf(text, sizeof text, value < 1000 ? "%.1f" : "%.0f", value);
  return text;
}

/// The second key component of a cell in the open list, as the planner has declared it.
Cost second_key(const SceneContext& context, NodeId node) {
  const ListOrder& order = context.run.info().values.order;
  const auto read = [&](EventKind kind) {
    return Cost{static_cast<std::int64_t>(context.state.value(kind, node))};
  };
  return order.of(context.state.k1(node), read(order.reads[0]), read(order.reads[1]));
}

/// Whether a cell waits because its two values differ: that mark gives both of them a ground and a colour each.
bool stands_out(const SceneContext& context, NodeId node) {
  return context.has(Overlay::waiting) && context.state.touched(EventKind::rhs, node) &&
         context.state.g(node) != context.state.rhs(node);
}

void add_corners(SceneContext& context, Cell cell, NodeId node, double strength) {
  const SearchState& state = context.state;
  const double inset = context.world(4);
  const double x0 = cell.x + inset, y0 = cell.y + inset, x1 = cell.x + 1 - inset, y1 = cell.y + 1 - inset;
  const Colour strong = faded(context.palette.text, strength),
               soft = faded(context.palette.text, strength * 0.7),
               rhs = stands_out(context, node) ? faded(context.palette.rhs, strength) : strong;
  if (!state.g(node).is_infinite() || !state.rhs(node).is_infinite())
    context.add(Label{{x0, y0}, Anchor::upper_left, strong, number(state.g(node))});
  if (!state.rhs(node).is_infinite() || (state.touched(EventKind::rhs, node) && !state.g(node).is_infinite()))
    context.add(Label{{x1, y0}, Anchor::upper_right, rhs, number(state.rhs(node))});
  if (state.queued(node)) {
    context.add(Label{{x0, y1}, Anchor::lower_left, soft, number(state.k1(node))});
    context.add(Label{{x1, y1}, Anchor::lower_right, soft, number(second_key(context, node))});
  }
  if (state.dist(node) > Cost::zero()) {
    // Below the arrow, which has the very middle.
    const double below = context.has(Overlay::lp) ? context.world(13) : 0;
    context.add(Label{{cell.x + 0.5, cell.y + 0.5 + below}, Anchor::middle, soft, number(state.dist(node))});
  }
}

/// Values of free cells: g in the middle from a readable zoom on, all in the corners from a larger one; with lines
/// between the cells, so that it is plain whose they are.
class Numbers final : public CellMark {
 public:
  Numbers(SceneContext& context, double corners, double middle)
      : context_(context), corners_(corners), middle_(middle), beside_arrow_(context.has(Overlay::lp)) {
    context.scene.numbers = corners > 0 ? NumbersShown::four : NumbersShown::one;
    add_cell_lines(context, faded(context.palette.dim, 0.35 * std::max(corners, middle)));
  }

  void add(Cell cell, NodeId node) override {
    if (context_.state.known_blocked(node) && !stands_out(context_, node)) return;
    if (corners_ > 0) add_corners(context_, cell, node, corners_);
    if (middle_ <= 0 || context_.state.g(node).is_infinite() || stands_out(context_, node)) return;
    const double rise = beside_arrow_ ? context_.world(14) : 0;
    context_.add(Label{{cell.x + 0.5, cell.y + 0.5 - rise},
                       Anchor::middle,
                       faded(context_.palette.text, middle_),
                       number(context_.state.g(node))});
  }

 private:
  SceneContext& context_;
  double corners_, middle_;  // how strong they are
  bool beside_arrow_;
};

std::unique_ptr<CellMark> numbers(SceneContext& context) {
  const double corners = context.grown(68, 76), middle = context.grown(40, 46) * (1 - corners);
  if (middle <= 0 && corners <= 0) return nullptr;
  return std::make_unique<Numbers>(context, corners, middle);
}

}  // namespace

OverlayKind overlay_numbers() {
  return {.info = {.label = "numbers",
                   .help = "g, rhs, key and dist inside the cells, from a readable zoom on.",
                   .key = '7'},
          .layer = Layer::numbers,
          .each = numbers};
}

}  // namespace replan
