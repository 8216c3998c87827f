// The tree of a planner that samples, and what it has in hand.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/debug/cost_words.hpp"
#include "core/debug/sample_in_hand.hpp"
#include "core/scene/overlay.hpp"
#include "core/scene/solid_pen.hpp"
#include "core/scene/tree_edges.hpp"
#include "core/space/informed_set.hpp"

namespace replan {
namespace {

/// Whether an edge between two points may show on the slice; of one that passes a corner it says so too.
bool may_be_seen(const SceneContext& context, const Point& a, const Point& b) {
  const Point from = context.seen(a), to = context.seen(b);
  return std::max(from.x, to.x) >= context.left && std::min(from.x, to.x) <= context.right &&
         std::max(from.y, to.y) >= context.top && std::min(from.y, to.y) <= context.bottom;
}

bool sees_all(const SceneContext& context) {
  return context.left <= 0 && context.top <= 0 && context.right >= context.lattice.width() &&
         context.bottom >= context.lattice.height();
}

/// How strongly edges are drawn: the fainter the more of the ground they would cover, so that a dense tree is a ground for
/// the path and does not hide it.
double strength_of(const SceneContext& context, const DrawnTree& tree) {
  constexpr double kFull = 0.12, kLeast = 0.3;  // the share of the ground at which they are drawn fully
  double length = 0;
  for (const TreeEdge& edge : tree.edges) {
    const Point from = context.seen(edge.from), to = context.seen(edge.to);
    length += std::hypot(to.x - from.x, to.y - from.y);
  }
  const double ground = static_cast<double>(context.right - context.left) * (context.bottom - context.top);
  const double covered = ground > 0 ? length * context.world(1) / ground : 0;
  return covered > kFull ? std::max(kFull / covered, kLeast) : 1;
}

Colour colour_of(const Palette& palette, const TreeEdge& edge) {
  const auto shade = static_cast<std::size_t>(std::lround(std::clamp(edge.cost, 0.0, 1.0) * 255));
  return edge.from_goal ? palette.goal : mix(palette.field[shade] | 0xFF000000u, palette.text, 0.15f);
}

/// The rim of the informed set on the plane through its first two axes.
std::vector<Point> informed_rim(const Run& run, const SearchState& state) {
  const NodeId start = state.node(Scalar::start), goal = state.node(Scalar::goal);
  if (!run.info().informed || state.scalar(Scalar::goal_vertex) == 0 || start == goal) return {};
  const Box& box = run.lattice();
  const InformedSet<3> set(place_in(box.position(start)), place_in(box.position(goal)),
                           {static_cast<std::int64_t>(state.scalar(Scalar::best))});
  constexpr int kPieces = 96;
  std::vector<Point> rim;
  for (int i = 0; i <= kPieces; ++i) {
    const double angle = 2 * 3.141592653589793 * i / kPieces;
    const double along = set.along() * std::cos(angle), across = set.across() * std::sin(angle);
    const auto part = [&](std::size_t k) {
      return (set.centre()[k] + along * set.axis(0)[k] + across * set.upright(box.solid())[k]) /
             static_cast<double>(kPlaceUnits);
    };
    rim.push_back({part(0), part(1), part(2)});
  }
  return rim;
}

/// Where the words about the informed set stand: beside a place of its rim that is in sight.
std::optional<Cell> cell_for_words(const SceneContext& context, const std::vector<Point>& rim) {
  for (const std::size_t eighths : {6u, 2u, 5u, 7u, 1u, 3u, 0u, 4u}) {
    const Cell cell = cell_of(rim[eighths * (rim.size() - 1) / 8]);
    if (context.in_sight(cell)) return cell;
  }
  return std::nullopt;
}

void draw_informed(SceneContext& context) {
  std::vector<Point> rim = informed_rim(context.run, context.state);
  if (rim.empty()) return;
  context.scene.show(Sign::informed);
  for (Point& point : rim) point = context.seen(point);
  if (const auto cell = cell_for_words(context, rim)) {
    const Cost best{static_cast<std::int64_t>(context.state.scalar(Scalar::best))};
    const auto place = [&](Scalar which) {
      return place_in(context.run.lattice().position(context.state.node(which)));
    };
    const Cost least = length_between(place(Scalar::start), place(Scalar::goal));
    context.notes.push_back(
        {*cell,
         {"c_best " + context.view.lengths.text(best, 1), "c_min " + context.view.lengths.text(least, 1)},
         context.palette.warning});
  }
  context.add(Polyline{std::move(rim), context.palette.warning, context.pixels(1.4), 0, context.pixels(4)});
}

void draw_first_path(SceneContext& context) {
  FirstPath& first = context.memory.first_path;
  first.follow(context.run, context.memory.digest);
  if (first.points().empty()) return;
  context.scene.show(Sign::first_path);
  std::vector<Point> points = first.points();
  for (Point& point : points) point = context.seen(point);
  add_through_layers(context, {std::move(points), faded(context.palette.path, 0.7), context.pixels(1.4), 0,
                               context.pixels(5)});
}

/// The vertex nearest to the cell that is pinned, or pointed at, and the way to it.
void draw_asked_vertex(SceneContext& context) {
  const auto& asked = context.view.pinned ? context.view.pinned : context.view.hovered;
  if (!asked) return;
  const bool solid = context.run.lattice().solid();
  const std::uint32_t vertex =
      context.memory.nearest_vertex.follow(context.run.log_view(), context.run.log_id(), *asked);
  if (vertex == kNoNode) return;
  std::vector<Point> way = way_in_tree(context.state, vertex, solid);
  for (Point& point : way) point = context.seen(point);
  const Point at = way.front();
  context.scene.show(Sign::way_to_vertex);
  add_through_layers(context, {std::move(way), context.palette.accent, context.pixels(1.8), 0});
  context.add(Ring{at, context.world(6), context.palette.outline, context.pixels(3.5)});
  context.add(Ring{at, context.world(6), context.palette.accent, context.pixels(1.8)});
  if (at.z >= context.slice && at.z < context.slice + 1)
    context.notes.push_back({cell_of(at),
                             {"vertex " + std::to_string(vertex),
                              "cost " + context.view.lengths.text(vertex_cost(context.state, vertex), 1)},
                             context.palette.text});
}

/// Why a sample comes to nothing, in a word or two.
const char* fault_word(SampleFault why) {
  switch (why) {
    case SampleFault::blocked:
      return "blocked";
    case SampleFault::taken:
      return "a vertex already";
    case SampleFault::longer:
      return "no shorter";
    case SampleFault::path_end:
    case SampleFault::twin:  // these two are of children, and no tree has any
    case SampleFault::unfit:
      break;
  }
  return "an end of the path";
}

/// The sample in hand on a slice.
class SampleMarks {
 public:
  SampleMarks(SceneContext& context, const SampleInHand& hand)
      : context_(context), hand_(hand), solid_(context.run.lattice().solid()) {}

