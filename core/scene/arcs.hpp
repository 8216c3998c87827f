// The arcs that a driving robot tries: how they are coloured, wherever they are shown, and which one is at a place.
#pragma once

#include <optional>

#include "core/robots/drive_sense.hpp"
#include "core/scene/scene.hpp"

namespace replan {

/// Whether a search is under way at the cursor.
bool plans_at_cursor(const Run& run);
/// What a run's robot has decided at the cursor, with its reasons; nothing where it does not drive, or could not decide
/// there, or plans.
std::optional<DriveWhy> why_at_cursor(const Run& run);

/// The colours of the samples of one decision.
class ArcColours {
 public:
  explicit ArcColours(const Explanation& why);
  /// Where a score lies between the worst and the best ones, 0 to 1.
  [[nodiscard]] double share(double score) const;
  /// Translucent. What is rejected is outside of the scale.
  [[nodiscard]] Colour of(const DriveSample& sample, const Palette& palette) const;

 private:
  double low_ = 0, high_ = 0;
};

/// In cells, from the robot to where the sample ends.
std::vector<Point> arc_points(const DriveWhy& why, const DriveSample& sample);

/// The motion whose arc lies at a place of the world, at most `reach` cells away; nothing where arcs are not shown. Of
/// arcs that lie on one another the one that ends nearest.
std::optional<Twist> arc_at(const Run& run, const View& view, Point place, double reach);

}  // namespace replan
