#include "core/scene/arcs.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "core/debug/event_words.hpp"
#include "core/drive/nearest_obstacle.hpp"
#include "core/scene/overlay.hpp"

namespace replan {
namespace {

class ArcPen {
 public:
  ArcPen(SceneContext& context, const DriveWhy& why)
      : context_(context), why_(why), colours_(why.explanation) {}

  /// From the worst to the best, so that these lie above.
  void draw() const {
    std::vector<const DriveSample*> order;
    for (const DriveSample& each : why_.explanation.samples)
      if (each.motion.v > 0) order.push_back(&each);
    std::stable_sort(order.begin(), order.end(), [](const DriveSample* a, const DriveSample* b) {
      return a->admissible() != b->admissible() ? !a->admissible() : a->score < b->score;
    });
    for (const DriveSample* each : order) draw(*each);
    const Palette& palette = context_.palette;
    if (const auto winner = why_.explanation.decision.winner)
      draw_strong(why_.explanation.samples[*winner], palette.accent, Sign::arc_chosen);
    for (const auto& motion : {context_.view.motion, context_.view.pointed_motion})
      if (motion) draw_strong(sample_of(why_, *motion), palette.text, Sign::arc_looked_at);
    if (context_.view.motion) draw_end(sample_of(why_, *context_.view.motion).end);
  }

 private:
  void draw(const DriveSample& sample) const {
    Polyline line = line_of(sample, colours_.of(sample, context_.palette), 1.2);
    context_.scene.show(sample.admissible() ? Sign::arc : Sign::arc_rejected);
    context_.add(std::move(line));
  }
  void draw_strong(const DriveSample& sample, Colour colour, Sign sign) const {
    Polyline line = line_of(sample, colour, 3);
    line.casing = context_.palette.outline;
    context_.scene.show(sign);
    context_.add(std::move(line));
  }
  /// The robot where the arc ends, and what is nearest to it there: the terms' distances.
  void draw_end(const Pose& end) const {
    const double radius = why_.settings.limits.radius;
    context_.add(Ring{place(end.spot()), radius / why_.frame.side, context_.palette.text,
                      context_.pixels(1.2), context_.pixels(3)});
    draw_nearest(why_.obstacles.known, end.spot(), "known", context_.palette.text);
    draw_nearest(why_.obstacles.unknown, end.spot(), "unknown", context_.palette.surprise);
  }
  /// A line from the robot's edge to the nearest obstacle, if that is within reach.
  void draw_nearest(const ObstacleSet& obstacles, Spot end, const char* what, Colour colour) const {
    const auto nearest = nearest_point(obstacles, end);
    const double radius = why_.settings.limits.radius, far = nearest ? distance(end, *nearest) : 0;
    if (!nearest || far - radius >= why_.settings.reach || far <= radius) return;
    const double part = radius / far;
    const Spot edge{end.x + (nearest->x - end.x) * part, end.y + (nearest->y - end.y) * part};
    context_.add(Line{place(edge), place(*nearest), colour, context_.pixels(1.6)});
    context_.add(Label{place(*nearest), nearest->y > end.y ? Anchor::upper_left : Anchor::lower_left, colour,
                       std::string(what) + ": " + decimal_text(far - radius, 2) + " m",
                       context_.palette.background});
  }
  [[nodiscard]] Point place(Spot spot) const {
    return {spot.x / why_.frame.side, spot.y / why_.frame.side, 0.5};
  }
  [[nodiscard]] Polyline line_of(const DriveSample& sample, Colour colour, double width) const {
    return {.points = arc_points(why_, sample),
            .colour = colour,
            .width = context_.pixels(width),
            .casing = 0,
            .dash = sample.admissible() ? 0 : context_.pixels(3)};
  }

  SceneContext& context_;
  const DriveWhy& why_;
  ArcColours colours_;
};

void draw_arcs(SceneContext& context) {
  const auto why = why_at_cursor(context.run);
  if (!why) return;
  ArcPen(context, *why).draw();
  const double radius = context.world(4);
  context.add(Ring{{why->goal.x / why->frame.side, why->goal.y / why->frame.side, 0.5},
                   radius,
                   context.palette.accent,
                   context.pixels(1.6)});
}

}  // namespace

OverlayKind overlay_arcs() {
  return {
      .info =
          {.label = "arcs",
           .help =
               "The arcs that a robot which drives tries before its next step: those with the best scores "
               "strongest, and those on which it could not stop in time dashed. A click on one tells why.",
           .at_first = true},
      .layer = Layer::routes,
      .draw = draw_arcs};
}

}  // namespace replan