  void add() {
    if (!hand_.sample) return;
    add_ball();
    add_candidates();
    const Point sample = seen(*hand_.sample);
    const Palette& palette = context_.palette;
    const Colour colour = hand_.rejected ? palette.bad : palette.accent;
    if (hand_.nearest && hand_.place) {
      const Point from = vertex(*hand_.nearest), to = seen(*hand_.place);
      context_.add(Line{from, to, colour, context_.pixels(1.6)});
      add_through_layers(context_,
                         {{to, sample}, faded(colour, 0.6), context_.pixels(1), 0, context_.pixels(3)});
    }
    context_.scene.show(hand_.rejected ? Sign::rejected : Sign::sample);
    const double arm = context_.world(5);
    for (const double side : {-arm, arm})
      context_.add(Line{{sample.x - arm, sample.y - side, sample.z},
                        {sample.x + arm, sample.y + side, sample.z},
                        colour,
                        context_.pixels(2)});
    if (hand_.rejected && sample.z >= context_.slice && sample.z < context_.slice + 1)
      context_.notes.push_back({cell_of(sample), {fault_word(*hand_.rejected)}, colour});
    if (hand_.added)
      context_.add(Disc{vertex(*hand_.added), context_.pixels(4), palette.accent, palette.outline, 1});
    add_rewired();
  }

 private:
  [[nodiscard]] Point seen(const Place& place) const { return context_.seen(point_of(place)); }
  [[nodiscard]] Point vertex(std::uint32_t v) const { return seen(vertex_place(context_.state, v, solid_)); }

