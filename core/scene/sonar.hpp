// How far the robot's sensor reaches and where it looks, as lines: what it cuts out of a slice, and all of it in space.
#pragma once

#include <vector>

#include "core/base/point.hpp"
#include "core/scene/context.hpp"
#include "core/sim/course.hpp"

namespace replan {

/// Which way the robot looks at the cursor, in the world's coordinates.
Course course_of_robot(const SceneContext& context);
/// Whether that is worth telling: a robot that sees all round and turns in no time looks where it goes next.
bool shows_course(const SceneContext& context);

/// A sensor at `at` that looks along `course` and reaches so many cells.
struct SonarReach {
  Point at;
  Course course;
  double radius = 0;
  double angle = 360;  ///< degrees, the whole opening angle
};

/// The outline of what it sees of the plane that lies `off` above it along z, closed; empty if it sees nothing of that.
std::vector<Point> outline_in_plane(const SonarReach& reach, double off);
/// A line from the robot's place to where it looks, longer than its mark is wide; without a course of no length.
std::vector<Point> nose_of(const Point& at, const Course& course);
/// The lines that show it in space: three rings if it looks all round, else its cone.
std::vector<std::vector<Point>> wires_of(const SonarReach& reach);

}  // namespace replan
