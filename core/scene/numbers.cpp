// Numbers inside cells: g in the middle from a readable zoom on, all values in the corners from a larger one.
#include <cstdio>

#include "core/scene/context.hpp"

namespace replan {
namespace {

std::string number(Cost cost) {
  if (cost.is_infinite()) return "∞";
  const double value = cost.to_double();
  char text[32];
  std::snprintf(text, sizeof text, value < 1000 ? "%.1f" : "%.0f", value);
  return text;
}

void add_corners(SceneContext& context, Cell cell, NodeId node, double strength) {
  const SearchState& state = context.state;
  const double inset = context.world(4);
  const double x0 = cell.x + inset, y0 = cell.y + inset, x1 = cell.x + 1 - inset, y1 = cell.y + 1 - inset;
  const Colour strong = faded(context.palette.text, strength),
               soft = faded(context.palette.text, strength * 0.7);
  if (!state.g(node).is_infinite() || !state.rhs(node).is_infinite())
    context.add(Label{{x0, y0}, Anchor::upper_left, strong, number(state.g(node))});
  if (!state.rhs(node).is_infinite() || (state.touched(EventKind::rhs, node) && !state.g(node).is_infinite()))
    context.add(Label{{x1, y0}, Anchor::upper_right, strong, number(state.rhs(node))});
  if (state.queued(node)) {
    context.add(Label{{x0, y1}, Anchor::lower_left, soft, number(state.k1(node))});
    context.add(Label{{x1, y1}, Anchor::lower_right, soft, number(state.k2(node))});
  }
  if (state.dist(node) > Cost::zero()) {
    // Below the arrow, which has the very middle.
    const double below = context.has(Overlay::lp) ? context.world(13) : 0;
    context.add(Label{{cell.x + 0.5, cell.y + 0.5 + below}, Anchor::middle, soft, number(state.dist(node))});
  }
}

}  // namespace

void build_numbers(SceneContext& context) {
  const double corners = context.grown(68, 76), middle = context.grown(40, 46) * (1 - corners);
  if (!context.has(Overlay::numbers) || (middle <= 0 && corners <= 0)) return;
  const bool beside_arrow = context.has(Overlay::lp);
  for (int y = context.top; y < context.bottom; ++y)
    for (int x = context.left; x < context.right; ++x) {
      const Cell cell{x, y, context.slice};
      const NodeId node = context.lattice.node(cell);
      if (context.state.known_blocked(node)) continue;
      if (corners > 0) add_corners(context, cell, node, corners);
      if (middle <= 0 || context.state.g(node).is_infinite()) continue;
      const double rise = beside_arrow ? context.world(14) : 0;
      context.add(Label{{x + 0.5, y + 0.5 - rise},
                        Anchor::middle,
                        faded(context.palette.text, middle),
                        number(context.state.g(node))});
    }
}

}  // namespace replan