  void add_ball() {
    if (!hand_.ball || !hand_.place) return;
    const Point centre = seen(*hand_.place);
    const double radius = context_.cut_radius(centre, *hand_.ball);
    if (radius <= 0) return;
    context_.scene.show(Sign::ball);
    context_.add(
        Ring{centre, radius, faded(context_.palette.accent, 0.8), context_.pixels(1.2), context_.pixels(3)});
  }
  /// The vertices that the new place could hang on; near enough each with its sum.
  void add_candidates() {
    if (hand_.candidates.empty() || !hand_.place) return;
    context_.scene.show(Sign::tried);
    const auto least = std::min_element(hand_.candidates.begin(), hand_.candidates.end(),
                                        [](const auto& a, const auto& b) { return a.cost < b.cost; });
    const bool few = hand_.candidates.size() <= 12;
    for (const SampleInHand::Candidate& candidate : hand_.candidates) {
      const bool wins = candidate.vertex == least->vertex;
      const Point at = vertex(candidate.vertex);
      const Colour colour = candidate.cost.is_infinite() ? context_.palette.bad : context_.palette.accent;
      context_.add(
          Line{at, seen(*hand_.place), faded(colour, wins ? 1 : 0.4), context_.pixels(wins ? 2.4 : 1)});
      if (few && at.z >= context_.slice && at.z < context_.slice + 1)
        context_.notes.push_back({cell_of(at),
                                  {context_.view.lengths.text(candidate.cost, 1)},
                                  wins ? colour : context_.palette.dim});
    }
  }
  void add_rewired() {
    for (const SampleInHand::Rewired& rewired : hand_.rewired) {
      context_.scene.show(Sign::rewired);
      const Point at = vertex(rewired.vertex);
      if (hand_.added)
        context_.add(Line{vertex(*hand_.added), at, context_.palette.good, context_.pixels(2.4)});
      if (at.z >= context_.slice && at.z < context_.slice + 1)
        context_.notes.push_back(
            {cell_of(at), {saving_text(context_.view.lengths, rewired.saves)}, context_.palette.good});
    }
  }

  SceneContext& context_;
  const SampleInHand& hand_;
  bool solid_;
};

void draw_tree(SceneContext& context) {
  if (!context.run.info().sampling) return;
  const auto hand = sample_in_hand(context.run.log_view());
  const DrawnTree tree =
      drawn_tree(context.run, sees_all(context) ? nullptr : &context.memory.edges,
                 [&context](const Point& from, const Point& to) { return may_be_seen(context, from, to); });
  context.scene.every_edge = tree.every;
  // What is pulled straight is the path: the tree stands back.
  const double strength = std::min(hand && hand->pulls ? 0.35 : 1, strength_of(context, tree));
  const float width = context.pixels(1);
  for (const TreeEdge& edge : tree.edges) {
    context.scene.show(edge.from_goal ? Sign::goal_tree : Sign::tree);
    const Point from = context.seen(edge.from), to = context.seen(edge.to);
    const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2, (from.z + to.z) / 2};
    const Colour colour = faded(colour_of(context.palette, edge), strength);
    context.add(Line{from, to, context.seen_at(middle, colour), width});
  }
  draw_informed(context);
  draw_first_path(context);
  draw_asked_vertex(context);
  if (hand) SampleMarks(context, *hand).add();
}

void tree_in_space(SolidPen& pen) {
  const Run& run = pen.context().run;
  if (!run.info().sampling) return;
  const DrawnTree tree = drawn_tree(run, nullptr, [](const Point&, const Point&) { return true; });
  pen.draws_every_edge(tree.every);
  for (const TreeEdge& edge : tree.edges) {
    pen.show(edge.from_goal ? Sign::goal_tree : Sign::tree);
    pen.line(edge.from, edge.to, colour_of(pen.palette(), edge), 1);
  }
  if (const std::vector<Point> rim = informed_rim(run, pen.state()); !rim.empty()) {
    pen.show(Sign::informed);
    pen.polyline(rim, pen.palette().warning, 1.4f);
  }
}

}  // namespace

OverlayKind overlay_tree() {
  return {
      .info =
          {.label = "tree",
           .help =
               "The tree of a planner that samples, by the cost of its vertices; the sample in hand with the "
               "vertices that it could hang on and what rewiring saved; and, of an informed planner, the "
               "ellipse "
               "that a shorter path cannot leave.",
           .at_first = true},
      .layer = Layer::lines,
      .draw = draw_tree,
      .draw_in_space = tree_in_space};
}

}  // namespace replan
