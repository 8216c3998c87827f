#include <algorithm>
#include <vector>

#include "core/robots/drive_sense.hpp"
#include "core/scene/overlay.hpp"

namespace replan {
namespace {

/// The scores that the colours reach over: the worst and the best few of them would make all others look alike.
struct ScoreRange {
  explicit ScoreRange(const std::vector<DriveSample>& samples) {
    std::vector<double> scores;
    for (const DriveSample& each : samples)
      if (each.admissible()) scores.push_back(each.score);
    if (scores.empty()) return;
    std::sort(scores.begin(), scores.end());
    low = scores[scores.size() / 20];
    high = scores[scores.size() - 1 - scores.size() / 20];
  }
  [[nodiscard]] double share(double score) const {
    return high > low ? std::clamp((score - low) / (high - low), 0.0, 1.0) : 1;
  }
  double low = 0, high = 0;
};

class ArcPen {
 public:
  ArcPen(SceneContext& context, const DriveWhy& why)
      : context_(context), why_(why), range_(why.explanation.samples) {}

  /// From the worst to the best, so that these lie above.
  void draw() const {
    std::vector<const DriveSample*> order;
    for (const DriveSample& each : why_.explanation.samples)
      if (each.motion.v > 0) order.push_back(&each);
    std::stable_sort(order.begin(), order.end(), [](const DriveSample* a, const DriveSample* b) {
      return a->admissible() != b->admissible() ? !a->admissible() : a->score < b->score;
    });
    for (const DriveSample* each : order) draw(*each);
    if (const auto winner = why_.explanation.decision.winner) draw_winner(why_.explanation.samples[*winner]);
  }

 private:
  [[nodiscard]] Polyline arc(const DriveSample& sample) const {
    constexpr int kPieces = 12;
    Polyline line;
    const Arc arc(why_.state.pose, sample.motion);
    for (int i = 0; i <= kPieces; ++i) {
      const Spot at = arc.spot(sample.time * i / kPieces);
      line.points.push_back({at.x / why_.frame.side, at.y / why_.frame.side, 0.5});
    }
    return line;
  }
  void draw(const DriveSample& sample) const {
    Polyline line = arc(sample);
    const Palette& palette = context_.palette;
    if (sample.admissible()) {
      const auto share = static_cast<float>(range_.share(sample.score));
      line.colour = faded(mix(palette.dim, palette.accent, share), 0.25 + 0.5 * static_cast<double>(share));
    } else {
      line.colour = faded(palette.bad, 0.45);
      line.dash = context_.pixels(3);
    }
    line.width = context_.pixels(1.2);
    context_.scene.show(sample.admissible() ? Sign::arc : Sign::arc_rejected);
    context_.add(std::move(line));
  }
  void draw_winner(const DriveSample& sample) const {
    Polyline line = arc(sample);
    line.colour = context_.palette.accent;
    line.casing = context_.palette.outline;
    line.width = context_.pixels(3);
    context_.scene.show(Sign::arc_chosen);
    context_.add(std::move(line));
  }

  SceneContext& context_;
  const DriveWhy& why_;
  ScoreRange range_;
};

void draw_arcs(SceneContext& context) {
  const Decision* decision = context.run.decision_at(context.cursor);
  if (decision == nullptr || decision->state != MissionState::driving) return;
  const auto why = why_it_drives(context.run.scenario(), context.run.choice(), *decision, context.state);
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
               "strongest, and those on which it could not stop in time dashed.",
           .at_first = true},
      .layer = Layer::routes,
      .draw = draw_arcs};
}

}  // namespace replan
