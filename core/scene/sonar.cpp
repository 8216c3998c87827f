#include "core/scene/sonar.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/scene/routes.hpp"
#include "core/world/choices.hpp"

namespace replan {
namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr int kRingPieces = 48;

Course scaled(const Course& a, double by) {
  return {a.x * by, a.y * by, a.z * by};
}

Course unit(const Course& a) {
  return scaled(a, 1 / std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z));
}

/// How far to either side of the axis's own direction in the plane a sensor sees at that distance from the foot of its
/// place: 0, nothing, to pi, all round.
double half_width(const SonarReach& reach, double off, double distance) {
  if (reach.course.none()) return kHalfTurn;  // as Cone has it
  const Course axis = unit(reach.course);
  const double flat = distance * std::hypot(axis.x, axis.y);
  const double needed = std::cos(reach.angle * kHalfTurn / 360) * std::hypot(distance, off) - off * axis.z;
  if (needed <= -flat) return kHalfTurn;
  return needed >= flat ? 0 : std::acos(needed / flat);
}

/// A part of the ring whose radii `a` and `b` are, at right angles: from one angle to another, counted from `a` towards `b`.
std::vector<Point> arc(const Point& centre, const Course& a, const Course& b, double from, double to) {
  std::vector<Point> points;
  for (int i = 0; i <= kRingPieces; ++i) {
    const double angle = from + (to - from) * i / kRingPieces;
    const double x = std::cos(angle), y = std::sin(angle);
    points.push_back(
        {centre.x + x * a.x + y * b.x, centre.y + x * a.y + y * b.y, centre.z + x * a.z + y * b.z});
  }
  return points;
}

/// Two directions of length 1 across an axis of that length, all three at right angles.
std::pair<Course, Course> across(const Course& axis) {
  const Course one = std::hypot(axis.x, axis.y) > 1e-9 ? unit({-axis.y, axis.x, 0}) : Course{1, 0, 0};
  return {
      one,
      {axis.y * one.z - axis.z * one.y, axis.z * one.x - axis.x * one.z, axis.x * one.y - axis.y * one.x}};
}

std::vector<std::vector<Point>> wires_of_cone(const SonarReach& reach) {
  constexpr int kEdges = 8;
  const Course axis = unit(reach.course);
  const auto [a, b] = across(axis);
  const double half = reach.angle * kHalfTurn / 360, radius = reach.radius;
  const double forwards = radius * std::cos(half), sideways = radius * std::sin(half);
  const Point middle{reach.at.x + forwards * axis.x, reach.at.y + forwards * axis.y,
                     reach.at.z + forwards * axis.z};
  std::vector<std::vector<Point>> wires = {
      arc(middle, scaled(a, sideways), scaled(b, sideways), 0, 2 * kHalfTurn),
      arc(reach.at, scaled(axis, radius), scaled(a, radius), -half, half),
      arc(reach.at, scaled(axis, radius), scaled(b, radius), -half, half)};
  const std::vector<Point> rim = wires.front();
  for (int i = 0; i < kEdges; ++i)
    wires.push_back({reach.at, rim[static_cast<std::size_t>(i * kRingPieces / kEdges)]});
  return wires;
}

}  // namespace

Course course_of_robot(const SceneContext& context) {
  if (const Decision* decision = context.run.decision_at(context.cursor)) return decision->course;
  const Scenario& scenario = context.run.scenario();
  return first_course(resolved(context.run.choice(), scenario.robot).robot, centre_of(scenario.start),
                      centre_of(scenario.goal));
}

bool shows_course(const SceneContext& context) {
  const Decision* decision = context.run.decision_at(context.cursor);
  return context.run.scenario().robot.sensor_angle < 360 ||
         (decision != nullptr && decision->figures.kept.has_value());
}

std::vector<Point> outline_in_plane(const SonarReach& reach, double off) {
  const double most = std::sqrt(std::max(0.0, reach.radius * reach.radius - off * off));
  const double middle = std::atan2(reach.course.y, reach.course.x);
  const auto place = [&](double distance, double angle) {
    return Point{reach.at.x + distance * std::cos(middle + angle),
                 reach.at.y + distance * std::sin(middle + angle), reach.at.z + off};
  };
  // One side of it outwards, the outer rim, and the other side back: distances at which it sees a part of the ring.
  std::vector<Point> one, rim, other;
  for (int i = 0; i <= 2 * kRingPieces && most > 0; ++i) {
    const double distance = most * i / (2 * kRingPieces), half = half_width(reach, off, distance);
    if (half <= 0) continue;
    rim.clear();
    for (int k = 0; k <= 2 * kRingPieces; ++k)
      rim.push_back(place(distance, half * (k - kRingPieces) / kRingPieces));
    if (half >= kHalfTurn) continue;
    one.push_back(place(distance, -half));
    other.push_back(place(distance, half));
  }
  one.insert(one.end(), rim.begin(), rim.end());
  one.insert(one.end(), other.rbegin(), other.rend());
  if (!one.empty()) one.push_back(one.front());
  return one;
}

std::vector<Point> nose_of(const Point& at, const Course& course) {
  constexpr double kLength = 1.5;  // cells
  if (course.none()) return {at, at};
  const Course nose = scaled(unit(course), kLength);
  return {at, {at.x + nose.x, at.y + nose.y, at.z + nose.z}};
}

std::vector<std::vector<Point>> wires_of(const SonarReach& reach) {
  if (reach.angle < 360 && !reach.course.none()) return wires_of_cone(reach);
  const double radius = reach.radius;
  const Course x{radius, 0, 0}, y{0, radius, 0}, z{0, 0, radius};
  return {arc(reach.at, x, y, 0, 2 * kHalfTurn), arc(reach.at, x, z, 0, 2 * kHalfTurn),
          arc(reach.at, y, z, 0, 2 * kHalfTurn)};
}

}  // namespace replan
