#include "core/scene/arcs.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace replan {
namespace {

double apart(Point a, Point b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

/// How far a place is from a stretch of a line.
double from_stretch(Point place, Point a, Point b) {
  const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
  const double along = square > 0 ? ((place.x - a.x) * x + (place.y - a.y) * y) / square : 0;
  const double part = std::clamp(along, 0.0, 1.0);
  return apart(place, {a.x + part * x, a.y + part * y});
}

double from_line(Point place, const std::vector<Point>& line) {
  double least = apart(place, line.front());
  for (std::size_t i = 1; i < line.size(); ++i)
    least = std::min(least, from_stretch(place, line[i - 1], line[i]));
  return least;
}

}  // namespace

bool plans_at_cursor(const Run& run) {
  const auto all = run.milestones();
  const std::size_t cursor = run.timeline().cursor();
  auto at = std::partition_point(all.begin(), all.end(),
                                 [cursor](const Milestone& each) { return each.event < cursor; });
  while (at != all.begin()) {
    --at;
    if (at->kind == EventKind::plan_begin) return true;
    if (at->kind == EventKind::plan_end) return false;
  }
  return false;
}

std::optional<DriveWhy> why_at_cursor(const Run& run) {
  if (plans_at_cursor(run)) return std::nullopt;
  const Decision* decision = run.decision_at(run.timeline().cursor());
  if (decision == nullptr || decision->state != MissionState::driving) return std::nullopt;
  const auto why = why_it_drives(run.scenario(), run.choice(), *decision, run.timeline().state());
  return why && !why->strayed ? why : std::nullopt;
}

/// The worst and the best few scores would make all others look alike.
ArcColours::ArcColours(const Explanation& why) {
  std::vector<double> scores;
  for (const DriveSample& each : why.samples)
    if (each.admissible()) scores.push_back(each.score);
  if (scores.empty()) return;
  std::sort(scores.begin(), scores.end());
  low_ = scores[scores.size() / 20];
  high_ = scores[scores.size() - 1 - scores.size() / 20];
}

double ArcColours::share(double score) const {
  return high_ > low_ ? std::clamp((score - low_) / (high_ - low_), 0.0, 1.0) : 1;
}

Colour ArcColours::of(const DriveSample& sample, const Palette& palette) const {
  if (!sample.admissible()) return faded(palette.bad, 0.45);
  const double part = share(sample.score);
  return faded(mix(palette.dim, palette.accent, static_cast<float>(part)), 0.25 + 0.5 * part);
}

std::vector<Point> arc_points(const DriveWhy& why, const DriveSample& sample) {
  constexpr int kPieces = 12;
  const Arc arc(why.state.pose, sample.motion);
  std::vector<Point> points;
  for (int i = 0; i <= kPieces; ++i) {
    const Spot at = arc.spot(sample.time * i / kPieces);
    points.push_back({at.x / why.frame.side, at.y / why.frame.side, 0.5});
  }
  return points;
}

std::optional<Twist> arc_at(const Run& run, const View& view, Point place, double reach) {
  if (!view.overlays.has(Overlay::arcs)) return std::nullopt;
  const auto why = why_at_cursor(run);
  if (!why) return std::nullopt;
  const double same = reach / 4;  // so little apart they look like one line
  std::optional<Twist> found;
  double least = 0, least_end = 0;
  for (const DriveSample& each : why->explanation.samples) {
    if (each.motion.v <= 0) continue;
    const std::vector<Point> line = arc_points(*why, each);
    const double far = std::max(from_line(place, line), same), end = apart(place, line.back());
    if (far > reach || (found && (far > least || (far == least && end >= least_end)))) continue;
    found = each.motion;
    least = far;
    least_end = end;
  }
  return found;
}

}  // namespace replan
