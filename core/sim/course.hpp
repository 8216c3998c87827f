// Which way a robot looks, and what lies in the cone that its sensor sees from there.
#pragma once

#include "core/base/point.hpp"
#include "core/world/robot.hpp"

namespace replan {

/// A direction of any length: x to the right, y downwards, z upwards, as cells count. All zero: none.
struct Course {
  double x = 0, y = 0, z = 0;
  [[nodiscard]] bool none() const { return x == 0 && y == 0 && z == 0; }
  friend bool operator==(const Course&, const Course&) = default;
};

constexpr Course course_towards(const Point& from, const Point& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

/// Which way a robot looks before it has moved: as its kind's setting says (RobotInfo::heading), else towards its goal.
Course first_course(const RobotSetup& robot, const Point& at, const Point& goal);

/// The angle between two directions in radians, from 0 to pi; 0 if one of them is none. The same on every machine.
double angle_between(const Course& a, const Course& b);

/// All directions that are at most half an opening angle away from an axis: a sector in the plane, a cone in space, and
/// beyond 180 degrees what such a cone behind the robot leaves over.
class Cone {
 public:
  /// `angle` is the whole opening angle in degrees; from 360 on, or where the axis is none, the cone holds everything.
  Cone(const Course& axis, double angle);

  /// Whether it holds a direction. One on the rim is inside: the comparison gives way by kSlack, far less than what two
  /// directions between cells can differ by, so that no rounding decides about it.
  [[nodiscard]] bool holds(const Course& direction) const;
  static constexpr double kSlack = 1e-12;  ///< of the angle's cosine

 private:
  Course axis_;
  double length_ = 0;   // of the axis
  double cosine_ = -1;  // of half the opening angle
  bool whole_ = true;
};

}  // namespace replan
