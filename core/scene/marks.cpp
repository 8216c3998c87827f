// Marks of single cells: grid lines, hatches, arrows, outlines.
#include <algorithm>
#include <cmath>

#include "core/scene/context.hpp"

namespace replan {

void build_grid(SceneContext& context) {
  const Palette& palette = context.palette;
  const auto columns = static_cast<double>(context.lattice.width()),
             rows = static_cast<double>(context.lattice.height());
  // The world's rim: what lies outside can no more be entered than an obstacle.
  const double rim = std::min(1.0, context.world(14));
  for (const Outline& side :
       {Outline{-rim, -rim, columns + 2 * rim, rim, OutlineShape::filled, palette.obstacle, 0, 0},
        Outline{-rim, rows, columns + 2 * rim, rim, OutlineShape::filled, palette.obstacle, 0, 0},
        Outline{-rim, 0, rim, rows, OutlineShape::filled, palette.obstacle, 0, 0},
        Outline{columns, 0, rim, rows, OutlineShape::filled, palette.obstacle, 0, 0}})
    context.add(side);
  const double strength = context.grown(5, 10);
  if (!context.has(Overlay::grid) || strength <= 0) return;
  const Colour colour = faded(palette.grid, strength);
  const float width = std::max(1.0f, std::floor(context.pixels(1)));
  for (int x = context.left; x <= context.right; ++x)
    context.add(Line{{static_cast<double>(x), static_cast<double>(context.top)},
                     {static_cast<double>(x), static_cast<double>(context.bottom)},
                     colour,
                     width});
  for (int y = context.top; y <= context.bottom; ++y)
    context.add(Line{{static_cast<double>(context.left), static_cast<double>(y)},
                     {static_cast<double>(context.right), static_cast<double>(y)},
                     colour,
                     width});
}

// What the robot does not know is hatched one way, what it wrongly believes the other way.
void build_hatches(SceneContext& context) {
  const double strength = context.grown(5, 9);
  if (!context.has(Overlay::unknown) || strength <= 0) return;
  const Colour colour = faded(context.palette.background, strength * 0.8);
  const float width = context.pixels(1.2);
  for (int y = context.top; y < context.bottom; ++y)
    for (int x = context.left; x < context.right; ++x) {
      const NodeId node = context.node(x, y);
      const bool truth = context.state.truly_blocked(node);
      if (truth == context.state.known_blocked(node)) continue;
      for (const double at : {0.25, 0.75}) {
        // Two strokes a cell, which go on in the next one.
        const double reach = at < 0.5 ? 2 * at : 2 * (1 - at);
        const double a = at < 0.5 ? 0 : 1 - reach, b = a + reach;
        if (truth)
          context.add(Line{{x + a, y + b}, {x + b, y + a}, colour, width});
        else
          context.add(Line{{x + a, y + 1 - b}, {x + b, y + 1 - a}, colour, width});
      }
    }
}

namespace {

void add_parent_arrow(SceneContext& context, NodeId node, NodeId parent, Colour colour, double length) {
  const Point from = context.centre(node), to = context.centre(parent);
  const double dx = to.x - from.x, dy = to.y - from.y, distance = std::hypot(dx, dy);
  if (distance == 0) return;
  const double reach = length / 2 / distance;
  context.add(Arrow{{from.x - dx * reach, from.y - dy * reach},
                    {from.x + dx * reach, from.y + dy * reach},
                    colour,
                    context.pixels(1),
                    context.pixels(2.5)});
}

/// The remote parents from a cell to the goal, straight; local ones where there are no others.
void add_remote_chain(SceneContext& context, NodeId node) {
  const bool remote = context.run.info().any_angle;
  const std::size_t most = 10000;  // `remote_parents=printed` can lead in a circle
  for (std::size_t i = 0; i < most; ++i) {
    const bool straight = remote && context.state.rp(node) != kNoNode;
    const NodeId parent = straight ? context.state.rp(node) : context.state.lp(node);
    if (parent == kNoNode || parent == node) return;
    context.add(Arrow{context.centre(node), context.centre(parent), context.palette.accent,
                      context.pixels(1.6), context.pixels(6)});
    context.scene.show(straight ? Sign::rp : Sign::lp);
    node = parent;
  }
}

}  // namespace

void build_arrows(SceneContext& context) {
  const double local = context.has(Overlay::lp) ? context.grown(9, 13) : 0;
  const bool has_remote = context.run.info().any_angle;  // others write an rp too, and nothing reads it
  const double remote = context.has(Overlay::rp) && has_remote ? context.grown(26, 40) : 0;
  const double length = std::clamp(0.5, context.world(7), context.world(18));
  const Colour arrow = faded(context.palette.arrow, local),
               ray = faded(context.palette.accent, remote * 0.28);
  const bool signs = context.has(Overlay::consistency);  // they stand where the arrow would
  for (int y = context.top; (local > 0 || remote > 0) && y < context.bottom; ++y)
    for (int x = context.left; x < context.right; ++x) {
      const NodeId node = context.node(x, y);
      if (context.state.known_blocked(node)) continue;
      const NodeId lp = context.state.lp(node), rp = context.state.rp(node);
      if (remote > 0 && rp != kNoNode && rp != node && rp != lp) {
        context.add(
            Arrow{context.centre(node), context.centre(rp), ray, context.pixels(1), context.pixels(5)});
        context.scene.show(Sign::rp);
      }
      const bool has_sign = signs && context.state.touched(EventKind::rhs, node) &&
                            context.state.g(node) != context.state.rhs(node);
      if (local > 0 && lp != kNoNode && lp != node && !has_sign) {
        add_parent_arrow(context, node, lp, arrow, length);
        context.scene.show(Sign::lp);
      }
    }
  if (!context.has(Overlay::rp)) return;
  for (const auto& cell : {context.view.pinned, context.view.hovered})
    if (cell && context.lattice.contains(*cell)) add_remote_chain(context, context.lattice.node(*cell));
}

namespace {

Outline mark(Cell cell, OutlineShape shape, Colour colour, float stroke, float inset) {
  return {static_cast<double>(cell.x), static_cast<double>(cell.y), 1, 1, shape, colour, stroke, inset};
}

void tint(SceneContext& context, Cell cell, Colour colour, double strength) {
  Raster& raster = context.scene.raster;
  if (raster.texels.empty()) return;
  const auto place = [](double at, double extent, int count) {
    return std::clamp(static_cast<int>(std::floor(at / extent * count)), 0, count - 1);
  };
  const int column = place(cell.x + 0.5 - raster.x, raster.width, raster.columns);
  const int row = place(cell.y + 0.5 - raster.y, raster.height, raster.rows);
  Colour& texel = raster.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns) +
                                static_cast<std::size_t>(column)];
  texel = mix(texel, colour | 0xFF000000u, static_cast<float>(strength));
}

