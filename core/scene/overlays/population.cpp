// The paths of a planner that breeds them, and the child that it has in hand.
#include <algorithm>

#include "core/debug/child_in_hand.hpp"
#include "core/scene/overlay.hpp"
#include "core/scene/solid_pen.hpp"

namespace replan {
namespace {

/// A path of the population as it is drawn.
struct DrawnPath {
  BredPath places;
  double strength = 0;  ///< 0 for the least fit, 1 for the fittest
  bool leads = false;
};

/// All members, the least fit ones first, so that fitter ones lie on top.
std::vector<DrawnPath> members_drawn(const SearchState& state) {
  std::vector<std::uint32_t> members;
  for (std::uint32_t i = 0; i < path_count(state); ++i)
    if (i != path_named(state, Scalar::child)) members.push_back(i);
  std::stable_sort(members.begin(), members.end(), [&state](std::uint32_t a, std::uint32_t b) {
    return path_cost(state, b) < path_cost(state, a);
  });
  std::vector<DrawnPath> drawn;
  const std::uint32_t leader = path_named(state, Scalar::leader);
  for (std::size_t i = 0; i < members.size(); ++i)
    if (members[i] != leader)
      drawn.push_back({bred_path(state, members[i]),
                       static_cast<double>(i + 1) / static_cast<double>(members.size()), false});
  if (leader != kNoNode) drawn.push_back({bred_path(state, leader), 1, true});
  return drawn;
}

/// Calls draw(from, to, hits) for each straight way of a path.
template <class Draw>
void each_way(const Box& box, const BredPath& path, Draw&& draw) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    draw(centre_of(box.position(path[i].cell)), centre_of(box.position(path[i + 1].cell)),
         path[i].hit != kNoNode);
}

Colour member_colour(const Palette& palette, const DrawnPath& path, bool hits) {
  if (path.leads) return hits ? palette.bad : palette.path;
  return faded(hits ? palette.bad : palette.text,
               (hits ? 0.06 : 0.12) + 0.25 * path.strength * path.strength);
}

/// The child in hand on a slice.
class ChildMarks {
 public:
  ChildMarks(SceneContext& context, const ChildInHand& hand) : context_(context), hand_(hand) {}

  void add() {
    const Colour accent = context_.palette.accent;
    for (const ChildInHand::Parent* parent : {&hand_.mother, &hand_.father}) {
      if (parent->path.empty() || !hand_.path.empty()) continue;
      context_.scene.show(Sign::parents);
      add_path(parent->path, faded(accent, 0.8), 1.4, 5);
    }
    if (hand_.path.empty()) return;
    context_.scene.show(Sign::child);
    add_path(hand_.path, hand_.rejected ? context_.palette.dim : accent, 2.4, 0);
    add_crossing();
    add_change();
  }

 private:
  [[nodiscard]] Point seen(NodeId node) const {
    return context_.seen(centre_of(context_.run.lattice().position(node)));
  }
  void add_path(const BredPath& path, Colour colour, double width, double dash) {
    each_way(context_.run.lattice(), path, [&](const Point& from, const Point& to, bool hits) {
      if (hits) context_.scene.show(Sign::hits);
      const Point a = context_.seen(from), b = context_.seen(to);
      add_through_layers(
          context_,
          {{a, b}, hits ? context_.palette.bad : colour, context_.pixels(width), 0, context_.pixels(dash)});
    });
  }
  void add_crossing() {
    if (hand_.copied || hand_.crossed_at == kNoNode) return;
    context_.scene.show(Sign::parents);
    for (const ChildInHand::Parent* parent : {&hand_.mother, &hand_.father})
      add_path(parent->path, faded(context_.palette.accent, 0.45), 1, 5);
    context_.add(
        Ring{seen(hand_.crossed_at), context_.world(8), context_.palette.accent, context_.pixels(2)});
  }
  /// The cell that is replaced, and what the child would cost with each of its neighbours.
  void add_change() {
    if (hand_.changed_from == kNoNode) return;
    context_.scene.show(Sign::changed);
    const Palette& palette = context_.palette;
    const Point from = seen(hand_.changed_from);
    context_.add(Outline{std::floor(from.x), std::floor(from.y), 1, 1, OutlineShape::square, palette.accent,
                         context_.pixels(1.6), 0});
    for (const ChildInHand::Tried& tried : hand_.tried) {
      const bool taken = tried.cell == hand_.changed_to;
      const Cell cell = context_.seen(context_.run.lattice().position(tried.cell));
      if (context_.in_sight(cell))
        context_.notes.push_back({cell,
                                  {context_.view.lengths.text(tried.unfitness.cost, 1)},
                                  taken                  ? palette.accent
                                  : tried.unfitness.hits ? palette.bad
                                                         : palette.dim,
                                  true});
    }
    if (hand_.changed_to != kNoNode)
      context_.add(
          Arrow{from, seen(hand_.changed_to), palette.accent, context_.pixels(2), context_.pixels(5)});
  }

  SceneContext& context_;
  const ChildInHand& hand_;
};

void draw_population(SceneContext& context) {
  if (!context.run.info().evolving) return;
  for (const DrawnPath& path : members_drawn(context.state)) {
    context.scene.show(path.leads ? Sign::leader : Sign::population);
    each_way(context.run.lattice(), path.places, [&](const Point& from, const Point& to, bool hits) {
      if (hits) context.scene.show(Sign::hits);
      const Point a = context.seen(from), b = context.seen(to);
      const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
      context.add(Line{a, b, context.seen_at(middle, member_colour(context.palette, path, hits)),
                       context.pixels(path.leads ? 3 : 1)});
    });
  }
  if (const auto hand = child_in_hand(context.run.log_view())) ChildMarks(context, *hand).add();
}

void population_in_space(SolidPen& pen) {
  const Run& run = pen.context().run;
  if (!run.info().evolving) return;
  for (const DrawnPath& path : members_drawn(pen.state())) {
    pen.show(path.leads ? Sign::leader : Sign::population);
    each_way(run.lattice(), path.places, [&](const Point& from, const Point& to, bool hits) {
      if (hits) pen.show(Sign::hits);
      pen.line(from, to, member_colour(pen.palette(), path, hits), path.leads ? 3.0f : 1.0f);
    });
  }
  if (const auto hand = child_in_hand(run.log_view()); hand && !hand->path.empty()) {
    pen.show(Sign::child);
    each_way(run.lattice(), hand->path, [&](const Point& from, const Point& to, bool hits) {
      pen.line(from, to, hits ? pen.palette().bad : pen.palette().accent, 2.4f);
    });
  }
}

}  // namespace

OverlayKind overlay_population() {
  return {
      .info = {.label = "population",
               .help =
                   "The paths of a planner that breeds them, the fitter the stronger, and where they hit "
                   "something; the child in hand with its parents, and what each neighbour of the cell that "
                   "changes would make of it.",
               .at_first = true},
      .layer = Layer::lines,
      .draw = draw_population,
      .draw_in_space = population_in_space};
}

}  // namespace replan
