#include <algorithm>
#include <string>
#include <vector>

#include "core/debug/event_words.hpp"
#include "core/debug/in_hand.hpp"
#include "core/scene/numbers.hpp"
#include "core/scene/overlay.hpp"

namespace replan {
namespace {

/// From so many design pixels a cell on the sums of its neighbours can be read.
constexpr double kSumsFrom = 52;

/// What a sum is made of: "1.4+28.7", or with the penalty as a third. On two lines where a cell has no room for it.
std::vector<std::string> sum_lines(const SceneContext& context, const Offer& offer) {
  std::string sum = cost_text(offer.step, 1) + "+" + cost_text(offer.g, 1);
  if (offer.dist <= Cost::zero()) return {sum};
  const std::string penalty = "+" + cost_text(offer.dist, 1);
  if (words_width(context, sum + penalty) + context.world(8) <= 1) return {sum + penalty};
  return {sum, penalty};
}

/// "rhs: ∞ → 2.8", "key: none → 6.0": with as many decimals as it takes to see that something has changed.
std::string written_words(const Box& lattice, const Field& field, const InHand::Write& write) {
  const auto change = [&](const std::string& from, const std::string& to) { return from + " → " + to; };
  const bool key = field.type == FieldType::queue;
  const auto cost = [key](std::uint64_t raw, int decimals) {
    if (key && raw == 0) return std::string("none");
    return cost_text(Cost{static_cast<std::int64_t>(raw) - (key ? 1 : 0)}, decimals);
  };
  const std::string name = key ? "key" : value_name(field);
  if (!key && field.type != FieldType::cost)
    return name + ": " +
           change(value_text(lattice, field, write.before), value_text(lattice, field, write.after));
  const bool coarse = cost(write.before, 1) != cost(write.after, 1);
  return name + ": " + change(cost(write.before, coarse ? 1 : 3), cost(write.after, coarse ? 1 : 3));
}

/// What the search has in hand, all in the colour of the line of code that is lit.
class StepMarks {
 public:
  explicit StepMarks(SceneContext& context)
      : context_(context), colour_(context.palette.accent), hand_(in_hand(context.run.log_view())) {}

  void add() {
    for (const NodeId node : hand_.touched)
      if (const Cell cell = context_.lattice.position(node); context_.in_sight(cell))
        mark_cell(context_, cell, OutlineShape::square, colour_, 0.5, context_.pixels(1.2),
                  context_.pixels(1));
    add_trials();
    if (hand_.written) add_written(*hand_.written);
    if (hand_.vertex) add_vertex(*hand_.vertex);
  }

 private:
  [[nodiscard]] Cell cell_of(NodeId node) const { return context_.lattice.position(node); }

  /// The neighbours that are tried, joined to the vertex that tries them; near enough each with its sum.
  void add_trials() {
    const double joined = context_.grown(10, 16);
    const bool readable = context_.zoom >= kSumsFrom * context_.view.scale;
    if (hand_.trials.empty() || joined <= 0 || cell_of(hand_.centre).z != context_.slice) return;
    context_.scene.show(Sign::tried);
    const Point centre = context_.centre(hand_.centre);
    for (const Trial& trial : hand_.trials) {
      if (!context_.in_sight(cell_of(trial.offer.node))) continue;
      const double strength = trial.taken ? 1 : 0.45;
      const Point there = context_.centre(trial.offer.node);
      const auto on_the_way = [&](double share) {
        return Point{centre.x + (there.x - centre.x) * share, centre.y + (there.y - centre.y) * share,
                     centre.z};
      };
      // Between the middles of the cells, which have signs of their own.
      context_.add(Line{on_the_way(0.3), on_the_way(0.7), faded(colour_, joined * strength),
                        context_.pixels(trial.taken ? 2 : 1)});
      if (readable)
        context_.notes.push_back({cell_of(trial.offer.node), sum_lines(context_, trial.offer),
                                  trial.taken ? colour_ : context_.palette.dim, true});
    }
  }

  /// The cell of the value that was just written, with what it was and is.
  void add_written(const InHand::Write& write) {
    const Cell cell = cell_of(write.event.node);
    if (!context_.in_sight(cell)) return;
    context_.scene.show(Sign::written);
    const auto x = static_cast<double>(cell.x), y = static_cast<double>(cell.y);
    context_.add(Outline{x, y, 1, 1, OutlineShape::filled, faded(colour_, SceneContext::kTint), 0, 0});
    context_.written = cell;
    mark_cell(context_, cell, OutlineShape::square, colour_, 1, context_.pixels(2), 0);
    const Field& field = context_.run.info().values.field(write.event.kind);
    context_.notes.push_back({cell, {written_words(context_.run.lattice(), field, write)}, colour_});
  }

  /// A ring around u, with a rim so that it stands off any field.
  void add_vertex(NodeId node) {
    const Cell cell = cell_of(node);
    if (!context_.in_sight(cell)) return;
    context_.scene.show(Sign::in_hand);
    const Point at = SceneContext::centre(cell);
    const double side = context_.zoom / context_.view.scale;
    const double radius = context_.world(std::clamp(side / 2 + 1.5, 8.0, room_for_ring(side)));
    context_.add(Ring{at, radius, context_.palette.outline, context_.pixels(5), 0});
    context_.add(Ring{at, radius, colour_, context_.pixels(2.6), 0});
  }

  /// In design pixels: between the numbers of a cell that is so large.
  [[nodiscard]] double room_for_ring(double side) const {
    const NumberLayout layout(context_);
    if (layout.waiting == NumbersShown::none || layout.close) return 24;
    if (layout.waiting == NumbersShown::four) return std::min(side / 2 - 17, 24.0);
    return std::max(8.0, layout.apart * side - 6);
  }

  SceneContext& context_;
  Colour colour_;
  InHand hand_;
};

void draw_step(SceneContext& context) {
  StepMarks(context).add();
}

}  // namespace

OverlayKind overlay_step() {
  return {
      .info =
          {.label = "step in hand",
           .help =
               "What the search has in hand: a ring around the vertex that was taken from the open list, its "
               "neighbours with the sums c + g + dist that are tried, and the value that was just written.",
           .at_first = true},
      .layer = Layer::hand,
      .draw = draw_step};
}

}  // namespace replan