/// Outlined where cells are large enough for it, tinted where they are small.
void add_mark(SceneContext& context, Cell cell, OutlineShape shape, Colour colour, double strength,
              float stroke, float inset) {
  const double outlined = context.grown(kOutlineFrom, kOutlineTo);
  if (outlined < 1) tint(context, cell, colour, (1 - outlined) * strength * 0.8);
  if (outlined > 0) context.add(mark(cell, shape, faded(colour, outlined * strength), stroke, inset));
}

void add_repairs(SceneContext& context) {
  const RunDigest& digest = context.memory.digest;
  const std::size_t count = digest.plans_before(context.cursor);
  for (std::size_t age = std::min(kRepairsShown, count > 0 ? count - 1 : 0); age-- > 0;) {
    const PlanSpan& plan = digest.plans()[count - 1 - age];
    for (const Touch& touch : digest.touches_before(plan, context.cursor)) {
      const Cell cell = context.lattice.position(touch.node);
      if (!context.in_sight(cell)) continue;
      context.scene.show(Sign::repair);
      add_mark(context, cell, OutlineShape::square, context.palette.warning, repair_strength(age),
               context.pixels(1.4), context.pixels(1));
    }
  }
}

/// Marks the open list and the inconsistent cells, page by page: most of a large map was never touched.
class StateMarks {
 public:
  explicit StateMarks(SceneContext& context)
      : context_(context),
        queue_(context.has(Overlay::queue)),
        consistency_(context.has(Overlay::consistency)),
        step_(std::max(1, static_cast<int>(1 / context.zoom))),
        // A small sign in the middle, however large the cell: numbers and arrows need the rest.
        inset_(
            static_cast<float>(std::max(context.zoom * 0.3, (context.zoom - 12 * context.view.scale) / 2))) {}

  void add() {
    if (!queue_ && !consistency_) return;
    for (int y = context_.top; y < context_.bottom; y += step_)
      for (int x = context_.left; x < context_.right;) x = add_stretch(x, y);
  }

 private:
  /// From cell (x, y) to the end of its page or row; returns where to go on.
  int add_stretch(int x, int y) {
    constexpr std::size_t kPage = SearchState::kPage;
    const NodeId node = context_.node(x, y);
    const auto page = [&](EventKind kind, bool wanted) {
      return wanted ? context_.state.page(kind, node) : nullptr;
    };
    const std::uint64_t* queue = page(EventKind::queue, queue_);
    // Planners without an rhs leave its pages untouched.
    const std::uint64_t* rhs = page(EventKind::rhs, consistency_);
    const std::uint64_t* g = page(EventKind::g, rhs != nullptr);
    const int end = std::min(context_.right, x + static_cast<int>(kPage - node % kPage));
    std::size_t at = node % kPage;
    for (; x < end && (queue != nullptr || rhs != nullptr);
         x += step_, at += static_cast<std::size_t>(step_)) {
      if (queue != nullptr && queue[at] != 0) add_queued({x, y, context_.slice});
      if (rhs == nullptr) continue;
      const std::uint64_t here = g != nullptr ? g[at] : static_cast<std::uint64_t>(Cost::kInfinityRaw);
      if (here != rhs[at]) add_sign({x, y, context_.slice}, here > rhs[at]);
    }
    while (x < end) x += step_;
    return x;
  }

  void add_queued(Cell cell) {
    context_.scene.show(Sign::queue);
    add_mark(context_, cell, OutlineShape::corners, context_.palette.accent, 1, context_.pixels(1.6),
             context_.pixels(1));
  }

  void add_sign(Cell cell, bool over) {
    context_.scene.show(over ? Sign::over : Sign::under);
    add_mark(context_, cell, over ? OutlineShape::up : OutlineShape::down,
             over ? context_.palette.accent : context_.palette.warning, 1, context_.pixels(1.4), inset_);
  }

  SceneContext& context_;
  bool queue_, consistency_;
  int step_;
  float inset_;
};

}  // namespace

void build_outlines(SceneContext& context) {
  if (context.has(Overlay::repair)) add_repairs(context);
  StateMarks(context).add();
}

}  // namespace replan
