#include "core/sim/course.hpp"

#include <cmath>

#include "core/base/trigonometry.hpp"

namespace replan {
namespace {

double inner_product(const Course& a, const Course& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

double length_of(const Course& a) {
  return std::sqrt(inner_product(a, a));
}

}  // namespace

Course first_course(const RobotSetup& robot, const Point& at, const Point& goal) {
  const RobotInfo* info = find_robot(robot.kind);
  if (info == nullptr || info->heading.empty()) return course_towards(at, goal);
  // Headings of settings turn counter-clockwise, and y points down.
  const auto [sine, cosine] = sine_cosine(-robot.settings.get(info->heading, 0) * kPi / 180);
  return {cosine, sine, 0};
}

double angle_between(const Course& a, const Course& b) {
  const Course across{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  return arc_tangent(length_of(across), inner_product(a, b));
}

Cone::Cone(const Course& axis, double angle)
    : axis_(axis), length_(length_of(axis)), whole_(angle >= 360 || axis.none()) {
  if (!whole_) cosine_ = cosine(angle * kPi / 360);
}

bool Cone::holds(const Course& direction) const {
  if (whole_) return true;
  return inner_product(axis_, direction) >= (cosine_ - kSlack) * length_ * length_of(direction);
}

}  // namespace replan
