#include <algorithm>
#include <string>
#include <vector>

#include "core/debug/event_words.hpp"
#include "core/debug/in_hand.hpp"
#include "core/scene/overlay.hpp"

namespace replan {
namespace {

/// What a sum is made of: "1.4+28.7", or with the penalty as a third. On two lines where a cell has no room for it.
std::vector<std::string> sum_lines(const SceneContext& context, const Offer& offer) {
  std::string sum = cost_text(offer.step, 1) + "+" + cost_text(offer.g, 1);
  if (offer.dist <= Cost::zero()) return {sum};
  const std::string penalty = "+" + cost_text(offer.dist, 1);
  if (note_width(context, sum + penalty) <= 1) return {sum + penalty};
  return {sum, penalty};
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
    const double joined = context_.grown(10, 16), readable = context_.grown(48, 56);
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
      if (readable > 0) add_sum(trial, readable);
    }
  }

  /// At the lower edge of the cell; in the middle, where its corners have numbers.
  void add_sum(const Trial& trial, double strength) {
    const std::vector<std::string> lines = sum_lines(context_, trial.offer);
    const Point there = context_.centre(trial.offer.node);
    const Colour colour = faded(trial.taken ? colour_ : context_.palette.dim, strength);
    const double height = context_.world(15);
    const double foot = context_.scene.numbers == NumbersShown::four
                            ? there.y + height * static_cast<double>(lines.size()) / 2
                            : there.y + 0.5;
    for (std::size_t i = 0; i < lines.size(); ++i)
      add_note(context_,
               {there.x - note_width(context_, lines[i]) / 2,
                foot - height * static_cast<double>(lines.size() - 1 - i)},
               colour, lines[i]);
  }

  /// The cell of the value that was just written, with what it was and is.
  void add_written(const InHand::Write& write) {
    const Cell cell = cell_of(write.event.node);
    if (!context_.in_sight(cell)) return;
    context_.scene.show(Sign::written);
    const auto x = static_cast<double>(cell.x), y = static_cast<double>(cell.y);
    context_.add(Outline{x, y, 1, 1, OutlineShape::filled, faded(colour_, 0.25), 0, 0});
    mark_cell(context_, cell, OutlineShape::square, colour_, 1, context_.pixels(2), 0);
    const Field& field = context_.run.info().values.field(write.event.kind);
    const std::string words = value_name(field) + " " + value_text(context_.lattice, field, write.before) +
                              " → " + value_text(context_.lattice, field, write.after);
    add_note(context_, place_of_words(cell, words), colour_, words);
  }

  /// Above the cell, or below it at the upper edge of the view; never beyond its sides.
  [[nodiscard]] Point place_of_words(Cell cell, const std::string& words) const {
    const Camera& camera = context_.scene.camera;
    const double half_width = context_.scene.width / 2.0 / context_.zoom,
                 half_height = context_.scene.height / 2.0 / context_.zoom, gap = context_.world(10),
                 height = context_.world(15), width = note_width(context_, words);
    const double left = camera.x - half_width, right = camera.x + half_width - width;
    const bool above = cell.y - gap - height > camera.y - half_height;
    return {std::max(left, std::min<double>(cell.x, right)),
            above ? cell.y - gap : cell.y + 1 + gap + height};
  }

  /// A ring around u, with a rim so that it stands off any field.
  void add_vertex(NodeId node) {
    const Cell cell = cell_of(node);
    if (!context_.in_sight(cell)) return;
    context_.scene.show(Sign::in_hand);
    const Point at = SceneContext::centre(cell);
    const double side = context_.zoom / context_.view.scale;
    const double radius = context_.world(std::clamp(side / 2 + 1.5, 8.0, 24.0));
    context_.add(Ring{at, radius, context_.palette.outline, context_.pixels(5), 0});
    context_.add(Ring{at, radius, colour_, context_.pixels(2.6), 0});
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
          {.label = "step",
           .help =
               "What the search has in hand: a ring around the vertex that was taken from the open list, its "
               "neighbours with the sums c + g + dist that are tried, and the value that was just written.",
           .at_first = true},
      .layer = Layer::hand,
      .draw = draw_step};
}

}  // namespace replan
